// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/find_entries.h"

#include "effects/effect.h"
#include "words/core_words.h"

namespace handsight::app {

std::vector<FindEntry> session_entries(Workbench& workbench) {
  std::vector<FindEntry> entries;
  if (!workbench.document.is_open()) return entries;
  const Session& session = workbench.document.session();
  for (const std::string& joint : session.joints)
    entries.push_back({QObject::tr("joint"), QString::fromStdString(joint), {}, [&workbench, joint] {
                         Selected s = workbench.selection.current();
                         s.joint = joint;
                         workbench.selection.select(s);
                       }});
  for (const Effect& effect : catalogue())
    entries.push_back({QObject::tr("effect"), translated(effect.title), QString::fromStdString(effect.id),
                       [&workbench, check = effect.check] {
                         emit workbench.workspace_requested(Place::explain);
                         emit workbench.document.noticed(translated(check));
                       }});
  for (const Observation& o : session.observations) {
    const InspectionRow* row = workbench.row(o.id);
    const QString hint = !o.reason.empty() ? translated(o.reason)
                         : row && row->rms ? workbench.units.text(measure_size(*row))
                                           : QString();
    entries.push_back({QObject::tr("observation"), QObject::tr("observation %1").arg(o.id), hint,
                       [&workbench, id = o.id] { workbench.selection.select_observation(id); }});
  }
  return entries;
}

}  // namespace handsight::app
