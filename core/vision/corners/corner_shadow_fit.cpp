// SPDX-License-Identifier: Apache-2.0
// The fits of corner_model.h beside a shadow's edge.
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "vision/corners/corner_fit.h"
#include "vision/corners/corner_model.h"
#include "vision/corners/corner_patch.h"
#include "vision/corners/corner_shadow.h"

namespace handsight {
namespace {

constexpr double most_move_in_shadow = 2.5;  // px
constexpr int shadow_radius = 6;             // px, of the disc on which corner and shadow are fitted first
constexpr int shadow_reach = 9;              // px, where a shadow's edge is looked for
constexpr double least_depth = 0.08;         // of a shadow: less is uneven light
constexpr double nearest_shadow = 1.5;       // px: an edge through the corner is one of its own

// A fit of corner and shadow together: on the first disc, from where most that are no corners show it within three
// steps; there to the end; and on as large a disc as it holds for.
struct ShadowStage {
  bool grows;
  double loose;
  Patience patience;
};
constexpr std::array<ShadowStage, 3> shadow_stages{{{false, 2.25, {3, 1.2, 0.5, Sharing::of_corner}},
                                                    {false, 1.2, {5, 1, 0.4, Sharing::of_corner}},
                                                    {true, 1, {5, 1, 1}}}};

// Where both are known well beforehand.
constexpr std::array<ShadowStage, 2> known_shadow_stages{{{false, 1.5, {6, 1, 0.6}}, {true, 1, {5, 1, 1}}}};
constexpr double known_shadow_radius = 5;  // px
constexpr double most_turn = 0.35;         // sine, of a shadow's edge against that seen elsewhere

// The edge of a shadow in what a model leaves within 9 px, or within 6 where that leaves the image.
std::optional<ShadowEdge> shadow_beside(const Image& image, const CornerModel& model, Guess guess, double image_noise,
                                        CornerPatch& patch) {
  int reach = shadow_reach;
  const Eigen::Vector2i centre = nearest_pixel(model.position);
  while (reach > shadow_radius && !is_inside(image, centre, reach)) --reach;
  if (!is_inside(image, centre, reach)) return std::nullopt;
  gather(image, centre, reach, patch);
  // With a rim so far out that all pixels have their full weight.
  evaluate_residuals(model, reach + 2, 0, patch.count, patch);
  return likely_shadow(patch, model, guess, image_noise);
}

// Stage by stage from the model and the radius that `fit` begins with; false where any fails. `half_contrast`: that
// the corner should have.
bool fit_stages(const Image& image, std::span<const ShadowStage> stages, double half_contrast, double image_noise,
                CornerPatch& patch, CornerFit& fit) {
  for (const ShadowStage& stage : stages) {
    if (stage.grows) fit.radius = grown_radius(image, fit.radius, most_patch_radius, fit.noise, fit.model, patch);
    const auto found = fit_with_shadow(image, fit.model, fit.radius, stage.patience, image_noise, patch);
    if (!found || !looks_right(found->model, half_contrast, found->noise, image_noise, stage.loose)) return false;
    fit.model = found->model, fit.noise = found->noise;
  }
  if (fit.model.blur > most_blur * fit.radius || std::abs(fit.model.shadow.depth) < least_depth) return false;
  fit.misfit = compute_misfit(patch);
  fit.is_clipped = patch.is_clipped;
  fit.covariance = position_covariance_with_shadow(fit.noise, fit.model, patch);
  return is_determined(fit);
}

}  // namespace

std::optional<CornerFit> fit_beside_shadow(const Image& image, const Eigen::Vector2d& start,
                                           const CrossStructure& cross, const CornerModel& first, Guess guess,
                                           double image_noise) {
  CornerPatch patch;
  const auto edge = shadow_beside(image, first, guess, image_noise, patch);
  if (!edge) return std::nullopt;
  CornerFit fit;
  fit.model = first, fit.radius = shadow_radius;
  fit.model.shadow = *edge;
  if (!fit_stages(image, shadow_stages, cross.half_contrast, image_noise, patch, fit)) return std::nullopt;
  const bool is_right =
      (fit.model.position - start).norm() < most_move_in_shadow && fit.model.shadow.distance > nearest_shadow;
  return is_right ? std::optional(fit) : std::nullopt;
}

namespace {

std::optional<CornerFit> fit_as_known(const Image& image, const CornerModel& expected, double image_noise,
                                      CornerPatch& patch) {
  CornerFit fit;
  fit.model = lit_as_seen(image, expected, known_shadow_radius, patch), fit.radius = known_shadow_radius;
  if (!fit_stages(image, known_shadow_stages, half_contrast_in_light(fit.model), image_noise, patch, fit))
    return std::nullopt;
  const ShadowEdge seen = seen_from(expected.shadow, fit.model.position - expected.position);
  const double turn = seen.direction - fit.model.shadow.direction;
  const double apart = std::cos(turn) * seen.distance - fit.model.shadow.distance;
  const bool is_right = (fit.model.position - expected.position).norm() < most_move &&
                        fit.model.shadow.distance < fit.radius && std::abs(std::sin(turn)) < most_turn &&
                        std::abs(apart) < most_move;
  return is_right ? std::optional(fit) : std::nullopt;
}

}  // namespace

std::optional<CornerFit> fit_in_known_shadow(const Image& image, const CornerModel& expected, double image_noise) {
  CornerPatch patch;
  return fit_as_known(image, expected, image_noise, patch);
}

std::optional<CornerFit> fit_in_unknown_shadow(const Image& image, const CornerModel& expected, double image_noise) {
  CornerPatch patch;
  const auto edge = shadow_beside(image, expected, Guess::fitted, image_noise, patch);
  if (!edge) return std::nullopt;
  CornerModel beside = expected;
  beside.shadow = *edge;
  return fit_as_known(image, beside, image_noise, patch);
}

}  // namespace handsight
