// SPDX-License-Identifier: Apache-2.0
// Where a shadow's edge may be, and how bright both sides of it are: from what the fit of corner_shadow.h starts.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "vision/corners/corner_products.h"
#include "vision/corners/corner_shadow.h"
#include "vision/corners/corner_simd.h"
#include "vision/corners/corner_solve.h"

namespace handsight {
namespace {

constexpr float least_light_share = 0.3f, least_told_of_guess = 0.45f;  // of what one light leaves, by two
constexpr double least_shadow_gain = 30;  // noise variances, of the sum of squares, for the shadow's four numbers
// Of the grey levels, r.m.s., what one light and what two may leave of a corner whose numbers are guessed.
constexpr float most_left_by_one = 0.45f, most_left_by_two = 0.2f;
constexpr float least_side = 0.04f;  // of the squares: either light must be seen

constexpr int direction_count = simd_lanes, bin_count = 2 * (most_patch_radius + 2) + 1;

// Of each pixel the bin of 1 px, one along each direction, that it lies in.
using Bins = std::array<std::array<std::uint8_t, direction_count>, most_patch_pixels>;

const Bins& bins() {
  static const Bins made = [] {
    Bins all{};
    for (int n = 0; n < pixels_in_disc(most_patch_radius + 2); ++n)
      for (int k = 0; k < direction_count; ++k) {
        const Eigen::Vector2d offset = offset_of_pixel(n).cast<double>();
        const double angle = M_PI * k / direction_count;
        const double along = offset.x() * std::cos(angle) + offset.y() * std::sin(angle);
        all[n][k] = static_cast<std::uint8_t>(std::lround(along) + bin_count / 2);
      }
    return all;
  }();
  return made;
}

// Sums for the factor that brings the model to the image: (sum w m value)^2 / sum w m^2 is what it tells.
struct Side {
  float products = 0, squares = 0;
  float reported() const { return squares > 0 ? products * products / squares : 0; }
  float factor() const { return products / squares; }
};

Side operator-(const Side& a, const Side& b) { return {a.products - b.products, a.squares - b.squares}; }

struct Split {
  float reported = 0;
  int direction = 0, bin = 0;  // the last bin that belongs to the near side
  Side near, far;
};

// Of each pixel the terms of the two sums, side by side, so that both are added at once.
using Pair = float __attribute__((vector_size(2 * sizeof(float))));
struct Terms {
  std::array<Pair, most_patch_pixels> terms;
  Side all;
  float values = 0;  // sum w value^2
};

HANDSIGHT_LANES void fill_terms(const CornerPatch& patch, Terms& terms) {
  constexpr Simd lane_numbers{0, 1, 2, 3, 4, 5, 6, 7};
  Simd sums[4]{}, zero{}, w, f, value, residual;
  for (int n = 0; n < patch.padded; n += simd_lanes) {
    load(&patch.weight[n], w), load(&patch.even[4][n], f);
    load(&patch.value[n], value), load(&patch.residual[n], residual);
    w = lane_numbers < static_cast<float>(patch.count - n) ? w : zero;  // what fills the last group is none of the disc
    const Simd weight = w > zero ? f * f : zero, m = value - residual / (w > zero ? w : zero + 1.f);
    const Simd products = weight * m * value, squares = weight * m * m;
    for (int i = 0; i < simd_lanes; ++i) terms.terms[n + i] = Pair{products[i], squares[i]};
    sums[0] += products, sums[1] += squares, sums[2] += weight * value * value;
  }
  float sum[4];
  totals(sums, sum);
  terms.all = {sum[0], sum[1]}, terms.values = sum[2];
}

using Histogram = std::array<std::array<Pair, direction_count>, bin_count>;

Histogram histogram(const Terms& terms, int count) {
  const Bins& all = bins();
  Histogram in{};
  for (int n = 0; n < count; ++n)
    for (int k = 0; k < direction_count; ++k) in[all[n][k]][k] += terms.terms[n];
  return in;
}

// All directions at once, in lanes.
HANDSIGHT_LANES Split best_split(const Histogram& in, const Side& all) {
  const float least = least_side * all.squares;
  Simd reported{}, bin{}, near_products{}, near_squares{}, best_products{}, best_squares{};
  for (int b = 0; b + 1 < bin_count; ++b) {
    Simd first, second;  // four directions each
    std::memcpy(&first, &in[b], sizeof first), std::memcpy(&second, &in[b][direction_count / 2], sizeof second);
    near_products += __builtin_shufflevector(first, second, 0, 2, 4, 6, 8, 10, 12, 14);
    near_squares += __builtin_shufflevector(first, second, 1, 3, 5, 7, 9, 11, 13, 15);
    const Simd far_products = all.products - near_products, far_squares = all.squares - near_squares;
    const Simd both = near_products * near_products / near_squares + far_products * far_products / far_squares;
    const Whole better = (both > reported) & (near_squares >= least) & (far_squares >= least);
    reported = better ? both : reported, bin = better ? Simd{} + static_cast<float>(b) : bin;
    best_products = better ? near_products : best_products, best_squares = better ? near_squares : best_squares;
  }
  Split best;
  for (int k = 0; k < direction_count; ++k) {
    const Side near{best_products[k], best_squares[k]};
    if (reported[k] > best.reported) best = {reported[k], k, static_cast<int>(bin[k]), near, all - near};
  }
  return best;
}

// The four patterns and the image, one row each, all times the weight.
HANDSIGHT_LANES void fill_light_rows(const CornerModel& model, CornerPatch& patch) {
  const ShadowEdge& shadow = model.shadow;
  const auto scale = static_cast<float>(M_SQRT1_2 / shadow.softness);
  const Eigen::Vector2f normal(static_cast<float>(std::cos(shadow.direction)),
                               static_cast<float>(std::sin(shadow.direction)));
  const Eigen::Vector2d off = patch.centre.cast<double>() - model.position;
  const auto middle = static_cast<float>(normal.cast<double>().dot(off) - shadow.distance);
  Simd u, v, weight, cells, value, erf, bell;
  for (int n = 0; n < patch.padded; n += simd_lanes) {
    load(pixel_columns() + n, u), load(pixel_rows() + n, v);
    load(&patch.weight[n], weight), load(&patch.even[4][n], cells), load(&patch.value[n], value);
    erf_and_bell(scale * (middle + normal.x() * u + normal.y() * v), erf, bell);
    const Simd beyond = 0.5f + 0.5f * erf;
    store(weight * beyond, &patch.shadow[0][n]), store(cells * beyond, &patch.shadow[1][n]);
    store(weight * value, &patch.residual[n]);
  }
}

using LightProducts = RowProducts<5>;
HANDSIGHT_LANES void light_products(const float* const* rows, int count, LightProducts& products) {
  all_products<Simd, 5>(rows, count, products);
}

}  // namespace

std::optional<ShadowEdge> likely_shadow(const CornerPatch& patch, const CornerModel& model, Guess guess, double noise) {
  Terms terms;
  fill_terms(patch, terms);
  const Side& all = terms.all;
  const float left = terms.values - all.reported();
  const auto too_much = [&](float squares, float most) {
    return guess == Guess::from_circles && squares > most * most * all.squares;
  };
  const double least_gain = least_shadow_gain * noise * noise;
  if (left < least_gain || too_much(left, most_left_by_one)) return std::nullopt;
  const Split split = best_split(histogram(terms, patch.count), all);
  const float gain = split.reported - all.reported();
  if (!(split.reported > 0) || too_much(left - gain, most_left_by_two)) return std::nullopt;
  const float least_reported = guess == Guess::fitted ? least_light_share : least_told_of_guess;
  if (gain < least_reported * left || gain < least_gain) return std::nullopt;
  const double angle = M_PI * split.direction / direction_count;
  const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
  const int bins_from_centre = split.bin - bin_count / 2;
  const double along = bins_from_centre + 0.5 - normal.dot(model.position - patch.centre.cast<double>());
  ShadowEdge edge;
  const bool ahead = along >= 0;
  edge.direction = ahead ? angle : angle + M_PI;
  edge.distance = std::abs(along);
  const double here = ahead ? split.near.factor() : split.far.factor();
  const double beyond = ahead ? split.far.factor() : split.near.factor();
  if (!(here > 0.1 && beyond > 0.1)) return std::nullopt;
  edge.depth = 1 - beyond / here;
  edge.softness = std::hypot(model.blur, penumbra_px);
  return edge;
}

CornerModel lit_as_seen(const Image& image, const CornerModel& expected, double radius, CornerPatch& patch) {
  const int reach = static_cast<int>(radius) + 1;
  const Eigen::Vector2i centre = nearest_pixel(expected.position);
  if (!is_inside(image, centre, reach)) return expected;
  gather(image, centre, reach, patch);
  CornerModel even = expected;
  even.shadow = {};
  evaluate_residuals(even, radius, 0, patch.count, patch);
  fill_light_rows(expected, patch);
  std::array<const float*, 5 + tile_of_rows> rows{patch.weight.data(), patch.even[4].data(), patch.shadow[0].data(),
                                                  patch.shadow[1].data()};
  std::fill(rows.begin() + 4, rows.end(), patch.residual.data());
  LightProducts products;
  light_products(rows.data(), patch.padded, products);
  Eigen::Matrix4d normal;
  Eigen::Vector4d shares;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) normal(i, j) = normal(j, i) = products[i][j];
    shares(i) = products[4][i];
  }
  if (!solve<4>(normal, shares)) return expected;
  const double depth = -(shares(0) * shares(2) + shares(1) * shares(3)) / shares.head<2>().squaredNorm();
  if (!(depth > most_lit_beyond && depth < most_depth && shares(1) * expected.half_contrast > 0)) return expected;
  CornerModel seen = expected;
  seen.level = shares(0), seen.half_contrast = shares(1), seen.shadow.depth = depth;
  return seen;
}

}  // namespace handsight
