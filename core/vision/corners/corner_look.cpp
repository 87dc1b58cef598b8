// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_look.h"

#include <algorithm>
#include <cmath>

#include "vision/corners/corner_model.h"
#include "vision/corners/corner_structure.h"
#include "vision/corners/corner_symmetry.h"

namespace handsight {
namespace {

constexpr double most_sigma = 0.3;      // px: a corner that is not known better than this helps nobody
constexpr double most_apart = 0.6;      // px, between the points of best symmetry and best fit
constexpr double most_asymmetry = 0.3;  // half contrasts, beyond what the noise explains

constexpr double most_beyond = 0.1, most_cut_off = 0.2;  // contrasts, beyond what pixels can tell

constexpr double likely_shade = 0.005;    // 1/px: light that changes faster may be a shadow's edge
constexpr double least_of_shadow = 0.03;  // contrasts: opposite points differ by more where there is a shadow
constexpr double usual_shade = 0.0035,
                 doubtful_shade = 0.0015;     // 1/px: light's own; what beyond it doubles the variance
constexpr double doubtful_asymmetry = 0.022;  // half contrasts, of opposite points; doubles the variance
constexpr double odds_of_shadow = 2;          // log-odds: with four unknowns more much looks like a corner
constexpr double much_surer = 0.75;           // times the variance in even light, that a fit with a shadow may have

double in_half_turn(double angle) {
  const double turned = std::fmod(angle, M_PI);
  return turned < 0 ? turned + M_PI : turned;
}

// Of an X-corner the saddle's depth and the contrast of the sectors go together, whatever its blur and angle: the root
// of the depth is 0.05 to 0.1 times the half contrast, per px^2, and less where cells are only some px wide.
double relative_depth(const CornerCandidate& candidate, const CrossStructure& cross) {
  return std::sqrt(candidate.saddle) / std::abs(cross.half_contrast);
}

bool depth_suits(double depth) { return depth > 0.025 && depth < 0.12; }

// The flatter the saddle the more symmetric it must be to be worth a fit; measured on corners and texture.
bool symmetry_suits(double depth, const CrossStructure& cross) {
  return cross.asymmetry < 0.42 + 0.088 * std::log(depth);
}

// What noise does not explain of the circles: that they are no four sectors, and that opposite points differ. Measured:
// of what a fit shows to be none two in five are seen here already, of 1000 corners one is taken for none.
constexpr double least_move = 0.5;                            // px: less does not change what a fit finds
constexpr double most_misfit = 0.108, most_off_centre = 0.3;  // where circles may be read off the corner
bool sectors_suit(const CrossStructure& cross, double noise, double most = most_misfit) {
  const double relative = noise / std::abs(cross.half_contrast);
  const auto beyond = [&](double sign, double share) {  // `share` of the noise is in the sign
    return std::sqrt(std::max(sign * sign - share * share * relative * relative, 0.0));
  };
  const double left = most - 0.47 * beyond(cross.asymmetry, 0.45);
  if (!(left > 0)) return false;
  // A little less than what suits, so that rounding does not decide.
  const double enough = 0.999 * std::sqrt(left * left + 0.35 * 0.35 * relative * relative);
  return beyond(sector_misfit(cross, enough), 0.35) < left;
}

// What fits a chain of dots or a bar that thins best is often blacker than black or brighter than any pixel can be,
// though none is cut off. Of light too much is cut off, of darkness only what sharpening takes beyond it.
bool has_possible_levels(const CornerFit& fit) {
  const double half = std::abs(fit.model.half_contrast), contrast = 2 * half;
  const double black = fit.model.level - half, white = fit.model.level + half;
  if (fit.is_clipped) return black > -most_cut_off * contrast;
  return black > -most_beyond * contrast && white < 255 + most_beyond * contrast;
}

// Grey levels, in the light at the corner.
double contrast_of(const CornerModel& model) {
  const double light = has_shadow(model) ? light_at(model.shadow, Eigen::Vector2d::Zero()) : 1;
  return 2 * std::abs(model.half_contrast) * light;
}

// px, sigma of the largest window, as wide as asked for at most, that does not leave the image.
constexpr int least_window = 3;  // px
double sigma_with_room(const CornerSight& sight, const Eigen::Vector2d& position) {
  const int u = static_cast<int>(position.x()), v = static_cast<int>(position.y());
  const int room = std::min({u, v, sight.image.width - 2 - u, sight.image.height - 2 - v}) - 1;
  return std::min(sight.options.sigma, std::max(room, least_window) / 3.0);
}

// What the fit says is kept where the point of best symmetry, in the light that the fit found, agrees.
std::optional<Found> checked(const CornerSight& sight, const CornerFit& fit, double sigma) {
  if (contrast_of(fit.model) < sight.options.min_contrast) return std::nullopt;
  if (fit.covariance.trace() > 2 * most_sigma * most_sigma || !has_possible_levels(fit)) return std::nullopt;
  Found found;
  const double own = corner_log_odds(find_signs(fit, sight.noise)) - (has_shadow(fit.model) ? odds_of_shadow : 0);
  if (log_odds_among(own, -2) < least_log_odds) return std::nullopt;
  found.fit = fit;
  found.suspect = {{},  fit.model.position, fit.model.edges, fit.model.half_contrast, own,
                   own, fit.model.blur,     fit.model.level};
  // The strength is that of the symmetry, and what the model calls a corner must be a point of symmetry too.
  const auto symmetric = symmetry_point(sight.image, fit.model.position, sigma, most_apart, 0,
                                        has_shadow(fit.model) ? &fit.model : nullptr);
  if (!symmetric) return std::nullopt;
  const double asymmetry = std::sqrt(std::max(symmetric->noise * symmetric->noise - sight.noise * sight.noise, 0.0));
  if (asymmetry > most_asymmetry * std::abs(fit.model.half_contrast)) return std::nullopt;
  Corner& corner = found.corner;
  corner.position = fit.model.position;
  found.asymmetry = symmetric->noise * symmetric->noise;
  found.model_uncertainty = model_uncertainty_of(fit.model, found.asymmetry, sight.noise * sight.noise);
  corner.covariance = fit.covariance * found.model_uncertainty;
  corner.strength = symmetric->strength;
  corner.contrast = contrast_of(fit.model);
  corner.edges = {in_half_turn(fit.model.edges[0]), in_half_turn(fit.model.edges[1])};
  return found;
}

std::optional<Found> checked(const CornerSight& sight, const CornerFit& fit) {
  return checked(sight, fit, sight.options.sigma);
}

std::optional<Found> corner_in_light(const CornerSight& sight, const Eigen::Vector2d& start,
                                     const CrossStructure& cross) {
  const auto fit = fit_corner(sight.image, start, cross, sight.noise);
  if (!fit) return std::nullopt;
  auto plain = checked(sight, *fit);
  if (!plain || fit->model.shade.norm() < likely_shade) return plain;
  const auto beside = fit_beside_shadow(sight.image, start, cross, fit->model, Guess::fitted, sight.noise);
  const auto shaded = beside ? checked(sight, *beside) : std::nullopt;
  // Where the shadow explains little it only adds unknowns.
  const bool better = shaded && shaded->corner.covariance.trace() < much_surer * plain->corner.covariance.trace();
  return better ? shaded : plain;
}

std::optional<Found> corner_in_shadow(const CornerSight& sight, const Eigen::Vector2d& start,
                                      const CrossStructure& cross) {
  const auto fit =
      fit_beside_shadow(sight.image, start, cross, first_guess(start, cross), Guess::from_circles, sight.noise);
  return fit ? checked(sight, *fit) : std::nullopt;
}

// Circles that are read off the corner tell little: here they are read at the point of best symmetry.
std::optional<Found> centred_look(const CornerSight& sight, const Eigen::Vector2d& start, bool was_fitted) {
  const auto symmetric = symmetry_point(sight.image, start, sight.options.sigma, 2.5, 2);
  if (!symmetric) return std::nullopt;
  if (was_fitted && (symmetric->position - start).norm() < least_move) return std::nullopt;
  const auto cross = cross_structure(sight.image, symmetric->position, sight.options.min_contrast);
  if (!cross || !sectors_suit(*cross, sight.noise)) return std::nullopt;
  return corner_in_light(sight, symmetric->position, *cross);
}

bool is_same(const CornerModel& fitted, const CornerModel& known) {
  return fitted.half_contrast * known.half_contrast > 0 && std::abs(std::sin(fitted.edges[0] - known.edges[0])) < 0.3 &&
         std::abs(std::sin(fitted.edges[1] - known.edges[1])) < 0.3;
}

// The circles of a corner whose model is known.
CrossStructure structure_of(const CornerModel& model) {
  CrossStructure cross;
  cross.edges = model.edges, cross.level = model.level, cross.half_contrast = model.half_contrast;
  cross.blur = model.blur;
  return cross;
}

}  // namespace

double model_uncertainty_of(const CornerModel& model, double asymmetry, double variance) {
  const double unit = doubtful_asymmetry * model.half_contrast,
               relative = std::max(asymmetry - variance, 0.0) / (unit * unit);
  const double uneven = has_shadow(model) ? 0 : std::max(model.shade.norm() - usual_shade, 0.0) / doubtful_shade;
  return 1 + relative + uneven;
}

Look quick_look(const CornerSight& sight, const CornerCandidate& candidate) {
  Look look;  // without braces: they would fill it with zeros
  look.is_postponed = true;
  if (!candidate.stationary || candidate.ring == Lighting::shadowed) return look;
  const auto cross = cross_structure(sight.image, candidate.position, sight.options.min_contrast);
  if (!cross) return look;
  const double depth = relative_depth(candidate, *cross);
  if (!depth_suits(depth)) return look;
  look.is_open = !symmetry_suits(depth, *cross);
  look.was_fitted = !look.is_open && sectors_suit(*cross, sight.noise);
  if (look.was_fitted) look.found = corner_in_light(sight, candidate.position, *cross);
  return look;
}

std::optional<Found> long_look(const CornerSight& sight, const CornerCandidate& candidate, const SecondLook& look) {
  const auto cross = cross_structure(sight.image, candidate.position, sight.options.min_contrast, Lighting::shadowed);
  if (!cross || !depth_suits(relative_depth(candidate, *cross))) return std::nullopt;
  const bool may_be_centred = look.may_centre && sectors_suit(*cross, sight.noise, most_off_centre);
  auto found = may_be_centred ? centred_look(sight, candidate.position, look.was_fitted) : std::nullopt;
  if (found || cross->asymmetry < least_of_shadow) return found;
  return corner_in_shadow(sight, candidate.position, *cross);
}

std::optional<Found> shadow_look(const CornerSight& sight, const CornerCandidate& candidate) {
  const auto cross = cross_structure(sight.image, candidate.position, sight.options.min_contrast, Lighting::shadowed);
  if (!cross || !depth_suits(relative_depth(candidate, *cross))) return std::nullopt;
  return corner_in_shadow(sight, candidate.position, *cross);
}

std::optional<Found> sure_look(const CornerSight& sight, const Eigen::Vector2d& start, double reach, int steps) {
  const auto symmetric = symmetry_point(sight.image, start, sight.options.sigma, reach, steps);
  if (!symmetric) return std::nullopt;
  const auto cross = cross_structure(sight.image, symmetric->position, sight.options.min_contrast);
  return cross ? corner_in_light(sight, symmetric->position, *cross) : std::nullopt;
}

std::optional<Found> predicted_look(const CornerSight& sight, const Eigen::Vector2d& start, double reach,
                                    const SuitsBoard& suits) {
  const auto symmetric = symmetry_point(sight.image, start, sight.options.sigma, reach, 2);
  if (symmetric) {
    const auto cross = cross_structure(sight.image, symmetric->position, sight.options.min_contrast);
    if (cross && suits(*cross, symmetric->position))
      if (auto found = corner_in_light(sight, symmetric->position, *cross)) return found;
  }
  const auto cross = cross_structure(sight.image, start, sight.options.min_contrast, Lighting::shadowed);
  return cross && suits(*cross, start) ? corner_in_shadow(sight, start, *cross) : std::nullopt;
}

std::optional<Found> small_look(const CornerSight& sight, const CornerModel& expected) {
  const auto fit = fit_small_corner(sight.image, expected.position, structure_of(expected), sight.noise);
  if (!fit || !is_same(fit->model, expected)) return std::nullopt;
  return checked(sight, *fit, sight.is_coarser ? sigma_with_room(sight, fit->model.position) : sight.options.sigma);
}

std::optional<Found> shaded_look(const CornerSight& sight, const CornerModel& expected) {
  const auto fit =
      (has_shadow(expected) ? fit_in_known_shadow : fit_in_unknown_shadow)(sight.image, expected, sight.noise);
  return fit && is_same(fit->model, expected) ? checked(sight, *fit) : std::nullopt;
}

std::optional<Found> known_look(const CornerSight& sight, const CornerModel& known) {
  const auto fit = fit_corner(sight.image, known.position, structure_of(known), sight.noise);
  return fit && is_same(fit->model, known) ? checked(sight, *fit) : std::nullopt;
}

}  // namespace handsight
