// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_shadow.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "vision/corners/corner_model.h"
#include "vision/corners/corner_products.h"
#include "vision/corners/corner_simd.h"
#include "vision/corners/corner_solve.h"

namespace handsight {
namespace {

constexpr int unknown_count = 13;       // position, shade; edges, blur, level, half contrast; the shadow's four
constexpr double softness_sigma = 0.5;  // px: the edges of near and far things' shadows

using Hessian = Eigen::Matrix<double, unknown_count, unknown_count>;
using Vector = Eigen::Matrix<double, unknown_count, 1>;

using Products = RowProducts<unknown_count + 1>;

HANDSIGHT_LANES void products_simd(const float* const* rows, int count, Products& products) {
  all_products<Simd, unknown_count + 1>(rows, count, products);
}
HANDSIGHT_WIDE void products_in_wide(const float* const* rows, int count, Products& products) {
  all_products<WideSimd, unknown_count + 1>(rows, count, products);
}

struct Normal {
  Hessian hessian;
  Vector side;
  double squares = 0, weights = 0;
};

// What is known beforehand of shade and softness stands on the diagonal and, at `model`, on the side.
void add_prior(const CornerModel& model, double noise, Normal& normal) {
  const double shade = noise * noise / (shade_sigma * shade_sigma);
  const double soft = noise * noise / (softness_sigma * softness_sigma);
  const double expected = std::hypot(model.blur, penumbra_px);
  normal.hessian(2, 2) += shade, normal.hessian(3, 3) += shade;
  normal.hessian(6, 6) += noise * noise;  // a sharp image says little of its blur
  normal.hessian(12, 12) += soft;
  normal.side.segment<2>(2) -= shade * model.shade;
  normal.side(12) -= soft * (model.shadow.softness - expected);
}

Normal normal_equations(const CornerPatch& patch) {
  // The residual stands last; what fills the last tile is not read.
  std::array<const float*, unknown_count + tile_of_rows> rows;
  std::size_t n = 0;
  for (const auto& row : patch.odd) rows[n++] = row.data();
  for (const auto& row : patch.even) rows[n++] = row.data();
  for (const auto& row : patch.shadow) rows[n++] = row.data();
  std::fill(rows.begin() + unknown_count, rows.end(), patch.residual.data());
  Products products;
  (has_wide_simd() ? products_in_wide : products_simd)(rows.data(), patch.padded, products);
  Normal normal;
  for (int i = 0; i < unknown_count; ++i) {
    for (int j = 0; j <= i; ++j) normal.hessian(i, j) = normal.hessian(j, i) = products[i][j];
    normal.side(i) = products[unknown_count][i];
  }
  normal.squares = products[unknown_count][unknown_count];
  normal.weights = squared_weights(patch);
  return normal;
}

double prior_cost(const CornerModel& model, double noise) {
  const double soft = model.shadow.softness - std::hypot(model.blur, penumbra_px);
  return noise * noise *
         (model.shade.squaredNorm() / (shade_sigma * shade_sigma) + soft * soft / (softness_sigma * softness_sigma));
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
  shadow.depth = std::clamp(shadow.depth + held(11, 0.3), most_lit_beyond, most_depth);
  shadow.softness = std::clamp(shadow.softness + held(12, 0.5), 0.4, 4.0);
  return to;
}

bool evaluate_at(const Image& image, const CornerModel& model, double radius, Sharing sharing, CornerPatch& patch) {
  const int reach = static_cast<int>(radius) + 1;
  const Eigen::Vector2i centre = nearest_pixel(model.position);
  if (!is_inside(image, centre, reach)) return false;
  gather(image, centre, reach, patch);
  evaluate(model, radius, 0, patch.count, patch, sharing);
  return true;
}

double find_noise(const Normal& normal) {
  return std::max(std::sqrt(normal.squares / std::max(normal.weights - unknown_count, 1.0)), least_noise);
}

}  // namespace

std::optional<ShadowFit> fit_with_shadow(const Image& image, const CornerModel& start, double radius,
                                         const Patience& patience, double image_noise, CornerPatch& patch) {
  ShadowFit fit{start, 0};
  if (!evaluate_at(image, start, radius, patience.sharing, patch)) return std::nullopt;
  Normal at = normal_equations(patch);
  double damping = 1e-3;
  bool is_at_the_fit = true;  // the patch
  const auto too_much = [&](const Normal& normal, double most, const CornerModel& model) {
    const double noise = find_noise(normal), allowed = most * half_contrast_in_light(model);
    return noise * noise > allowed * allowed + image_noise * image_noise;
  };
  if (too_much(at, patience.most_at_first, start)) return std::nullopt;
  for (int i = 0; i < patience.steps; ++i) {
    const double noise = find_noise(at);
    Normal damped = at;
    add_prior(fit.model, noise, damped);
    damped.hessian.diagonal() *= 1 + damping;
    Vector step = damped.side;
    if (!solve<unknown_count>(damped.hessian, step)) return std::nullopt;
    const CornerModel next = moved(fit.model, step);
    if ((next.position - start.position).norm() > 3 || !evaluate_at(image, next, radius, patience.sharing, patch))
      return std::nullopt;
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
  if (!is_at_the_fit && !evaluate_at(image, fit.model, radius, patience.sharing, patch)) return std::nullopt;
  fit.noise = find_noise(at);
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
