// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_model.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "vision/corner_lanes.h"
#include "vision/corner_patch.h"
#include "vision/corner_shadow.h"
#include "vision/corner_solve.h"

namespace handsight {
namespace {

constexpr double kFirstRadius = 4;   // px: 50 pixels, enough for nine unknowns
constexpr double kSmallRadius = 3;   // px: 25 pixels
constexpr int kMostSmallRadius = 6;  // px
constexpr int kSecondRadius = 7;     // px: the edges' directions must be known better before it grows on
constexpr double kLoose = 1.5;       // what bounds are wider over the first disc
constexpr double kLessLoose = 1.25;  // over the second
constexpr double kMostMove = 1.8;    // px, from the start
constexpr double kMostMoveInShadow = 2.5;
constexpr double kMostMisfit = 0.21;    // half contrasts; sharpening in the camera leaves less
constexpr double kMostShared = 0.15;    // half contrasts, of the first disc's residuals, by what neighbours share
constexpr double kMostGain = 2.6;       // times the contrast that the circles showed
constexpr double kMostBlur = 0.6;       // radii: a saddle that never becomes flat is no corner
constexpr int kShadowRadius = 6;        // px, of the disc on which corner and shadow are fitted first
constexpr int kShadowReach = 9;         // px, where a shadow's edge is looked for
constexpr double kLeastDepth = 0.08;    // of a shadow: less is uneven light
constexpr double kNearestShadow = 1.5;  // px: an edge through the corner is one of its own
constexpr double kPrecision = 0.05;     // px: after so short a step the next would be a tenth of it

using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Vector5 = Eigen::Matrix<double, 5, 1>;

double shade_prior(double noise) { return noise * noise / (kShadeSigma * kShadeSigma); }

Eigen::Matrix4d odd_hessian(const std::array<float, 10>& odd, double noise) {
  Eigen::Matrix4d hessian = from_triangle<4>(odd.data());
  hessian.diagonal().tail<2>().array() += shade_prior(noise);
  return hessian;
}

double noise_of(const PatchSums& sum) {
  return std::max(std::sqrt(sum.squares / std::max(sum.weights - 9.0, 1.0)), kLeastNoise);
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
  const double misfit = kMostMisfit * model.half_contrast;
  return promise * promise < loose * (misfit * misfit + 1.6 * image_noise * image_noise);
}

// By how much the bounds are wider over the first disc, where blur and contrast are hard to tell from each other and a
// camera's sharpening weighs more, and how far what the first step and later ones promise may be beyond the last bound.
struct Looseness {
  double look, first_promise, promise;
};
constexpr Looseness kFirstLook{2 * kLoose, 4, 2.5}, kSecondLook{kLoose, 2, 2}, kGrown{1, 2, 1.3};

// Steps until a step is shorter than `precision` px; false where the fit fails.
bool fit_disc(const Image& image, double radius, int iterations, double precision, const Looseness& loose, Progress& at,
              CornerModel& model) {
  const int reach = static_cast<int>(radius) + 1;
  for (int i = 0; i < iterations; ++i) {
    const Eigen::Vector2i centre = pixel_of(model.position);
    if (!is_inside(image, centre, reach)) return false;
    gather(image, centre, reach, at.patch);
    evaluate(model, radius, 0, at.patch.count, at.patch);
    at.sum = sums(at.patch);
    const double before = at.noise;
    at.noise = noise_of(at.sum);
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

// How far the model holds, px: ring by ring, as long as the residuals stay what they are inside.
double grown_radius(const Image& image, double radius, int most, Progress& at, const CornerModel& model) {
  const Eigen::Vector2i centre = pixel_of(model.position);
  while (most > radius && !is_inside(image, centre, most + 1)) --most;
  if (most <= radius) return radius;
  gather(image, centre, most + 1, at.patch);
  const double bound = 2 * at.noise * at.noise + 0.02 * model.half_contrast * model.half_contrast;
  int n = pixels_in_disc(static_cast<int>(radius)), evaluated = n / kWideLanes * kWideLanes;
  for (int r = static_cast<int>(radius) + 1; r <= most; ++r) {
    const int begin = n, end = pixels_in_disc(r);
    if (end > evaluated) evaluate_residuals(model, most + 1, evaluated, end, at.patch), evaluated = in_groups(end);
    double squares = 0;
    for (; n < end; ++n) squares += at.patch.residual[n] * at.patch.residual[n];
    if (squares > bound * (end - begin)) return r - 1;
  }
  return most;
}

// Root of the mean product of neighbouring residuals: of white noise nothing remains, of a wrong shape most does.
double misfit_of(const CornerPatch& patch) {
  constexpr int kReach = 5, kSide = 2 * kReach + 2;
  static const std::vector<int> places = [] {
    std::vector<int> all;
    for (int n = 0; n < pixels_in_disc(kReach); ++n) {
      const Eigen::Vector2i offset = offset_of_pixel(n);
      all.push_back((offset.y() + kReach) * kSide + offset.x() + kReach);
    }
    return all;
  }();
  std::array<float, kSide*(kSide + 1)> residual{}, weight{};
  const std::size_t count = std::min(static_cast<std::size_t>(patch.count), places.size());
  for (std::size_t n = 0; n < count; ++n) residual[places[n]] = patch.residual[n], weight[places[n]] = patch.weight[n];
  std::array<float, kSide> products_of{}, weights_of{};  // column by column, which do not wait for each other
  for (int v = 0; v < kSide; ++v)
    for (int u = 0; u < kSide; ++u) {
      const int n = v * kSide + u;
      products_of[u] += residual[n] * (residual[n + 1] + residual[n + kSide]);
      weights_of[u] += weight[n] * (weight[n + 1] + weight[n + kSide]);
    }
  const float products = std::accumulate(products_of.begin(), products_of.end(), 0.f);
  const float weights = std::accumulate(weights_of.begin(), weights_of.end(), 0.f);
  return std::sqrt(std::max(products / std::max(weights, 1.f), 0.f));
}

// A fit of corner and shadow together: on the first disc, from where most that are no corners show it within three
// steps; there to the end; and on as large a disc as it holds for.
struct ShadowStage {
  bool grows;
  double loose;
  Patience patience;
};
constexpr std::array<ShadowStage, 3> kShadowStages{
    {{false, 2.25, {3, 1.2, 0.5}}, {false, 1.2, {5, 1, 0.4}}, {true, 1, {5, 1, 1}}}};

// Where both are known well beforehand.
constexpr std::array<ShadowStage, 2> kKnownShadowStages{{{false, 1.5, {6, 1, 0.6}}, {true, 1, {5, 1, 1}}}};
constexpr double kKnownShadowRadius = 5;  // px
constexpr double kMostTurn = 0.35;        // sine, of a shadow's edge against that seen elsewhere

// Bounds beyond what X-corners of 8 px cells show at 60 deg and 2.5 px of blur. Over the first disc blur and contrast
// are hard to tell from each other, so there they are `loose`.
bool looks_right(const CornerModel& model, const CrossStructure& cross, double noise, double image_noise,
                 double loose) {
  const double half = std::abs(model.half_contrast), misfit = kMostMisfit * loose * half;
  return half < kMostGain * loose * std::abs(cross.half_contrast) && model.blur < 3.2 * loose &&
         noise * noise < misfit * misfit + 1.6 * loose * image_noise * image_noise &&
         std::abs(std::sin(model.edges[0] - model.edges[1])) > 0.4 / loose;
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

// Edges nearly along each other leave the position open; what rounding makes of its covariance then is none.
bool is_determined(const CornerFit& fit) { return fit.covariance(0, 0) > 0 && fit.covariance.determinant() > 0; }

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
  CornerFit fit = begun(start, cross, kFirstRadius);
  CornerModel& model = fit.model;
  Progress at;
  at.image_noise = image_noise;
  for (const Looseness& loose : {kFirstLook, kSecondLook}) {
    if (at.length < kPrecision) {  // another step would change nothing that the next disc does not
      if (!promises_well(model, at.promise, image_noise, loose.promise)) return std::nullopt;
    } else if (!fit_disc(image, fit.radius, 2, kPrecision, loose, at, model)) {
      return std::nullopt;
    }
    if (!looks_right(model, cross, at.noise, image_noise, loose.look)) return std::nullopt;
  }
  if ((model.position - start).norm() > kMostMove) return std::nullopt;
  fit.misfit = misfit_of(at.patch);
  if (fit.misfit > kMostShared * std::abs(model.half_contrast)) return std::nullopt;
  fit.radius = grown_radius(image, kFirstRadius, kSecondRadius, at, model);
  if (fit.radius > kFirstRadius) {
    if (!fit_disc(image, fit.radius, 3, 0.2, kGrown, at, model)) return std::nullopt;
    if ((model.position - start).norm() > kLessLoose * kMostMove ||
        !looks_right(model, cross, at.promise, image_noise, kLessLoose))
      return std::nullopt;
    fit.radius = grown_radius(image, fit.radius, kMostPatchRadius, at, model);
  } else if (model.blur > kMostBlur * fit.radius + 0.3 || !promises_well(model, at.promise, image_noise, 1.05)) {
    return std::nullopt;
  }
  if (!fit_disc(image, fit.radius, 4, kPrecision, kGrown, at, model)) return std::nullopt;
  at.noise = std::max(at.promise, kLeastNoise);  // after the last step
  if ((model.position - start).norm() > kMostMove || !looks_right(model, cross, at.noise, image_noise, 1))
    return std::nullopt;
  if (model.blur > kMostBlur * fit.radius) return std::nullopt;
  fit.noise = at.noise;
  fit.is_clipped = at.patch.is_clipped;
  fit.covariance = position_covariance(at);
  return is_determined(fit) ? std::optional(fit) : std::nullopt;
}

std::optional<CornerFit> fit_small_corner(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross,
                                          double image_noise) {
  CornerFit fit = begun(start, cross, kSmallRadius);
  CornerModel& model = fit.model;
  Progress at;
  at.image_noise = image_noise;
  const auto fits = [&](int steps, const Looseness& loose) {
    return fit_disc(image, fit.radius, steps, kPrecision, loose, at, model) &&
           (model.position - start).norm() < kMostMove &&
           looks_right(model, cross, at.promise, image_noise, std::min(loose.look, kLoose));
  };
  if (!fits(3, kFirstLook)) return std::nullopt;
  fit.radius = grown_radius(image, kSmallRadius, kMostSmallRadius, at, model);
  if (!fits(4, kGrown) || model.blur > kMostBlur * fit.radius) return std::nullopt;
  fit.misfit = misfit_of(at.patch);
  fit.noise = std::max(at.promise, kLeastNoise);
  fit.is_clipped = at.patch.is_clipped;
  at.noise = fit.noise;
  fit.covariance = position_covariance(at);
  return is_determined(fit) ? std::optional(fit) : std::nullopt;
}

std::optional<CornerFit> fit_beside_shadow(const Image& image, const Eigen::Vector2d& start,
                                           const CrossStructure& cross, const CornerModel& first, Guess guess,
                                           double image_noise) {
  Progress at;
  at.image_noise = image_noise;
  int reach = kShadowReach;
  const Eigen::Vector2i centre = pixel_of(first.position);
  while (reach > kShadowRadius && !is_inside(image, centre, reach)) --reach;
  if (!is_inside(image, centre, reach)) return std::nullopt;
  gather(image, centre, reach, at.patch);
  // With a rim so far out that all pixels have their full weight.
  evaluate_residuals(first, reach + 2, 0, at.patch.count, at.patch);
  const auto edge = likely_shadow(at.patch, first, guess, image_noise);
  if (!edge) return std::nullopt;
  CornerFit fit;
  fit.model = first;
  fit.model.shadow = *edge;
  fit.radius = kShadowRadius;
  for (const ShadowStage& stage : kShadowStages) {
    if (stage.grows) fit.radius = grown_radius(image, fit.radius, kMostPatchRadius, at, fit.model);
    const auto found = fit_with_shadow(image, fit.model, fit.radius, stage.patience, image_noise, at.patch);
    if (!found || !looks_right(found->model, cross, found->noise, image_noise, stage.loose)) return std::nullopt;
    fit.model = found->model, fit.noise = at.noise = found->noise;
  }
  if ((fit.model.position - start).norm() > kMostMoveInShadow || fit.model.blur > kMostBlur * fit.radius)
    return std::nullopt;
  if (std::abs(fit.model.shadow.depth) < kLeastDepth || fit.model.shadow.distance < kNearestShadow) return std::nullopt;
  fit.misfit = misfit_of(at.patch);
  fit.is_clipped = at.patch.is_clipped;
  fit.covariance = position_covariance_with_shadow(fit.noise, fit.model, at.patch);
  return is_determined(fit) ? std::optional(fit) : std::nullopt;
}

std::optional<CornerFit> fit_in_known_shadow(const Image& image, const CornerModel& expected, double image_noise) {
  CrossStructure cross;
  cross.half_contrast = expected.half_contrast;
  Progress at;
  at.image_noise = image_noise;
  CornerFit fit;
  fit.model = expected, fit.radius = kKnownShadowRadius;
  for (const ShadowStage& stage : kKnownShadowStages) {
    if (stage.grows) fit.radius = grown_radius(image, fit.radius, kMostPatchRadius, at, fit.model);
    const auto found = fit_with_shadow(image, fit.model, fit.radius, stage.patience, image_noise, at.patch);
    if (!found || !looks_right(found->model, cross, found->noise, image_noise, stage.loose)) return std::nullopt;
    fit.model = found->model, fit.noise = at.noise = found->noise;
  }
  const ShadowEdge seen = seen_from(expected.shadow, fit.model.position - expected.position);
  const double turn = seen.direction - fit.model.shadow.direction;
  const double apart = std::cos(turn) * seen.distance - fit.model.shadow.distance;
  if ((fit.model.position - expected.position).norm() > kMostMove || fit.model.blur > kMostBlur * fit.radius ||
      std::abs(std::sin(turn)) > kMostTurn || std::abs(apart) > kMostMove)
    return std::nullopt;
  fit.misfit = misfit_of(at.patch);
  fit.is_clipped = at.patch.is_clipped;
  fit.covariance = position_covariance_with_shadow(fit.noise, fit.model, at.patch);
  return is_determined(fit) ? std::optional(fit) : std::nullopt;
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
