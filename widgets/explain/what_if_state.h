// SPDX-License-Identifier: GPL-3.0-or-later
// An effect that is tried by hand: its places and the sizes of its parameters.
#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace handsight::widgets {

struct WhatIfParameter {
  QString name, unit;
  double plausible = 1;                    // one standard deviation of what is plausible, in `unit`
  std::optional<double> best, best_sigma;  // the size that fits best
  double value = 0;
};

struct WhatIfState {
  QString id, title;
  std::vector<QString> places;  // joints or markers; empty: the effect sits at one place only
  int place = 0;
  std::vector<WhatIfParameter> parameters;
  int parameter = 0;
  QString answer;  // "With this the error would be 3.1 px."
};

}  // namespace handsight::widgets
