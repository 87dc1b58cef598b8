// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_symmetry.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "vision/corner_lanes.h"

namespace handsight {
namespace {

constexpr int kMostRadius = 15;
constexpr int kMostSide = 2 * kMostRadius + 1;
constexpr int kMostPairs = (kMostSide * kMostSide / 2 + kLanes - 1) / kLanes * kLanes;

int window_radius(double sigma) { return static_cast<int>(std::ceil(3 * sigma)); }

// The window round a point: values and gradients, row by row, so that entry n has its mirror image at count - 1 - n.
struct Window {
  int count = 0;
  std::array<float, kMostSide * kMostSide> value, du, dv;
};

// Bilinear values of the window and its rim of one pixel, central differences inside.
HANDSIGHT_LANES bool sample_window(const Image& image, const Eigen::Vector2d& centre, int radius,
                                   const CornerModel* lit, Window& window) {
  const int u = static_cast<int>(std::floor(centre.x())), v = static_cast<int>(std::floor(centre.y()));
  const int rim = radius + 1, side = 2 * rim + 1, inner = 2 * radius + 1;
  if (u < rim || v < rim || u + rim + 1 >= image.width || v + rim + 1 >= image.height) return false;
  const auto fu = static_cast<float>(centre.x() - u), fv = static_cast<float>(centre.y() - v);
  std::array<float, (kMostSide + 2) * (kMostSide + 2)> values;
  for (int y = 0; y < side; ++y) {
    const std::uint8_t* upper = image.row(v - rim + y) + u - rim;
    const std::uint8_t* lower = image.row(v - rim + y + 1) + u - rim;
    std::array<float, kMostSide + 3> mixed;
    for (int x = 0; x <= side; ++x) mixed[x] = upper[x] + fv * static_cast<float>(lower[x] - upper[x]);
    float* to = values.data() + y * side;
    for (int x = 0; x < side; ++x) to[x] = mixed[x] + fu * (mixed[x + 1] - mixed[x]);
    if (!lit) continue;
    for (int x = 0; x < side; ++x)
      to[x] /= static_cast<float>(light_at(lit->shadow, centre + Eigen::Vector2d(x - rim, y - rim) - lit->position));
  }
  window.count = inner * inner;
  for (int y = 0; y < inner; ++y) {
    const float* at = values.data() + (y + 1) * side + 1;
    const int to = y * inner;
    for (int x = 0; x < inner; ++x) {
      window.value[to + x] = at[x];
      window.du[to + x] = 0.5f * (at[x + 1] - at[x - 1]);
      window.dv[to + x] = 0.5f * (at[x + side] - at[x - side]);
    }
  }
  return true;
}

struct Normal {
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero(), spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  double squares = 0;
};

// Of each pixel of half the window and its mirror image the difference of the values, and of the gradients; the other
// half says the same again.
struct Pairs {
  int count = 0;  // in whole groups, the last filled with zeros
  std::array<float, kMostPairs> value, du, dv;
};

HANDSIGHT_LANES void subtract_mirrored(const float* values, int count, float* differences) {
  const float* const last = values + count - 1;
  for (int n = 0; n < count / 2; ++n) differences[n] = values[n] - last[-n];
}

void pair_up(const Window& window, Pairs& pairs) {
  const int half = window.count / 2;
  pairs.count = (half + kLanes - 1) / kLanes * kLanes;
  subtract_mirrored(window.value.data(), window.count, pairs.value.data());
  subtract_mirrored(window.du.data(), window.count, pairs.du.data());
  subtract_mirrored(window.dv.data(), window.count, pairs.dv.data());
  for (auto* row : {&pairs.value, &pairs.du, &pairs.dv}) std::fill(row->begin() + half, row->begin() + pairs.count, 0.f);
}

// weight has as many entries.
HANDSIGHT_LANES void add_up(const Pairs& pairs, const float* weight, float* sums) {
  Lanes sum[9]{}, g, difference, ju, jv;
  for (int n = 0; n < pairs.count; n += kLanes) {
    load(weight + n, g), load(&pairs.value[n], difference), load(&pairs.du[n], ju), load(&pairs.dv[n], jv);
    const Lanes gu = g * ju, gv = g * jv;
    sum[0] += gu * ju, sum[1] += gu * jv, sum[2] += gv * jv;
    sum[3] += gu * gu, sum[4] += gu * gv, sum[5] += gv * gv;
    sum[6] += gu * difference, sum[7] += gv * difference;
    sum[8] += g * difference * difference;
  }
  totals(sum, sums), totals(sum + 4, sums + 4);
  sums[8] = total(sum[8]);
}

Normal normal_equations(const Window& window, const float* weight) {
  Pairs pairs;
  pair_up(window, pairs);
  std::array<float, 9> sum;
  add_up(pairs, weight, sum.data());
  Normal normal;
  normal.hessian << sum[0], sum[1], sum[1], sum[2];
  normal.spread << sum[3], sum[4], sum[4], sum[5];
  normal.gradient << sum[6], sum[7];
  normal.squares = sum[8];
  return normal;
}

void gaussian_weights(double sigma, int radius, float* weight) {
  std::array<float, kMostSide> line;  // of one direction, so that the product is normalised
  for (int i = -radius; i <= radius; ++i)
    line[i + radius] = static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / (std::sqrt(2 * M_PI) * sigma));
  for (int y = 0, n = 0; y <= 2 * radius; ++y)
    for (int x = 0; x <= 2 * radius; ++x, ++n) weight[n] = line[x] * line[y];
}

// Values brought to full light carry the more noise: the weight of a pair is its G over the pair's variance.
void weigh_by_light(const CornerModel& lit, const Eigen::Vector2d& centre, int radius, float* weight) {
  for (int y = -radius, n = 0; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x, ++n) {
      const Eigen::Vector2d at = centre - lit.position, offset(x, y);
      const double here = light_at(lit.shadow, at + offset), there = light_at(lit.shadow, at - offset);
      weight[n] *= static_cast<float>(2 * here * here * there * there / (here * here + there * there));
    }
}

double smaller_eigenvalue(const Eigen::Matrix2d& m) {
  return 0.5 * (m.trace() - std::hypot(m(0, 0) - m(1, 1), 2 * m(0, 1)));
}

}  // namespace

std::optional<SymmetryPoint> symmetry_point(const Image& image, const Eigen::Vector2d& start, double sigma,
                                            double reach, int iterations, const CornerModel* lit) {
  check(sigma >= 0.5 && sigma <= 5, "the symmetry window's sigma is {} px, not in 0.5 to 5", sigma);
  const int radius = window_radius(sigma);
  std::array<float, kMostSide * kMostSide> weight;
  gaussian_weights(sigma, radius, weight.data());
  const int half = (2 * radius + 1) * (2 * radius + 1) / 2;
  const float weights = std::accumulate(weight.begin(), weight.begin() + half, 0.f);
  if (lit) weigh_by_light(*lit, start, radius, weight.data());
  Window window;
  Eigen::Vector2d at = start;
  for (int i = 0;; ++i) {
    if (!sample_window(image, at, radius, lit, window)) return std::nullopt;
    const Normal normal = normal_equations(window, weight.data());
    const double smaller = smaller_eigenvalue(normal.hessian);
    if (!(smaller > 1e-6)) return std::nullopt;
    const Eigen::Matrix2d inverse = normal.hessian.inverse();
    const Eigen::Vector2d step = -inverse * normal.gradient;
    at += step.norm() > 1 ? Eigen::Vector2d(step.normalized()) : step;
    if ((at - start).norm() > reach) return std::nullopt;
    if (i == iterations || step.squaredNorm() < 1e-4) {
      const double variance = std::max(normal.squares + step.dot(normal.gradient), 0.0) / weights;  // after the step
      // Both halves of the window make O and its Hessian: twice the sums over one.
      return SymmetryPoint{at, variance * inverse * normal.spread * inverse, 2 * smaller, std::sqrt(variance / 2)};
    }
  }
}

}  // namespace handsight
