// SPDX-License-Identifier: Apache-2.0
// When an experiment has found out enough.
#pragma once

#include <optional>
#include <string>

namespace handsight {

/// Precision and odds are what is wanted: it ends once all of them are reached. Count and time end it in any case.
struct Goals {
  std::optional<double> hand;     // m: the hand's error below this in 95 of 100 cases, over the poses
  std::optional<double> odds;     // for one cause, or for none
  std::optional<int> count;       // of new observations
  std::optional<double> seconds;  // since it began

  bool wants_something() const { return hand || odds; }
};

/// Adds "hand=0.3mm", "odds=20", "count=60" or "time=30min" (s, min, h), several with '|' or ',' between. InputError
/// names what is not understood.
void add_goals(const std::string& text, Goals& goals);

}  // namespace handsight
