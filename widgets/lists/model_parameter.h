// SPDX-License-Identifier: GPL-3.0-or-later
// One number of a model, with its sigma and what is plausible.
#pragma once

#include <QString>
#include <optional>

namespace handsight::widgets {

struct ModelParameter {
  QString of;  // joint, marker or camera that it belongs to; may be empty
  QString name;
  std::optional<double> value, sigma;  // in `unit`
  QString unit;
  std::optional<double> plausible;  // one standard deviation of what is plausible; absent: no bar
  bool can_hold = false;            // offers to hold it, or to estimate it again
  bool is_held = false;             // typed, not estimated
  bool is_choice = false;           // a choice (from which observation on): neither estimated nor typed
};

}  // namespace handsight::widgets
