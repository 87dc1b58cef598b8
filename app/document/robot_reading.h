// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured on the real robot to check a cause, beside what had been predicted.
#pragma once

#include <QString>

#include "diagnosis/verdict/robot_check.h"

namespace handsight::app {

struct RobotReading {
  std::string effect;           // of the catalogue: the candidate that was checked
  double value = 0, sigma = 0;  // in the prediction's unit
  CheckPrediction predicted;    // before it was measured; later fits do not change it
};
bool operator==(const RobotReading& a, const RobotReading& b);

/// A typed number with what it may be off by, in the shown unit: "1.3", "1.3 ± 0.1", "1.3 +- 0.1". Where nothing is
/// said it may be off by the rounding of its last digit. Nothing where it is no number.
struct TypedReading {
  double value = 0, sigma = 0;
};
std::optional<TypedReading> parse_reading(const QString& text);

}  // namespace handsight::app
