// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_odd_grid.h"

#include <algorithm>

namespace handsight {
namespace {

int place(const Eigen::Vector2i& offset) { return (offset.y() + grid_middle) * grid_side + offset.x() + grid_middle; }

HANDSIGHT_LANES float product(const float* a, const float* b, int rows) {
  Simd sum{}, x, y;
  for (int n = 0; n < rows * grid_side; n += simd_lanes) load(a + n, x), load(b + n, y), sum += x * y;
  return total(sum);
}

HANDSIGHT_LANES void smooth_simd(OddGrid& grid) {
  OddGrid across{};
  constexpr int last_entry = grid_side * (grid_side - 1);
  for (int n = 1; n < grid_side * grid_side; ++n) across[n] = 0.25f * (grid[n - 1] + 2 * grid[n] + grid[n + 1]);
  for (int n = grid_side; n < last_entry; ++n)
    grid[n] = 0.25f * (across[n - grid_side] + 2 * across[n] + across[n + grid_side]);
}

}  // namespace

void spread(const CornerPatch::Row& row, int count, OddGrid& grid) {
  static const std::array<int, most_patch_pixels> places = [] {
    std::array<int, most_patch_pixels> all{};
    for (int n = 0; n < pixels_in_disc(most_patch_radius + 1); ++n) all[n] = place(offset_of_pixel(n));
    return all;
  }();
  for (int n = 0; n < count; ++n) grid[places[n]] = row[n];
}

float shifted_product(const OddGrid& grid, int reach, const std::array<int, 2>& step) {
  const float* const first = &grid[static_cast<std::size_t>((grid_middle - reach) * grid_side)];
  return product(first, first + step[1] * grid_side + step[0], 2 * reach + 1);
}

Eigen::Vector2i twice_from(const Eigen::Vector2i& centre, const Eigen::Vector2d& position) {
  return (2 * (position - centre.cast<double>())).array().round().cast<int>();
}

OddGrid odd_part(const OddGrid& grid, int reach, const Eigen::Vector2i& twice, const Eigen::Vector2d& aside) {
  OddGrid odd{}, even{};
  const auto first = [&](int at) { return std::max(-reach, at - reach); };
  const auto last = [&](int at) { return std::min(reach, at + reach); };
  for (int v = first(twice.y()); v <= last(twice.y()); ++v) {
    const float* const from = &grid[static_cast<std::size_t>(place({0, v}))];
    const float* const mirrored = &grid[static_cast<std::size_t>(place({twice.x(), twice.y() - v}))];
    float* const to = &odd[static_cast<std::size_t>(place({0, v}))];
    float* const sum = &even[static_cast<std::size_t>(place({0, v}))];
    for (int u = first(twice.x()); u <= last(twice.x()); ++u)
      to[u] = 0.5f * (from[u] - mirrored[-u]), sum[u] = 0.5f * (from[u] + mirrored[-u]);
  }
  const auto across = static_cast<float>(0.5 * aside.x()), down = static_cast<float>(0.5 * aside.y());
  for (int v = first(twice.y()); v <= last(twice.y()); ++v) {
    const float* const at = &even[static_cast<std::size_t>(place({0, v}))];
    float* const to = &odd[static_cast<std::size_t>(place({0, v}))];
    for (int u = first(twice.x()); u <= last(twice.x()); ++u)
      to[u] -= across * (at[u + 1] - at[u - 1]) + down * (at[u + grid_side] - at[u - grid_side]);
  }
  return odd;
}

void smooth(OddGrid& grid) { smooth_simd(grid); }

}  // namespace handsight
