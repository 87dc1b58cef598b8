// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_symmetry.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/error.h"
#include "vision/corners/corner_crossing.h"
#include "vision/corners/corner_simd.h"

namespace handsight {
namespace {

constexpr int most_radius = 15;

int window_radius(double sigma) { return static_cast<int>(std::ceil(3 * sigma)); }

// Row by row with room at both sides, so that rows can be read in whole groups, forwards and backwards.
template <int row_stride, int row_count>
struct Rows {
  static constexpr int before_row = 16, row_length = before_row + row_stride + simd_lanes;
  std::array<float, row_count * row_length> values;
  HANDSIGHT_INLINE float* row(int y) { return &values[static_cast<std::size_t>(y * row_length + before_row)]; }
  HANDSIGHT_INLINE const float* row(int y) const {
    return &values[static_cast<std::size_t>(y * row_length + before_row)];
  }
};

// The window round a point and its rim of one pixel. `row_stride` holds a row: 16 up to a radius of 6, else 48.
template <int row_stride>
struct Window {
  static constexpr int width_px = row_stride, most_side = row_stride == 16 ? 15 : 2 * most_radius + 3,
                       half_size = most_side / 2 + 1;
  int radius = 0;
  Rows<row_stride, most_side> value, light;
  Rows<row_stride, half_size + 1> sum;  // with the opposite point, from the row above the middle on
  std::array<float, row_stride * half_size> difference, weight;  // to the opposite point, from the middle row on
  HANDSIGHT_INLINE int rim() const { return radius + 1; }
  HANDSIGHT_INLINE int side() const { return 2 * rim() + 1; }
  HANDSIGHT_INLINE int stride() const { return row_stride == 16 ? 16 : in_groups(side()); }
};

using SmallWindow = Window<16>;
using LargeWindow = Window<48>;

template <int row_stride>
HANDSIGHT_INLINE void mix_across(const std::uint8_t* pixels, float share, int stride, float* mixed) {
  for (int x = 0; x < stride; ++x) {
    const float left = pixels[x], right = pixels[x + 1];
    mixed[x] = left + share * (right - left);
  }
}

// Bilinear values round `centre`; false where they are not inside of the image.
template <int row_stride>
HANDSIGHT_INLINE bool sample(const Image& image, const Eigen::Vector2d& centre, Window<row_stride>& window) {
  const int u = static_cast<int>(std::floor(centre.x())), v = static_cast<int>(std::floor(centre.y()));
  const int rim = window.rim(), side = window.side(), stride = window.stride();
  if (u < rim || v < rim || u + rim + 1 >= image.width || v + rim + 1 >= image.height) return false;
  const auto fu = static_cast<float>(centre.x() - u), fv = static_cast<float>(centre.y() - v);
  std::array<std::uint8_t, row_stride + simd_lanes> last{};  // whole groups of the image's last row may reach beyond it
  std::array<float, 2 * row_stride> mixed;
  mix_across<row_stride>(image.row(v - rim) + u - rim, fu, stride, mixed.data());
  for (int y = 0; y < side; ++y) {
    const std::uint8_t* pixels = image.row(v - rim + y + 1) + u - rim;
    if (v - rim + y + 2 == image.height) std::copy_n(pixels, side + 1, last.begin()), pixels = last.data();
    const float* const above = &mixed[static_cast<std::size_t>(y % 2 * row_stride)];
    float* const below = &mixed[static_cast<std::size_t>((y + 1) % 2 * row_stride)];
    mix_across<row_stride>(pixels, fu, stride, below);
    float* const to = window.value.row(y);
    for (int x = 0; x < stride; ++x) to[x] = above[x] + fv * (below[x] - above[x]);
  }
  return true;
}

// The image as it would be without the shadow, and the light that it is divided by.
template <int row_stride>
HANDSIGHT_INLINE void bring_to_light(const CornerModel& lit, const Eigen::Vector2d& centre,
                                     Window<row_stride>& window) {
  const ShadowEdge& shadow = lit.shadow;
  const Eigen::Vector2d off = centre - lit.position, normal(std::cos(shadow.direction), std::sin(shadow.direction));
  const auto across = static_cast<float>(normal.x()), down = static_cast<float>(normal.y());
  const auto middle = static_cast<float>(normal.dot(off) - shadow.distance);
  const auto half_depth = static_cast<float>(0.5 * shadow.depth);
  const auto scale = static_cast<float>(M_SQRT1_2 / shadow.softness), sharp = static_cast<float>(M_SQRT1_2 / lit.blur);
  const std::array<ShadowCrossing, 2> crossings = find_crossings(lit);
  std::array<float, 2> sine, cosine, from_edge;
  for (int i = 0; i < 2; ++i) {
    sine[i] = static_cast<float>(std::sin(lit.edges[i])), cosine[i] = static_cast<float>(std::cos(lit.edges[i]));
    from_edge[i] = static_cast<float>(std::cos(lit.edges[i]) * off.y() - std::sin(lit.edges[i]) * off.x());
  }
  constexpr Simd lane_numbers{0, 1, 2, 3, 4, 5, 6, 7};
  for (int y = 0; y < window.side(); ++y)
    for (int x = 0; x < window.stride(); x += simd_lanes) {
      Simd erf, bell, value, first, second, bell1, bell2;
      const Simd u = lane_numbers + static_cast<float>(x - window.rim());
      const auto v = static_cast<float>(y - window.rim());
      const Simd beyond = middle + across * u + down * v;
      erf_and_bell(scale * beyond, erf, bell);
      const Simd d = from_edge[0] + cosine[0] * v - sine[0] * u, e = from_edge[1] + cosine[1] * v - sine[1] * u;
      erfs_and_bells<Simd>(sharp * d, sharp * e, first, bell1, second, bell2);
      crossings[0].share(d, beyond, bell1), crossings[1].share(e, beyond, bell2);
      const Simd light = 1.f - half_depth * (1.f + erf);
      load(window.value.row(y) + x, value);
      store(light, window.light.row(y) + x);
      store((value - bell1 * second - bell2 * first) / light, window.value.row(y) + x);
    }
}

// Values brought to full light carry the more noise: the weight of a pair is its G over the pair's variance.
template <int row_stride>
HANDSIGHT_INLINE void weigh_by_light(Window<row_stride>& window) {
  const int rim = window.rim(), side = window.side();
  for (int y = 0; y <= window.radius; ++y) {
    const float *const here = window.light.row(rim + y), *const opposite = window.light.row(rim - y) + side - 1;
    float* const weight = &window.weight[static_cast<std::size_t>(y * row_stride)];
    for (int x = 1; x + 1 < side; ++x) {
      const float a = here[x] * here[x], b = opposite[-x] * opposite[-x];
      weight[x] *= 2 * a * b / (a + b);
    }
  }
}

// The normalised Gaussian; each pair of opposite points once.
template <int row_stride>
struct Weights {
  double sigma = 0;
  std::array<float, row_stride * Window<row_stride>::half_size> weight;
  float sum = 0;
};

template <int row_stride>
Weights<row_stride> gaussian_weights(double sigma) {
  Weights<row_stride> made;
  made.sigma = sigma, made.weight.fill(0);
  const int radius = window_radius(sigma);
  std::array<float, most_radius + 1> line;  // of one direction, so that the product is normalised
  for (int i = 0; i <= radius; ++i)
    line[i] = static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / (std::sqrt(2 * M_PI) * sigma));
  for (int y = 0; y <= radius; ++y)
    for (int x = y == 0 ? 1 : -radius; x <= radius; ++x)
      made.sum += made.weight[y * row_stride + radius + 1 + x] = line[std::abs(x)] * line[y];
  return made;
}

// Of one image all windows have the same.
template <int row_stride>
const Weights<row_stride>& weights_of(double sigma) {
  thread_local Weights<row_stride> last;
  if (last.sigma != sigma) last = gaussian_weights<row_stride>(sigma);
  return last;
}

// What is read beside rows weighs nothing, but must be a number.
template <int row_stride>
void clear_margins(Window<row_stride>& window) {
  const int before = window.stride() - window.side();
  for (int y = 0; y < window.side(); ++y) std::fill_n(window.value.row(y) - before, before, 0.f);
  for (int y = 0; y < window.rim() + 2; ++y) window.sum.row(y)[-1] = window.sum.row(y)[window.stride()] = 0;
}

constexpr int sum_count = 9;

// The gradients' difference is that of the sums: (I(x+y) - I(x-y))' by x is the gradient of I(x+y) + I(x-y) by y.
template <int row_stride>
HANDSIGHT_INLINE void add_up(Window<row_stride>& window, float* sums) {
  const int rim = window.rim(), side = window.side(), stride = window.stride();
  for (int y = -1; y <= rim; ++y) {
    const float *const here = window.value.row(rim + y), *const opposite = window.value.row(rim - y) + side - 1;
    float* const to = window.sum.row(y + 1);
    for (int x = 0; x < stride; ++x) to[x] = here[x] + opposite[-x];
    if (y < 0 || y > window.radius) continue;
    float* const apart = &window.difference[static_cast<std::size_t>(y * row_stride)];
    for (int x = 0; x < stride; ++x) apart[x] = here[x] - opposite[-x];
  }
  Simd sum[sum_count]{}, g, difference, before, after;
  for (int y = 0; y <= window.radius; ++y)
    for (int x = 0; x < stride; x += simd_lanes) {
      load(&window.weight[y * row_stride + x], g), load(&window.difference[y * row_stride + x], difference);
      load(window.sum.row(y + 1) + x - 1, before), load(window.sum.row(y + 1) + x + 1, after);
      const Simd ju = 0.5f * (after - before);
      load(window.sum.row(y) + x, before), load(window.sum.row(y + 2) + x, after);
      const Simd jv = 0.5f * (after - before), gu = g * ju, gv = g * jv;
      sum[0] += gu * ju, sum[1] += gu * jv, sum[2] += gv * jv;
      sum[3] += gu * gu, sum[4] += gu * gv, sum[5] += gv * gv;
      sum[6] += gu * difference, sum[7] += gv * difference;
      sum[8] += g * difference * difference;
    }
  totals(sum, sums), totals(sum + 4, sums + 4);
  sums[8] = total(sum[8]);
}

// Samples and adds up; `lit`, if any, weighs at the first of the steps.
template <int row_stride>
HANDSIGHT_INLINE bool look_at(const Image& image, const Eigen::Vector2d& centre, const CornerModel* lit, bool is_first,
                              Window<row_stride>& window, float* sums) {
  if (!sample(image, centre, window)) return false;
  if (lit) bring_to_light(*lit, centre, window);
  if (lit && is_first) weigh_by_light(window);
  add_up(window, sums);
  return true;
}

HANDSIGHT_LANES bool look_simd(const Image& image, const Eigen::Vector2d& centre, const CornerModel* lit, bool is_first,
                               SmallWindow& window, float* sums) {
  return look_at(image, centre, lit, is_first, window, sums);
}
HANDSIGHT_LANES bool look_simd(const Image& image, const Eigen::Vector2d& centre, const CornerModel* lit, bool is_first,
                               LargeWindow& window, float* sums) {
  return look_at(image, centre, lit, is_first, window, sums);
}

double smaller_eigenvalue(const Eigen::Matrix2d& m) {
  const double apart = m(0, 0) - m(1, 1), mixed = 2 * m(0, 1);
  return 0.5 * (m.trace() - std::sqrt(apart * apart + mixed * mixed));
}

template <class AnyWindow>
std::optional<SymmetryPoint> point_in(AnyWindow& window, const Image& image, const Eigen::Vector2d& start, double sigma,
                                      double reach, int iterations, const CornerModel* lit) {
  window.radius = window_radius(sigma);
  clear_margins(window);
  const auto& [same, weight, weights] = weights_of<AnyWindow::width_px>(sigma);
  window.weight = weight;
  Eigen::Vector2d at = start;
  for (int i = 0;; ++i) {
    std::array<float, sum_count> sum;
    if (!look_simd(image, at, lit, i == 0, window, sum.data())) return std::nullopt;
    Eigen::Matrix2d hessian, spread;
    hessian << sum[0], sum[1], sum[1], sum[2];
    spread << sum[3], sum[4], sum[4], sum[5];
    const Eigen::Vector2d gradient(sum[6], sum[7]);
    const double smaller = smaller_eigenvalue(hessian);
    if (!(smaller > 1e-6)) return std::nullopt;
    const Eigen::Matrix2d inverse = hessian.inverse();
    const Eigen::Vector2d step = -inverse * gradient;
    at += step.norm() > 1 ? Eigen::Vector2d(step.normalized()) : step;
    if ((at - start).norm() > reach) return std::nullopt;
    if (i == iterations || step.squaredNorm() < 1e-4) {
      const double variance = std::max(sum[8] + step.dot(gradient), 0.0) / weights;  // after the step
      // Both halves of the window make O and its Hessian: twice the sums over one.
      return SymmetryPoint{at, variance * inverse * spread * inverse, 2 * smaller, std::sqrt(variance / 2)};
    }
  }
}

}  // namespace

std::optional<SymmetryPoint> symmetry_point(const Image& image, const Eigen::Vector2d& start, double sigma,
                                            double reach, int iterations, const CornerModel* lit) {
  check(sigma >= 0.5 && sigma <= 5, "the symmetry window's sigma is {} px, not in 0.5 to 5", sigma);
  if (window_radius(sigma) <= 6) {
    SmallWindow window;
    return point_in(window, image, start, sigma, reach, iterations, lit);
  }
  LargeWindow window;
  return point_in(window, image, start, sigma, reach, iterations, lit);
}

}  // namespace handsight
