// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/find_entries.h"

#include "effects/effect.h"
#include "words/core_words.h"

namespace handsight::app {

std::vector<FindEntry> session_entries(Workbench& bench) {
  std::vector<FindEntry> entries;
  if (!bench.document.is_open()) return entries;
  const Session& session = bench.document.session();
  for (const std::string& joint : session.joints)
    entries.push_back({QObject::tr("joint"), QString::fromStdString(joint), {}, [&bench, joint] {
                         Selected s = bench.selection.current();
                         s.joint = joint;
                         bench.selection.select(s);
                       }});
  for (const Effect& effect : catalogue())
    entries.push_back({QObject::tr("effect"), translated(effect.title), QString::fromStdString(effect.id),
                       [&bench, check = effect.check] {
                         emit bench.workspace_requested(Place::explain);
                         emit bench.document.noticed(translated(check));
                       }});
  for (const Observation& o : session.observations) {
    const InspectionRow* row = bench.row(o.id);
    const QString hint = !o.reason.empty() ? QString::fromStdString(o.reason)
                         : row && row->rms ? bench.units.text(size_of(*row))
                                           : QString();
    entries.push_back({QObject::tr("observation"), QObject::tr("observation %1").arg(o.id), hint,
                       [&bench, id = o.id] { bench.selection.select_observation(id); }});
  }
  return entries;
}

}  // namespace handsight::app
