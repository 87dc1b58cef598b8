// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/comparing.h"

#include <algorithm>

#include "base/error.h"
#include "detection/target_finding.h"
#include "estimation/start/target_symmetry.h"
#include "findings/recall.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"

namespace handsight::app {
namespace {

constexpr std::size_t most_recalled = 5000;  // observations whose way to the estimate is gone again

bool comes_at_a_moment(const EffectTerm& term) {
  const Effect& effect = term_effect(term);
  return std::any_of(effect.parameters.begin(), effect.parameters.end(),
                     [](const EffectParameter& p) { return p.is_choice; });
}

/// The model that both sides have. What jumped at an observation of the one did not at that of the other.
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

/// With the points of its target, where it has one and they are not there yet.
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

/// Its own fit with what it leaves, and how TCP->Body came about.
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

/// Part of the whole from one share to another.
ComparisonProgress within(JobControl& control, double from, double to) {
  return [&control, from, to](double share) {
    control.report(from + share * (to - from));
    return !control.is_cancelled();
  };
}

/// The document's own fit where it is one of this model.
ModelVersionPointer usable(const ComparisonTask& task, const ModelSettings& shared) {
  const bool is_known = task.version && task.version->fit && task.settings == shared;
  return is_known ? task.version : nullptr;
}

ComparedPair with_calibration(const ComparisonTask& task, JobControl& control) {
  const Calibration calibration = read_calibration(task.other);
  const CalibratedRobot robot =
      calibrated_robot(calibration, task.session->robot, task.session->robot_file, task.other.string());
  ComparedPair pair;
  pair.before.name = QString::fromStdString(task.other.filename().string());
  pair.before.file = task.other;
  pair.tcp_from_body = robot.model.tcp_from_body;
  pair.after = side_of(std::make_shared<Session>(searched(*task.session)));
  pair.comparison = compare(robot, *pair.after.session, within(control, 0.05, 0.7));
  pair.as_calibrated = compute_residuals(robot, *pair.after.session);
  const ModelSettings own{.estimated = task.settings.estimated, .held = task.settings.held};
  look_into(pair.after, own, task.version && task.version->fit ? task.version : nullptr, control);
  return pair;
}

ComparedPair with_session(const ComparisonTask& task, JobControl& control) {
  Session other = read_session(task.other);
  std::error_code error;
  if (std::filesystem::equivalent(other.file, task.session->file, error))
    throw InputError(verbatim(
        QObject::tr("This is the session that is open; choose another one of the same robot, or a calibration.")
            .toStdString()));
  ComparedSide opened = side_of(std::make_shared<Session>(searched(*task.session)));
  ComparedSide chosen = side_of(std::make_shared<Session>(searched(std::move(other))));
  if (opened.name == chosen.name)  // weeks apart, under one title
    for (ComparedSide* side : {&opened, &chosen}) side->name = folder_name(*side->session);
  control.report(0.05);
  ComparedPair pair;
  const ModelSettings shared = shared_settings(task.settings, pair.notes);
  pair.before = task.other_is_later ? opened : chosen;
  pair.after = task.other_is_later ? chosen : opened;
  pair.comparison = compare(*pair.before.session, *pair.after.session, shared.estimated, within(control, 0.05, 0.7));
  for (ComparedSide* side : {&pair.before, &pair.after}) {
    const bool is_open = (side == &pair.after) != task.other_is_later;
    look_into(*side, shared, is_open ? usable(task, shared) : nullptr, control);
    control.report(side == &pair.before ? 0.85 : 1);
  }
  if (pair.before.version->fit) pair.tcp_from_body = pair.before.version->fit->tcp_from_body;
  return pair;
}

}  // namespace

ComparedPair compare_pair(const ComparisonTask& task, JobControl& control) {
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(task.other, error);
  return is_file && is_calibration_file(task.other) ? with_calibration(task, control) : with_session(task, control);
}

}  // namespace handsight::app
