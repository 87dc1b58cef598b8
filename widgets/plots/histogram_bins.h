// SPDX-License-Identifier: GPL-3.0-or-later
// Observations by the size of their residual, and how many noise alone would put into each bin. Internal to
// histogram_plot.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "widgets/base/cells.h"

namespace handsight::widgets {

inline constexpr double histogram_bin = 0.1;  // of the decimal logarithm of the size

/// One bin: the observations in it, and how many there are of each step of the residual scale.
struct SizeBin {
  std::vector<ObservationId> ids;
  std::array<int, 6> steps{};
};

/// Has the cell a place in the histogram: it is used, and its size has a value in this unit?
bool counts_in(const ObservationCell& cell, SizeUnit unit);

/// Bins by number: bin b holds sizes from 10^(0.1 b) to 10^(0.1 (b + 1)). Sizes below `smallest` are put there.
std::map<int, SizeBin> size_bins(const std::vector<ObservationCell>& cells, SizeUnit unit, double smallest);
double place_of_size(double size, double smallest);

/// How many observations noise alone would put into the bins about it: a chi distribution for each observation's noise
/// and number of coordinates. Empty where no cell's noise is known.
std::map<int, double> noise_bins(const std::vector<ObservationCell>& cells, SizeUnit unit);

/// The median of what noise alone makes of the cells' sizes.
std::optional<double> typical_noise(const std::vector<ObservationCell>& cells, SizeUnit unit);

}  // namespace handsight::widgets
