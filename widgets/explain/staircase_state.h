// SPDX-License-Identifier: GPL-3.0-or-later
// What the staircase shows: the versions of the model with their errors, and the noise floor.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "widgets/lists/three_numbers.h"

namespace handsight::widgets {

struct StaircaseState {
  std::vector<VersionStep> versions;  // oldest first
  std::optional<double> noise;        // the floor
  QString unit = "px";
  int current = -1;                    // shown in the window; -1: the last that was not refused
  std::optional<VersionStep> preview;  // what is being tried: a dashed purple step after the current one
  int compared_a = -1, compared_b = -1;
};

}  // namespace handsight::widgets
