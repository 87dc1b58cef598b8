// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_detector.h"

#include <algorithm>
#include <cmath>

#include "vision/corner_candidates.h"
#include "vision/corner_model.h"
#include "vision/corner_noise.h"
#include "vision/corner_structure.h"
#include "vision/corner_symmetry.h"

namespace handsight {
namespace {

constexpr double kMostSigma = 0.3;      // px: a corner that is not known better than this helps nobody
constexpr double kMostApart = 0.6;      // px, between the points of best symmetry and best fit
constexpr double kMostAsymmetry = 0.2;  // half contrasts, beyond what the noise explains

constexpr double kSame = 2;      // px: nearer ones are the same
constexpr double kNear = 40;     // px: what lies so near tells of what a corner lies in
constexpr double kAsDeep = 0.5;  // of the root of a saddle's depth
// The evidence that a corner needs, by how many more of the saddles near it are no corners than are.
constexpr std::array kLeastEvidence{0.6, 0.8, 1.1, 1.5, 2.4};

// How much more the model says than a cubic polynomial, and how well the corner is known beside one of texture, for
// which 0.2 px is common.
double evidence(const CornerFit& fit) { return fit.over_cubic * 0.2 / std::sqrt(fit.covariance.trace()); }

double in_half_turn(double angle) {
  const double turned = std::fmod(angle, M_PI);
  return turned < 0 ? turned + M_PI : turned;
}

// Of an X-corner the saddle's depth and the contrast of the sectors go together, whatever its blur and angle: the root
// of the depth is 0.05 to 0.1 times the half contrast, per px^2, and less where cells are only some px wide.
bool saddle_suits(const Candidate& candidate, const CrossStructure& cross) {
  const double ratio = std::sqrt(candidate.saddle) / std::abs(cross.half_contrast);
  return ratio > 0.025 && ratio < 0.12;
}

// The covariance tells what noise does to a fit whose model is right. A shadow's edge near the corner has no place in
// the model; it shows as light that changes faster than light does, and as asymmetry that the noise does not explain.
// Measured on shadows' edges 3 to 10 px off; without them neither sign shows.
double enlargement(const CornerModel& model, double asymmetry) {
  const double unevenness = std::max(model.shade.norm() - 0.006, 0.0) / 0.002;
  const double relative = asymmetry / (0.05 * model.half_contrast);
  return 1 + unevenness + relative * relative;
}

struct Found {
  Corner corner;
  double evidence = 0;
};

std::optional<Found> corner_near(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross,
                                 double noise, const DetectorOptions& options) {
  const auto fit = fit_corner(image, start, cross, noise);
  if (!fit || 2 * std::abs(fit->model.half_contrast) < options.min_contrast) return std::nullopt;
  if (fit->covariance.trace() > 2 * kMostSigma * kMostSigma) return std::nullopt;
  if (evidence(*fit) < kLeastEvidence.front()) return std::nullopt;
  // The strength is that of the symmetry, and what the model calls a corner must be a point of symmetry too.
  const auto symmetric = symmetry_point(image, fit->model.position, options.sigma, kMostApart, 1);
  if (!symmetric) return std::nullopt;
  const double asymmetry = std::sqrt(std::max(symmetric->noise * symmetric->noise - noise * noise, 0.0));
  if (asymmetry > kMostAsymmetry * std::abs(fit->model.half_contrast)) return std::nullopt;
  Found found;
  Corner& corner = found.corner;
  corner.position = fit->model.position;
  corner.covariance = fit->covariance * enlargement(fit->model, asymmetry);
  corner.strength = symmetric->strength;
  corner.contrast = 2 * std::abs(fit->model.half_contrast);
  corner.edges = {in_half_turn(fit->model.edges[0]), in_half_turn(fit->model.edges[1])};
  found.evidence = evidence(*fit);
  return found;
}

bool within(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double distance) {
  return (a - b).squaredNorm() < distance * distance;
}

// A saddle among other saddles that are no corners is likely to be none itself, and must differ the more from a smooth
// one. Deep ones come first in `candidates`.
bool stands_out(const Found& found, const std::vector<Candidate>& candidates, const Candidate& own,
                const std::vector<Found>& all) {
  if (found.evidence >= kLeastEvidence.back()) return true;
  int others = 0;
  for (const Candidate& other : candidates) {
    if (other.saddle < kAsDeep * kAsDeep * own.saddle) break;
    if (!within(other.position, own.position, kNear) || within(other.position, own.position, kSame)) continue;
    const bool corner = std::any_of(all.begin(), all.end(),
                                    [&](const Found& f) { return within(f.corner.position, other.position, kSame); });
    others += corner ? -1 : 1;
  }
  const int last = static_cast<int>(kLeastEvidence.size()) - 1;
  return found.evidence >= kLeastEvidence[std::clamp(others, 0, last)];
}

}  // namespace

std::vector<Corner> detect_corners(const Image& image, const DetectorOptions& options) {
  const double noise = image_noise(image);
  const auto candidates = saddle_candidates(image, options.min_contrast, noise, 2 * options.max_corners);
  std::vector<Found> all;
  std::vector<const Candidate*> from;
  for (const Candidate& candidate : candidates) {
    const Eigen::Vector2i pixel = candidate.position.array().round().cast<int>();
    if (!may_be_cross(image, pixel.x(), pixel.y(), options.min_contrast, noise)) continue;
    const auto cross = cross_structure(image, candidate.position, options.min_contrast);
    if (!cross || !saddle_suits(candidate, *cross)) continue;
    const auto found = corner_near(image, candidate.position, *cross, noise, options);
    if (found) all.push_back(*found), from.push_back(&candidate);
  }
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (stands_out(all[i], candidates, *from[i], all)) corners.push_back(all[i].corner);
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.strength > b.strength; });
  std::vector<Corner> kept;
  for (const Corner& corner : corners) {
    const bool again = std::any_of(kept.begin(), kept.end(),
                                   [&](const Corner& other) { return within(other.position, corner.position, kSame); });
    if (again) continue;
    kept.push_back(corner);
    if (static_cast<int>(kept.size()) >= options.max_corners) break;
  }
  return kept;
}

std::optional<Corner> refine_corner(const Image& image, const Eigen::Vector2d& start, const DetectorOptions& options) {
  const bool inside = start.x() >= 0 && start.y() >= 0 && start.x() < image.width && start.y() < image.height;
  if (!inside) return std::nullopt;  // not a number is not inside either
  const auto symmetric = symmetry_point(image, start, options.sigma, 1.5 * options.sigma, 6);
  if (!symmetric) return std::nullopt;
  const double noise = image_noise(image);
  const auto cross = cross_structure(image, symmetric->position, options.min_contrast);
  if (!cross) return std::nullopt;
  const auto found = corner_near(image, symmetric->position, *cross, noise, options);
  return found ? std::optional<Corner>(found->corner) : std::nullopt;
}

}  // namespace handsight
