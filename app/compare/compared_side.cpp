// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compared_side.h"

#include <algorithm>

#include "base/error.h"
#include "detection/target_finding.h"
#include "estimation/start/target_symmetry.h"
#include "findings/recall.h"

namespace handsight::app {
namespace {

constexpr std::size_t most_recalled = 5000;  // observations whose way to the estimate is gone again

bool comes_at_a_moment(const EffectTerm& term) {
  const Effect& effect = term_effect(term);
  return std::any_of(effect.parameters.begin(), effect.parameters.end(),
                     [](const EffectParameter& p) { return p.is_choice; });
}

}  // namespace

ModelSettings shared_settings(const ModelSettings& of_open, QStringList& notes) {
  ModelSettings shared;
  shared.estimated = of_open.estimated;
  shared.estimated.insert(shared.estimated.end(), of_open.held.begin(), of_open.held.end());
  if (std::erase_if(shared.estimated, comes_at_a_moment) > 0)
    notes << QObject::tr("Slips in the model of the open session are left out: they came at observations of its own.");
  const auto holds = [](const EffectTerm& t) {
    return std::any_of(t.held.begin(), t.held.end(), [](char is_held) { return is_held != 0; });
  };
  if (!of_open.held.empty() || std::any_of(shared.estimated.begin(), shared.estimated.end(), holds))
    notes << QObject::tr("Numbers that the model holds are estimated here, in both.");
  for (EffectTerm& term : shared.estimated) term.held.clear();
  return shared;
}

Session searched(Session session) {
  find_targets(session);
  undo_target_symmetry(session);
  return session;
}

QString folder_name(const Session& s) { return QString::fromStdString(s.file.parent_path().filename().string()); }

ComparedSide side_of(std::shared_ptr<const Session> session) {
  ComparedSide side;
  side.name = display_name(*session);
  side.file = session->file;
  side.session = std::move(session);
  return side;
}

void look_into(ComparedSide& side, const ModelSettings& settings, const ModelVersionPointer& known,
               const JobControl& control) {
  side.version = known ? known : make_version(*side.session, settings, 0, {}, {}, going_on(control));
  if (!side.version->fit || control.is_cancelled()) return;
  side.residuals = make_residuals(*side.version);
  if (side.session->observations.size() > most_recalled) return;
  try {
    side.convergence = list_convergence(recalled_steps(*side.session, going_on(control)));
  } catch (const InputError&) {
    // What cannot be played again has no way to be shown; the page says so.
  }
}

}  // namespace handsight::app
