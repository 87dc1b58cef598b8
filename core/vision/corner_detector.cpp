// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_detector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vision/corner_candidates.h"
#include "vision/corner_likelihood.h"
#include "vision/corner_model.h"
#include "vision/corner_noise.h"
#include "vision/corner_structure.h"
#include "vision/corner_symmetry.h"

namespace handsight {
namespace {

constexpr double kMostSigma = 0.3;      // px: a corner that is not known better than this helps nobody
constexpr double kMostApart = 0.6;      // px, between the points of best symmetry and best fit
constexpr double kMostAsymmetry = 0.3;  // half contrasts, beyond what the noise explains
constexpr double kSame = 2;             // px: nearer ones are the same

constexpr double kLikelyShade = 0.005;    // 1/px: light that changes faster may be a shadow's edge
constexpr double kShadowVariance = 1.25;  // what straight soft edges leave unsaid of real ones
constexpr double kFew = 4;                // more saddles near that are none than are corners: few enough to look again

double in_half_turn(double angle) {
  const double turned = std::fmod(angle, M_PI);
  return turned < 0 ? turned + M_PI : turned;
}

// Of an X-corner the saddle's depth and the contrast of the sectors go together, whatever its blur and angle: the root
// of the depth is 0.05 to 0.1 times the half contrast, per px^2, and less where cells are only some px wide.
double relative_depth(const Candidate& candidate, const CrossStructure& cross) {
  return std::sqrt(candidate.saddle) / std::abs(cross.half_contrast);
}

bool depth_suits(double depth) { return depth > 0.025 && depth < 0.12; }

// The flatter the saddle the more symmetric it must be to be worth a fit; measured on corners and texture.
bool symmetry_suits(double depth, const CrossStructure& cross) {
  return cross.asymmetry < 0.42 + 0.088 * std::log(depth);
}

// What noise does not explain of the circles: that they are no four sectors, and that opposite points differ. Measured:
// of what a fit shows to be none two in five are seen here already, of 1000 corners one is taken for none.
bool sectors_suit(const CrossStructure& cross, double noise) {
  const double relative = noise / std::abs(cross.half_contrast);
  const auto beyond = [&](double sign, double share) {  // `share` of the noise is in the sign
    return std::sqrt(std::max(sign * sign - share * share * relative * relative, 0.0));
  };
  return beyond(sector_misfit(cross), 0.35) + 0.47 * beyond(cross.asymmetry, 0.45) < 0.108;
}

// The covariance tells what noise does to a fit whose model is right. Where a shadow's edge near the corner was not
// found it shows as light that changes faster than light does, and as asymmetry that the noise does not explain.
// Measured on shadows' edges 3 to 10 px off; without them neither sign shows.
double enlargement(const CornerModel& model, double asymmetry) {
  const double unevenness = std::max(model.shade.norm() - 0.004, 0.0) / 0.001;
  const double relative = asymmetry / (0.035 * model.half_contrast);
  return (has_shadow(model) ? kShadowVariance : 1) * (1 + unevenness + relative * relative);
}

struct Found {
  Corner corner;
  Suspect suspect;
};

struct Scene {
  const Image& image;
  const DetectorOptions& options;
  double noise;  // grey levels
};

// What the fit says is kept where the point of best symmetry, in the light that the fit found, agrees.
std::optional<Found> checked(const Scene& scene, const CornerFit& fit) {
  if (2 * std::abs(fit.model.half_contrast) < scene.options.min_contrast) return std::nullopt;
  if (fit.covariance.trace() > 2 * kMostSigma * kMostSigma) return std::nullopt;
  Found found;
  const double own = corner_log_odds(signs_of(fit, scene.noise));
  if (log_odds_among(own, -2) < kLeastLogOdds) return std::nullopt;
  found.suspect = {{}, fit.model.position, fit.model.edges, fit.model.half_contrast, own, own};
  // The strength is that of the symmetry, and what the model calls a corner must be a point of symmetry too.
  const auto symmetric = symmetry_point(scene.image, fit.model.position, scene.options.sigma, kMostApart, 0,
                                        has_shadow(fit.model) ? &fit.model : nullptr);
  if (!symmetric) return std::nullopt;
  const double asymmetry = std::sqrt(std::max(symmetric->noise * symmetric->noise - scene.noise * scene.noise, 0.0));
  if (asymmetry > kMostAsymmetry * std::abs(fit.model.half_contrast)) return std::nullopt;
  Corner& corner = found.corner;
  corner.position = fit.model.position;
  corner.covariance = fit.covariance * enlargement(fit.model, asymmetry);
  corner.strength = symmetric->strength;
  corner.contrast = 2 * std::abs(fit.model.half_contrast);
  corner.edges = {in_half_turn(fit.model.edges[0]), in_half_turn(fit.model.edges[1])};
  return found;
}

std::optional<Found> corner_in_light(const Scene& scene, const Eigen::Vector2d& start, const CrossStructure& cross) {
  const auto fit = fit_corner(scene.image, start, cross, scene.noise);
  if (!fit) return std::nullopt;
  const auto plain = checked(scene, *fit);
  if (!plain || fit->model.shade.norm() < kLikelyShade) return plain;
  const auto beside = fit_beside_shadow(scene.image, start, cross, fit->model, Guess::fitted, scene.noise);
  const auto shaded = beside ? checked(scene, *beside) : std::nullopt;
  // Where the shadow explains little it only adds unknowns.
  const bool better = shaded && shaded->corner.covariance.trace() < 1.5 * plain->corner.covariance.trace();
  return better ? shaded : plain;
}

std::optional<Found> corner_in_shadow(const Scene& scene, const Eigen::Vector2d& start, const CrossStructure& cross) {
  const auto fit =
      fit_beside_shadow(scene.image, start, cross, first_guess(start, cross), Guess::from_circles, scene.noise);
  return fit ? checked(scene, *fit) : std::nullopt;
}

// What the first look at a candidate found; and whether a second one might tell more.
struct Look {
  std::optional<Found> found;
  bool is_open = false;           // too asymmetric to be worth a fit yet
  bool may_be_in_shadow = false;  // open, or what made it none may be a shadow
};

// The quick look: what cannot be a corner in even light is cheap to see of most.
Look quick_look(const Scene& scene, const Candidate& candidate) {
  const Eigen::Vector2i pixel = candidate.position.array().round().cast<int>();
  const auto lighting = may_be_cross(scene.image, pixel, scene.options.min_contrast, scene.noise);
  if (!lighting) return {};
  Look look{.may_be_in_shadow = true};
  if (!candidate.stationary || lighting == Lighting::shadowed) return look;
  const auto cross = cross_structure(scene.image, candidate.position, scene.options.min_contrast);
  if (!cross) return look;
  const double depth = relative_depth(candidate, *cross);
  if (!depth_suits(depth)) return look;
  look.is_open = !symmetry_suits(depth, *cross);
  if (!look.is_open && sectors_suit(*cross, scene.noise))
    look.found = corner_in_light(scene, candidate.position, *cross);
  return look;
}

// The long look, where few saddles near are no corners: with less asked of the symmetry, and beside a shadow.
std::optional<Found> long_look(const Scene& scene, const Candidate& candidate, bool is_open) {
  const auto cross = cross_structure(scene.image, candidate.position, scene.options.min_contrast, Lighting::shadowed);
  if (!cross || !depth_suits(relative_depth(candidate, *cross))) return std::nullopt;
  const auto found = is_open ? corner_in_light(scene, candidate.position, *cross) : std::nullopt;
  return found ? found : corner_in_shadow(scene, candidate.position, *cross);
}

// What was found, each as a corner and as a suspect.
struct Finds {
  std::vector<Corner> corners;
  std::vector<Suspect> suspects;
  void add(const Found& found, const Candidate& candidate) {
    corners.push_back(found.corner), suspects.push_back(found.suspect), suspects.back().candidate = candidate;
  }
  void replace(std::size_t i, const Found& found) {
    const Candidate candidate = suspects[i].candidate;
    corners[i] = found.corner, suspects[i] = found.suspect, suspects[i].candidate = candidate;
  }
};

struct Left {
  const Candidate* candidate;
  bool is_open;
};

// Looks long at what the first look left, and at what it found but believes to be none: a shadow spoils a fit too.
void look_again(const Scene& scene, const SaddleField& field, const std::vector<Left>& left, Finds& finds) {
  const auto is_worth_it = [&](const Candidate& candidate) { return field.others(candidate) <= kFew; };
  for (std::size_t i = 0; i < finds.suspects.size(); ++i) {
    const Suspect& suspect = finds.suspects[i];
    if (suspect.log_odds > kLeastLogOdds || !is_worth_it(suspect.candidate)) continue;
    const auto found = long_look(scene, suspect.candidate, false);
    if (found && found->suspect.own > suspect.own) finds.replace(i, *found);
  }
  for (const auto& [candidate, is_open] : left) {
    const auto found = is_worth_it(*candidate) ? long_look(scene, *candidate, is_open) : std::nullopt;
    if (found) finds.add(*found, *candidate);
  }
}

bool within(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double distance) {
  return (a - b).squaredNorm() < distance * distance;
}

std::vector<Corner> strongest(std::vector<Corner> corners, int most) {
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.strength > b.strength; });
  std::vector<Corner> kept;
  for (const Corner& corner : corners) {
    const bool again = std::any_of(kept.begin(), kept.end(),
                                   [&](const Corner& other) { return within(other.position, corner.position, kSame); });
    if (again) continue;
    kept.push_back(corner);
    if (static_cast<int>(kept.size()) >= most) break;
  }
  return kept;
}

}  // namespace

std::vector<Corner> detect_corners(const Image& image, const DetectorOptions& options) {
  const Scene scene{image, options, image_noise(image)};
  const auto candidates = saddle_candidates(image, options.min_contrast, scene.noise, 2 * options.max_corners);
  SaddleField field(image.width, image.height, candidates);
  Finds finds;
  std::vector<Left> left;
  for (const Candidate& candidate : candidates) {
    const Look look = quick_look(scene, candidate);
    if (look.found)
      finds.add(*look.found, candidate);
    else if (look.may_be_in_shadow)
      left.push_back({&candidate, look.is_open});
    if (look.is_open) field.set_probability(field.at(candidate.position), 0.5);
  }
  weigh(finds.suspects, field);
  look_again(scene, field, left, finds);
  for (const Left& rest : left)
    if (rest.is_open) field.set_probability(field.at(rest.candidate->position), 0);
  weigh(finds.suspects, field);
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < finds.corners.size(); ++i)
    if (finds.suspects[i].log_odds > kLeastLogOdds) corners.push_back(finds.corners[i]);
  return strongest(std::move(corners), options.max_corners);
}

std::optional<Corner> refine_corner(const Image& image, const Eigen::Vector2d& start, const DetectorOptions& options) {
  const bool inside = start.x() >= 0 && start.y() >= 0 && start.x() < image.width && start.y() < image.height;
  if (!inside) return std::nullopt;  // not a number is not inside either
  const auto symmetric = symmetry_point(image, start, options.sigma, 1.5 * options.sigma, 6);
  if (!symmetric) return std::nullopt;
  const Scene scene{image, options, image_noise(image)};
  const auto cross = cross_structure(image, symmetric->position, options.min_contrast);
  if (!cross) return std::nullopt;
  const auto found = corner_in_light(scene, symmetric->position, *cross);
  return found ? std::optional<Corner>(found->corner) : std::nullopt;
}

}  // namespace handsight
