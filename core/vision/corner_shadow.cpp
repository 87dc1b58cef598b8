// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_shadow.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "vision/corner_lanes.h"
#include "vision/corner_products.h"
#include "vision/corner_solve.h"

namespace handsight {
namespace {

constexpr int kUnknowns = 13;           // position, shade; edges, blur, level, half contrast; the shadow's four
constexpr double kSoftnessSigma = 0.5;  // px: the edges of near and far things' shadows
constexpr double kPenumbra = 0.6;       // px, of a usual shadow's edge before the lens
constexpr double kMostDepth = 0.9;
constexpr float kLeastTold = 0.3f, kLeastToldOfGuess = 0.45f;  // of what one light leaves, by two
constexpr double kLeastGain = 30;  // noise variances, of the sum of squares, for the shadow's four numbers
// Of the grey levels, r.m.s., what one light and what two may leave of a corner whose numbers are guessed.
constexpr float kMostLeftByOne = 0.45f, kMostLeftByTwo = 0.2f;
constexpr float kLeastSide = 0.04f;  // of the squares: either light must be seen

using Hessian = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Vector = Eigen::Matrix<double, kUnknowns, 1>;

constexpr int kDirections = kLanes, kBins = 2 * (kMostPatchRadius + 2) + 1;

// Of each pixel the bin of 1 px, one along each direction, that it lies in.
using Bins = std::array<std::array<std::uint8_t, kDirections>, kMostPatchPixels>;

const Bins& bins() {
  static const Bins made = [] {
    Bins all{};
    for (int n = 0; n < pixels_in_disc(kMostPatchRadius + 2); ++n)
      for (int k = 0; k < kDirections; ++k) {
        const Eigen::Vector2d offset = offset_of_pixel(n).cast<double>();
        const double angle = M_PI * k / kDirections;
        const double along = offset.x() * std::cos(angle) + offset.y() * std::sin(angle);
        all[n][k] = static_cast<std::uint8_t>(std::lround(along) + kBins / 2);
      }
    return all;
  }();
  return made;
}

// Sums for the factor that brings the model to the image: (sum w m value)^2 / sum w m^2 is what it tells.
struct Side {
  float products = 0, squares = 0;
  float told() const { return squares > 0 ? products * products / squares : 0; }
  float factor() const { return products / squares; }
};

Side operator-(const Side& a, const Side& b) { return {a.products - b.products, a.squares - b.squares}; }

struct Split {
  float told = 0;
  int direction = 0, bin = 0;  // the last bin that belongs to the near side
  Side near, far;
};

// Of each pixel the terms of the two sums, side by side, so that both are added at once.
using Pair = float __attribute__((vector_size(2 * sizeof(float))));
struct Terms {
  std::array<Pair, kMostPatchPixels> terms;
  Side all;
  float values = 0;  // sum w value^2
};

HANDSIGHT_LANES void fill_terms(const CornerPatch& patch, Terms& terms) {
  constexpr Lanes kNumber{0, 1, 2, 3, 4, 5, 6, 7};
  Lanes sums[4]{}, zero{}, w, f, value, residual;
  for (int n = 0; n < patch.padded; n += kLanes) {
    load(&patch.weight[n], w), load(&patch.even[4][n], f);
    load(&patch.value[n], value), load(&patch.residual[n], residual);
    w = kNumber < static_cast<float>(patch.count - n) ? w : zero;  // what fills the last group is none of the disc
    const Lanes weight = w > zero ? f * f : zero, m = value - residual / (w > zero ? w : zero + 1.f);
    const Lanes products = weight * m * value, squares = weight * m * m;
    for (int i = 0; i < kLanes; ++i) terms.terms[n + i] = Pair{products[i], squares[i]};
    sums[0] += products, sums[1] += squares, sums[2] += weight * value * value;
  }
  float sum[4];
  totals(sums, sum);
  terms.all = {sum[0], sum[1]}, terms.values = sum[2];
}

using Histogram = std::array<std::array<Pair, kDirections>, kBins>;

Histogram histogram(const Terms& terms, int count) {
  const Bins& all = bins();
  Histogram in{};
  for (int n = 0; n < count; ++n)
    for (int k = 0; k < kDirections; ++k) in[all[n][k]][k] += terms.terms[n];
  return in;
}

// All directions at once, in lanes.
HANDSIGHT_LANES Split best_split(const Histogram& in, const Side& all) {
  const float least = kLeastSide * all.squares;
  Lanes told{}, bin{}, near_products{}, near_squares{}, best_products{}, best_squares{};
  for (int b = 0; b + 1 < kBins; ++b) {
    Lanes first, second;  // four directions each
    std::memcpy(&first, &in[b], sizeof first), std::memcpy(&second, &in[b][kDirections / 2], sizeof second);
    near_products += __builtin_shufflevector(first, second, 0, 2, 4, 6, 8, 10, 12, 14);
    near_squares += __builtin_shufflevector(first, second, 1, 3, 5, 7, 9, 11, 13, 15);
    const Lanes far_products = all.products - near_products, far_squares = all.squares - near_squares;
    const Lanes both = near_products * near_products / near_squares + far_products * far_products / far_squares;
    const Whole better = (both > told) & (near_squares >= least) & (far_squares >= least);
    told = better ? both : told, bin = better ? Lanes{} + static_cast<float>(b) : bin;
    best_products = better ? near_products : best_products, best_squares = better ? near_squares : best_squares;
  }
  Split best;
  for (int k = 0; k < kDirections; ++k) {
    const Side near{best_products[k], best_squares[k]};
    if (told[k] > best.told) best = {told[k], k, static_cast<int>(bin[k]), near, all - near};
  }
  return best;
}

using Products = RowProducts<kUnknowns + 1>;

HANDSIGHT_LANES void products_in_lanes(const float* const* rows, int count, Products& products) {
  all_products<Lanes, kUnknowns + 1>(rows, count, products);
}
HANDSIGHT_WIDE void products_in_wide(const float* const* rows, int count, Products& products) {
  all_products<WideLanes, kUnknowns + 1>(rows, count, products);
}

struct Normal {
  Hessian hessian;
  Vector side;
  double squares = 0, weights = 0;
};

// What is known beforehand of shade and softness stands on the diagonal and, at `model`, on the side.
void add_prior(const CornerModel& model, double noise, Normal& normal) {
  const double shade = noise * noise / (kShadeSigma * kShadeSigma);
  const double soft = noise * noise / (kSoftnessSigma * kSoftnessSigma);
  const double expected = std::hypot(model.blur, kPenumbra);
  normal.hessian(2, 2) += shade, normal.hessian(3, 3) += shade;
  normal.hessian(6, 6) += noise * noise;  // a sharp image says little of its blur
  normal.hessian(12, 12) += soft;
  normal.side.segment<2>(2) -= shade * model.shade;
  normal.side(12) -= soft * (model.shadow.softness - expected);
}

Normal normal_equations(const CornerPatch& patch) {
  // The residual stands last; what fills the last tile is not read.
  std::array<const float*, kUnknowns + kTileOfRows> rows;
  std::size_t n = 0;
  for (const auto& row : patch.odd) rows[n++] = row.data();
  for (const auto& row : patch.even) rows[n++] = row.data();
  for (const auto& row : patch.shadow) rows[n++] = row.data();
  std::fill(rows.begin() + kUnknowns, rows.end(), patch.residual.data());
  Products products;
  (has_wide_lanes() ? products_in_wide : products_in_lanes)(rows.data(), patch.padded, products);
  Normal normal;
  for (int i = 0; i < kUnknowns; ++i) {
    for (int j = 0; j <= i; ++j) normal.hessian(i, j) = normal.hessian(j, i) = products[i][j];
    normal.side(i) = products[kUnknowns][i];
  }
  normal.squares = products[kUnknowns][kUnknowns];
  normal.weights = squared_weights(patch);
  return normal;
}

double prior_cost(const CornerModel& model, double noise) {
  const double soft = model.shadow.softness - std::hypot(model.blur, kPenumbra);
  return noise * noise *
         (model.shade.squaredNorm() / (kShadeSigma * kShadeSigma) + soft * soft / (kSoftnessSigma * kSoftnessSigma));
}

CornerModel moved(const CornerModel& from, const Vector& step) {
  CornerModel to = from;
  const Eigen::Vector2d move = step.head<2>() * std::min(1.0, 0.7 / std::max(step.head<2>().norm(), 1e-9));
  const auto held = [&](int i, double most) { return std::clamp(step(i), -most, most); };
  to.position += move;
  to.shade += step.segment<2>(2);
  for (int i = 0; i < 2; ++i) to.edges[i] += held(4 + i, 0.3);
  to.blur = std::clamp(to.blur + held(6, 0.5), 0.3, 5.0);
  to.level += step(7), to.half_contrast += step(8);
  ShadowEdge& shadow = to.shadow;
  shadow.direction += held(9, 0.4);
  // The line stays where it is as the corner moves.
  shadow.distance +=
      held(10, 1.5) - std::cos(from.shadow.direction) * move.x() - std::sin(from.shadow.direction) * move.y();
  shadow.depth = std::clamp(shadow.depth + held(11, 0.3), -4.0, kMostDepth);
  shadow.softness = std::clamp(shadow.softness + held(12, 0.5), 0.4, 4.0);
  return to;
}

// The same image, told from the corner: where the line has passed it, the corner lies in what was the other light.
CornerModel told_from_corner(const CornerModel& model) {
  if (model.shadow.distance >= 0) return model;
  CornerModel same = model;
  const double there = 1 - model.shadow.depth;
  same.level *= there, same.half_contrast *= there;
  same.shadow.direction += M_PI, same.shadow.distance *= -1, same.shadow.depth = 1 - 1 / there;
  return same;
}

bool evaluate_at(const Image& image, const CornerModel& model, double radius, CornerPatch& patch) {
  const int reach = static_cast<int>(radius) + 1;
  const Eigen::Vector2i centre = pixel_of(model.position);
  if (!is_inside(image, centre, reach)) return false;
  gather(image, centre, reach, patch);
  evaluate(model, radius, 0, patch.count, patch);
  return true;
}

double noise_of(const Normal& normal) {
  return std::max(std::sqrt(normal.squares / std::max(normal.weights - kUnknowns, 1.0)), kLeastNoise);
}

}  // namespace

std::optional<ShadowEdge> likely_shadow(const CornerPatch& patch, const CornerModel& model, Guess guess, double noise) {
  Terms terms;
  fill_terms(patch, terms);
  const Side& all = terms.all;
  const float left = terms.values - all.told();
  const auto too_much = [&](float squares, float most) {
    return guess == Guess::from_circles && squares > most * most * all.squares;
  };
  const double least_gain = kLeastGain * noise * noise;
  if (left < least_gain || too_much(left, kMostLeftByOne)) return std::nullopt;
  const Split split = best_split(histogram(terms, patch.count), all);
  const float gain = split.told - all.told();
  if (!(split.told > 0) || too_much(left - gain, kMostLeftByTwo)) return std::nullopt;
  const float least_told = guess == Guess::fitted ? kLeastTold : kLeastToldOfGuess;
  if (gain < least_told * left || gain < least_gain) return std::nullopt;
  const double angle = M_PI * split.direction / kDirections;
  const Eigen::Vector2d normal(std::cos(angle), std::sin(angle));
  const int bins_from_centre = split.bin - kBins / 2;
  const double along = bins_from_centre + 0.5 - normal.dot(model.position - patch.centre.cast<double>());
  ShadowEdge edge;
  const bool ahead = along >= 0;
  edge.direction = ahead ? angle : angle + M_PI;
  edge.distance = std::abs(along);
  const double here = ahead ? split.near.factor() : split.far.factor();
  const double beyond = ahead ? split.far.factor() : split.near.factor();
  if (!(here > 0.1 && beyond > 0.1)) return std::nullopt;
  edge.depth = 1 - beyond / here;
  edge.softness = std::hypot(model.blur, kPenumbra);
  return edge;
}

std::optional<ShadowFit> fit_with_shadow(const Image& image, const CornerModel& start, double radius,
                                         const Patience& patience, double image_noise, CornerPatch& patch) {
  ShadowFit fit{start, 0};
  if (!evaluate_at(image, start, radius, patch)) return std::nullopt;
  Normal at = normal_equations(patch);
  double damping = 1e-3;
  bool is_at_the_fit = true;  // the patch
  const auto too_much = [&](const Normal& normal, double most, const CornerModel& model) {
    const double noise = noise_of(normal), allowed = most * model.half_contrast;
    return noise * noise > allowed * allowed + image_noise * image_noise;
  };
  if (too_much(at, patience.most_at_first, start)) return std::nullopt;
  for (int i = 0; i < patience.steps; ++i) {
    const double noise = noise_of(at);
    Normal damped = at;
    add_prior(fit.model, noise, damped);
    damped.hessian.diagonal() *= 1 + damping;
    Vector step = damped.side;
    if (!solve<kUnknowns>(damped.hessian, step)) return std::nullopt;
    const CornerModel next = moved(fit.model, step);
    if ((next.position - start.position).norm() > 3 || !evaluate_at(image, next, radius, patch)) return std::nullopt;
    const Normal there = normal_equations(patch);
    const double before = at.squares / at.weights * there.weights + prior_cost(fit.model, noise);
    if (there.squares + prior_cost(next, noise) > before) {
      damping = std::max(10 * damping, 1e-2);
      is_at_the_fit = false;
      if (damping > 1e3) break;
      continue;
    }
    damping *= 0.2;
    fit.model = next, at = there, is_at_the_fit = true;
    if (too_much(at, patience.most_on_the_way, next)) return std::nullopt;
    if (step.head<2>().norm() < 0.01 && std::abs(step(10)) < 0.1) break;
  }
  is_at_the_fit &= fit.model.shadow.distance >= 0;
  fit.model = told_from_corner(fit.model);
  if (!is_at_the_fit && !evaluate_at(image, fit.model, radius, patch)) return std::nullopt;
  fit.noise = noise_of(at);
  return fit;
}

Eigen::Matrix2d position_covariance_with_shadow(double noise, const CornerModel& model, CornerPatch& patch) {
  Normal normal = normal_equations(patch);
  add_prior(model, noise, normal);
  const Hessian inverse = normal.hessian.inverse();
  const auto weigh = [&](CornerPatch::Row& row) {
    for (int n = 0; n < patch.padded; ++n) row[n] *= patch.weight[n];
  };
  std::for_each(patch.odd.begin(), patch.odd.end(), weigh);
  std::for_each(patch.even.begin(), patch.even.end(), weigh);
  std::for_each(patch.shadow.begin(), patch.shadow.end(), weigh);
  Normal spread = normal_equations(patch);
  add_prior(model, noise, spread);
  return noise * noise * (inverse * spread.hessian * inverse).topLeftCorner<2, 2>();
}

}  // namespace handsight
