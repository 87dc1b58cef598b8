// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "vision/corners/corner_simd.h"

namespace handsight {
namespace {

constexpr double most_gain = 2.6;  // times the contrast that the circles showed

}  // namespace

double grown_radius(const Image& image, double radius, int most, double noise, const CornerModel& model,
                    CornerPatch& patch) {
  const Eigen::Vector2i centre = nearest_pixel(model.position);
  while (most > radius && !is_inside(image, centre, most + 1)) --most;
  if (most <= radius) return radius;
  gather(image, centre, most + 1, patch);
  const double bound = 2 * noise * noise + 0.02 * model.half_contrast * model.half_contrast;
  int n = pixels_in_disc(static_cast<int>(radius)), evaluated = n / wide_simd_lanes * wide_simd_lanes;
  for (int r = static_cast<int>(radius) + 1; r <= most; ++r) {
    const int begin = n, end = pixels_in_disc(r);
    if (end > evaluated) evaluate_residuals(model, most + 1, evaluated, end, patch), evaluated = in_groups(end);
    double squares = 0;
    for (; n < end; ++n) squares += patch.residual[n] * patch.residual[n];
    if (squares > bound * (end - begin)) return r - 1;
  }
  return most;
}

double compute_misfit(const CornerPatch& patch) {
  constexpr int reach_px = 5, side_length = 2 * reach_px + 2;
  static const std::vector<int> places = [] {
    std::vector<int> all;
    for (int n = 0; n < pixels_in_disc(reach_px); ++n) {
      const Eigen::Vector2i offset = offset_of_pixel(n);
      all.push_back((offset.y() + reach_px) * side_length + offset.x() + reach_px);
    }
    return all;
  }();
  std::array<float, side_length*(side_length + 1)> residual{}, weight{};
  const std::size_t count = std::min(static_cast<std::size_t>(patch.count), places.size());
  for (std::size_t n = 0; n < count; ++n) residual[places[n]] = patch.residual[n], weight[places[n]] = patch.weight[n];
  std::array<float, side_length> products_of{}, weights_of{};  // column by column, which do not wait for each other
  for (int v = 0; v < side_length; ++v)
    for (int u = 0; u < side_length; ++u) {
      const int n = v * side_length + u;
      products_of[u] += residual[n] * (residual[n + 1] + residual[n + side_length]);
      weights_of[u] += weight[n] * (weight[n + 1] + weight[n + side_length]);
    }
  const float products = std::accumulate(products_of.begin(), products_of.end(), 0.f);
  const float weights = std::accumulate(weights_of.begin(), weights_of.end(), 0.f);
  return std::sqrt(std::max(products / std::max(weights, 1.f), 0.f));
}

bool looks_right(const CornerModel& model, double half_contrast, double noise, double image_noise, double loose) {
  const double misfit = most_misfit * loose * half_contrast_in_light(model);
  return std::abs(model.half_contrast) < most_gain * loose * std::abs(half_contrast) && model.blur < 3.2 * loose &&
         noise * noise < misfit * misfit + 1.6 * loose * image_noise * image_noise &&
         std::abs(std::sin(model.edges[0] - model.edges[1])) > 0.4 / loose;
}

}  // namespace handsight
