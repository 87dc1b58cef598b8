// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_model.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "vision/corners/corner_fit.h"
#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_solve.h"

namespace handsight {
namespace {

constexpr double first_radius = 4;     // px: 50 pixels, enough for nine unknowns
constexpr double small_radius = 3;     // px: 25 pixels
constexpr int most_small_radius = 6;   // px
constexpr int second_radius = 7;       // px: the edges' directions must be known better before it grows on
constexpr double loose_factor = 1.5;   // what bounds are wider over the first disc
constexpr double less_loose = 1.25;    // over the second
constexpr double most_shared = 0.15;   // half contrasts, of the first disc's residuals, by what neighbours share
constexpr double precision_px = 0.05;  // px: after so short a step the next would be a tenth of it

using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Vector5 = Eigen::Matrix<double, 5, 1>;

double shade_prior(double noise) { return noise * noise / (shade_sigma * shade_sigma); }

Eigen::Matrix4d odd_hessian(const std::array<float, 10>& odd, double noise) {
  Eigen::Matrix4d hessian = from_triangle<4>(odd.data());
  hessian.diagonal().tail<2>().array() += shade_prior(noise);
  return hessian;
}

double find_noise(const PatchSums& sum) {
  return std::max(std::sqrt(sum.squares / std::max(sum.weights - 9.0, 1.0)), least_noise);
}

struct Step {
  double length = 0;    // px; a radian or a px of blur counts half
  double decrease = 0;  // of the sum of squares, if the model were linear
};

// One step of both blocks, of the even one a `share`; nothing where the normal equations are singular.
std::optional<Step> step(const PatchSums& sum, double noise, double share, CornerModel& model) {
  Eigen::Vector4d odd_step = Eigen::Map<const Eigen::Vector4f>(sum.odd_side.data()).cast<double>();
  odd_step.tail<2>() -= shade_prior(noise) * model.shade;
  Vector5 even_step = Eigen::Map<const Eigen::Matrix<float, 5, 1>>(sum.even_side.data()).cast<double>();
  Matrix5 even = from_triangle<5>(sum.even.data());
  even.diagonal() *= 1 + 1e-3;
  even(2, 2) += noise * noise;  // a sharp image says little of its blur
  if (!solve<4>(odd_hessian(sum.odd, noise), odd_step) || !solve<5>(even, even_step)) return std::nullopt;
  Step made;
  made.decrease = odd_step.dot(Eigen::Map<const Eigen::Vector4f>(sum.odd_side.data()).cast<double>()) +
                  even_step.dot(Eigen::Map<const Eigen::Matrix<float, 5, 1>>(sum.even_side.data()).cast<double>());
  // Blur and contrast balance each other: where one is held back the other must be too.
  even_step *= std::min(share, 0.5 / std::max(std::abs(even_step(2)), 1e-9));
  const double length = odd_step.head<2>().norm(), turn = even_step.head<2>().cwiseAbs().maxCoeff();
  model.position += odd_step.head<2>() * std::min(1.0, 0.7 / std::max(length, 1e-9));
  model.shade += odd_step.tail<2>();
  for (int i = 0; i < 2; ++i) model.edges[i] += std::clamp(even_step(i), -0.3, 0.3);
  model.blur = std::clamp(model.blur + even_step(2), 0.3, 5.0);
  model.level += even_step(3);
  model.half_contrast += even_step(4);
  made.length = std::max(length, 0.5 * std::max(turn, std::abs(even_step(2))));
  return made;
}

struct Progress {
  double image_noise = 0;  // grey levels
  CornerPatch patch;
  PatchSums sum;
  double noise = 0;    // grey levels
  double promise = 0;  // grey levels, what the noise would be after the last step if the model were linear
  double length = 1;   // px, of the last step, as Step::length
};

// What the noise will be at least, after one more step, against the bound that it must meet at the end: a saddle that
// is no corner need not be fitted to the end.
bool promises_well(const CornerModel& model, double promise, double image_noise, double loose) {
  const double misfit = most_misfit * model.half_contrast;
  return promise * promise < loose * (misfit * misfit + 1.6 * image_noise * image_noise);
}

// By how much the bounds are wider over the first disc, where blur and contrast are hard to tell from each other and a
// camera's sharpening weighs more, and how far what the first step and later ones promise may be beyond the last bound.
struct Looseness {
  double look, first_promise, promise;
};
constexpr Looseness first_look{2 * loose_factor, 4, 2.5}, second_look{loose_factor, 2, 2}, grown{1, 2, 1.3};

// Steps until a step is shorter than `precision` px; false where the fit fails.
bool fit_disc(const Image& image, double radius, int iterations, double precision, const Looseness& loose, Progress& at,
              CornerModel& model) {
  const int reach = static_cast<int>(radius) + 1;
  for (int i = 0; i < iterations; ++i) {
    const Eigen::Vector2i centre = nearest_pixel(model.position);
    if (!is_inside(image, centre, reach)) return false;
    gather(image, centre, reach, at.patch);
    evaluate(model, radius, 0, at.patch.count, at.patch);
    at.sum = sums(at.patch);
    const double before = at.noise;
    at.noise = find_noise(at.sum);
    // Edges and contrast of a corner that overexposure has torn apart swing to and fro unless held back.
    const double share = before > 0 && at.noise > before ? 0.5 : 1.0;
    const std::optional<Step> made = step(at.sum, at.noise, share, model);
    if (!made) return false;
    at.promise = std::sqrt(std::max(at.sum.squares - made->decrease, 0.0) / std::max(at.sum.weights - 9.0, 1.0));
    if (!promises_well(model, at.promise, at.image_noise, i == 0 ? loose.first_promise : loose.promise)) return false;
    at.length = made->length;
    if (made->length < precision) break;
  }
  return true;
}

// The weights fall off at the rim though the noise does not rise there, so the covariance is not the Hessian's inverse
// alone: H^-1 (sum w^4 J J^T + prior) H^-1 of all odd parameters, of which the position is the first block.
Eigen::Matrix2d position_covariance(Progress& at) {
  const Eigen::Matrix4d inverse = odd_hessian(at.sum.odd, at.noise).inverse();
  for (CornerPatch::Row& row : at.patch.odd)
    for (int n = 0; n < at.patch.padded; ++n) row[n] *= at.patch.weight[n];
  const Eigen::Matrix4d spread = odd_hessian(odd_sums(at.patch), at.noise);
  return at.noise * at.noise * (inverse * spread * inverse).topLeftCorner<2, 2>();
}

}  // namespace

CornerModel first_guess(const Eigen::Vector2d& start, const CrossStructure& cross) {
  CornerModel model;
  model.position = start, model.edges = cross.edges;
  model.level = cross.level, model.half_contrast = cross.half_contrast, model.blur = cross.blur;
  return model;
}

namespace {

CornerFit begun(const Eigen::Vector2d& start, const CrossStructure& cross, double radius) {
  CornerFit fit;
  fit.model = first_guess(start, cross);
  fit.radius = radius;
  return fit;
}

}  // namespace

std::optional<CornerFit> fit_corner(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross,
                                    double image_noise) {
  CornerFit fit = begun(start, cross, first_radius);
  CornerModel& model = fit.model;
  Progress at;
  at.image_noise = image_noise;
  for (const Looseness& loose : {first_look, second_look}) {
    if (at.length < precision_px) {  // another step would change nothing that the next disc does not
      if (!promises_well(model, at.promise, image_noise, loose.promise)) return std::nullopt;
    } else if (!fit_disc(image, fit.radius, 2, precision_px, loose, at, model)) {
      return std::nullopt;
    }
    if (!looks_right(model, cross.half_contrast, at.noise, image_noise, loose.look)) return std::nullopt;
  }
  if ((model.position - start).norm() > most_move) return std::nullopt;
  fit.misfit = compute_misfit(at.patch);
  if (fit.misfit > most_shared * std::abs(model.half_contrast)) return std::nullopt;
  fit.radius = grown_radius(image, first_radius, second_radius, at.noise, model, at.patch);
  if (fit.radius > first_radius) {
    if (!fit_disc(image, fit.radius, 3, 0.2, grown, at, model)) return std::nullopt;
    if ((model.position - start).norm() > less_loose * most_move ||
        !looks_right(model, cross.half_contrast, at.promise, image_noise, less_loose))
      return std::nullopt;
    fit.radius = grown_radius(image, fit.radius, most_patch_radius, at.noise, model, at.patch);
  } else if (model.blur > most_blur * fit.radius + 0.3 || !promises_well(model, at.promise, image_noise, 1.05)) {
    return std::nullopt;
  }
  if (!fit_disc(image, fit.radius, 4, precision_px, grown, at, model)) return std::nullopt;
  at.noise = std::max(at.promise, least_noise);  // after the last step
  if ((model.position - start).norm() > most_move || !looks_right(model, cross.half_contrast, at.noise, image_noise, 1))
    return std::nullopt;
  if (model.blur > most_blur * fit.radius) return std::nullopt;
  fit.noise = at.noise;
  fit.is_clipped = at.patch.is_clipped;
  fit.covariance = position_covariance(at);
  return is_determined(fit) ? std::optional(fit) : std::nullopt;
}

std::optional<CornerFit> fit_small_corner(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross,
                                          double image_noise) {
  CornerFit fit = begun(start, cross, small_radius);
  CornerModel& model = fit.model;
  Progress at;
  at.image_noise = image_noise;
  const auto fits = [&](int steps, const Looseness& loose) {
    return fit_disc(image, fit.radius, steps, precision_px, loose, at, model) &&
           (model.position - start).norm() < most_move &&
           looks_right(model, cross.half_contrast, at.promise, image_noise, std::min(loose.look, loose_factor));
  };
  if (!fits(3, first_look)) return std::nullopt;
  fit.radius = grown_radius(image, small_radius, most_small_radius, at.noise, model, at.patch);
  if (!fits(4, grown) || model.blur > most_blur * fit.radius) return std::nullopt;
  fit.misfit = compute_misfit(at.patch);
  fit.noise = std::max(at.promise, least_noise);
  fit.is_clipped = at.patch.is_clipped;
  at.noise = fit.noise;
  fit.covariance = position_covariance(at);
  return is_determined(fit) ? std::optional(fit) : std::nullopt;
}

CornerModel told_from_corner(const CornerModel& model) {
  if (model.shadow.distance >= 0) return model;
  CornerModel same = model;
  const double there = 1 - model.shadow.depth;
  same.level *= there, same.half_contrast *= there;
  same.shadow.direction += M_PI, same.shadow.distance *= -1, same.shadow.depth = 1 - 1 / there;
  return same;
}

ShadowEdge seen_from(const ShadowEdge& shadow, const Eigen::Vector2d& off) {
  ShadowEdge same = shadow;
  same.distance -= std::cos(shadow.direction) * off.x() + std::sin(shadow.direction) * off.y();
  return same;
}

double light_at(const ShadowEdge& shadow, const Eigen::Vector2d& from_corner) {
  const Eigen::Vector2d normal(std::cos(shadow.direction), std::sin(shadow.direction));
  const double beyond = normal.dot(from_corner) - shadow.distance;
  return 1 - 0.5 * shadow.depth * (1 + std::erf(M_SQRT1_2 * beyond / shadow.softness));
}

}  // namespace handsight
