// SPDX-License-Identifier: GPL-3.0-or-later
// Two sessions of one robot, or a calibration and a session, compared and made ready to be shown. For a job: no
// widgets.
#pragma once

#include <QStringList>

#include "compare/compared_side.h"
#include "compare/comparison.h"

namespace handsight::app {

struct ComparedPair {
  ComparedSide before, after;
  Comparison comparison;
  std::vector<CalibrationResidual> as_calibrated;  // of `after`, where `before` is a calibration
  Rigid tcp_from_body;                             // of `before`
  QStringList notes;                               // of the window, beside those of the comparison
};

/// What is to be compared with what.
struct ComparisonTask {
  std::shared_ptr<const Session> session;  // the open one, as it stands
  ModelSettings settings;                  // its model; estimated in both
  ModelVersionPointer version;             // its fit; null where it is not there
  std::filesystem::path other;             // a session's folder or file, or an exported calibration
  bool other_is_later = false;             // a calibration never is
};

/// Reads the other one, finds its target where it has one, fits both and compares. InputError where the two cannot be
/// compared: what does not fit and what to do.
ComparedPair compare_pair(const ComparisonTask& task, JobControl& control);

}  // namespace handsight::app
