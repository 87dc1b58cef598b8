// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_mosaic.h"

#include <algorithm>
#include <cmath>

#include "vision/corners/corner_odd_grid.h"
#include "vision/corners/corner_odd_rows.h"
#include "vision/corners/corner_odd_system.h"

namespace handsight {
namespace {

constexpr double smoothed_share = 70.0 * 70 / (256 * 256);  // of white noise's variance, that smoothing leaves
constexpr double mosaic_sigma = 0.002;                      // px an axis, what is left of the pattern's own errors
// What a colour filter samples at every other pixel it cannot tell from what is coarser: px, across an edge that meets
// the pattern in one phase all along, times what blur leaves at half a cycle a pixel; px, along which phases differ.
constexpr double alias_px = 0.11, phases = 0.7;
constexpr double interpolated = 0.36;  // px^2, of the fitted blur: the interpolation's own

// Edges that run along rows or columns meet the pattern in one phase, and what that does to them does not average out.
Eigen::Matrix2d alias_of(const CornerModel& model, double radius) {
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity() * (mosaic_sigma * mosaic_sigma);
  const double blur_squared = std::max(model.blur * model.blur - interpolated, 1 / 12.0);
  const double across = alias_px * std::exp(-0.5 * M_PI * M_PI * blur_squared);
  for (int i = 0; i < 2; ++i) {
    const double angle = model.edges[i], other = model.edges[1 - i];
    const double aside = radius * std::min(std::abs(std::sin(angle)), std::abs(std::cos(angle))) / phases;
    const Eigen::Vector2d along_other(std::cos(other), std::sin(other));  // there the position moves
    const Eigen::Vector2d move = along_other * across / std::sin(other - angle);
    covariance += std::exp(-aside * aside) * move * move.transpose();
  }
  return covariance;
}

}  // namespace

std::optional<OddSystem> smoothed_odd_system(const Image& image, const CornerFit& fit) {
  OddRows all;
  if (!fill_rows(image, fit, all)) return std::nullopt;
  std::array<OddGrid, odd_rows> grids{};
  std::array<const float*, odd_rows + tile_of_rows - 1> rows;
  const int reach = all.reach + 1, first = (grid_middle - reach) * grid_side;
  for (int i = 0; i < odd_rows; ++i) {
    CornerPatch::Row row;
    std::copy_n(all.rows[i], all.patch.count, row.begin());
    spread(row, all.patch.count, grids[i]);
    smooth(grids[i]), smooth(grids[i]);
    rows[i] = &grids[i][static_cast<std::size_t>(first)];
  }
  std::fill(rows.begin() + odd_rows, rows.end(), rows[odd_rows - 1]);
  OddSystem system;
  system.is_smoothed = true, system.alias = alias_of(fit.model, fit.radius);
  set_equations(rows.data(), (2 * reach + 1) * grid_side, system);
  system.shade = fit.model.shade;
  system.weights = squared_weights(all.patch);
  const double variance = std::max(fit.noise * fit.noise, least_noise * least_noise);
  OddMatrix inverse = system.hessian;
  const OddVector information = usual_information(variance, wide_added, most_bend);
  inverse.diagonal() += information;
  if (!invert_odd(inverse)) return std::nullopt;
  const OddVector step = inverse * system.side;
  OddGrid& left = grids[odd_unknown_count];
  for (int i = 0; i < odd_unknown_count; ++i)
    for (std::size_t n = 0; n < left.size(); ++n) left[n] -= static_cast<float>(step(i)) * grids[i][n];
  const OddGrid odd = odd_part(left, reach, twice_from(all.centre, fit.model.position), Eigen::Vector2d::Zero());
  const double unknowns = odd_unknown_count - (information.array() * inverse.diagonal().array()).sum();
  const double freedom = std::max(0.5 * smoothed_share * system.weights - unknowns, 2.0);
  system.variance = std::max(shifted_product(odd, reach, {0, 0}) / freedom, least_noise * least_noise);
  system.variance_ratio = system.variance / variance;
  for (int i = 0; i < odd_unknown_count; ++i)
    system.seen[i] = step(i), system.seen_variance[i] = system.variance * inverse(i, i);
  return system;
}

}  // namespace handsight
