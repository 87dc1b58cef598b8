// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/comparing.h"

#include "base/error.h"
#include "session/calibration_xml.h"
#include "session/session_xml.h"

namespace handsight::app {
namespace {

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
