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

double in_half_turn(double angle) {
  const double turned = std::fmod(angle, M_PI);
  return turned < 0 ? turned + M_PI : turned;
}

// Of an X-corner the saddle's depth and the contrast of the sectors go together, whatever its blur and angle: the root
// of the depth is 0.05 to 0.1 times the half contrast, per px^2.
bool saddle_suits(const Candidate& candidate, const CrossStructure& cross) {
  const double ratio = std::sqrt(candidate.saddle) / std::abs(cross.half_contrast);
  return ratio > 0.036 && ratio < 0.12;
}

std::optional<Corner> corner_near(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross,
                                  double noise, const DetectorOptions& options) {
  const auto fit = fit_corner(image, start, cross, noise);
  if (!fit || 2 * std::abs(fit->model.half_contrast) < options.min_contrast) return std::nullopt;
  if (fit->covariance.trace() > 2 * kMostSigma * kMostSigma) return std::nullopt;
  // The strength is that of the symmetry, and what the model calls a corner must be a point of symmetry too.
  const auto symmetric = symmetry_point(image, fit->model.position, options.sigma, kMostApart, 1);
  const double asymmetry = kMostAsymmetry * fit->model.half_contrast;
  if (!symmetric || std::pow(symmetric->noise, 2) > asymmetry * asymmetry + noise * noise) return std::nullopt;
  Corner corner;
  corner.position = fit->model.position;
  corner.covariance = fit->covariance;
  corner.strength = symmetric->strength;
  corner.contrast = 2 * std::abs(fit->model.half_contrast);
  corner.edges = {in_half_turn(fit->model.edges[0]), in_half_turn(fit->model.edges[1])};
  return corner;
}

}  // namespace

std::vector<Corner> detect_corners(const Image& image, const DetectorOptions& options) {
  std::vector<Corner> corners;
  const double noise = image_noise(image);
  for (const Candidate& candidate : saddle_candidates(image, options.min_contrast, noise, 2 * options.max_corners)) {
    const Eigen::Vector2i pixel = candidate.position.array().round().cast<int>();
    if (!may_be_cross(image, pixel.x(), pixel.y(), options.min_contrast)) continue;
    const auto cross = cross_structure(image, candidate.position, options.min_contrast);
    if (!cross || !saddle_suits(candidate, *cross)) continue;
    if (const auto corner = corner_near(image, candidate.position, *cross, noise, options)) corners.push_back(*corner);
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& a, const Corner& b) { return a.strength > b.strength; });
  std::vector<Corner> kept;
  for (const Corner& corner : corners) {
    const bool again = std::any_of(kept.begin(), kept.end(), [&](const Corner& other) {
      return (other.position - corner.position).squaredNorm() < 4;
    });
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
  const auto cross = cross_structure(image, symmetric->position, options.min_contrast);
  return cross ? corner_near(image, symmetric->position, *cross, image_noise(image), options) : std::nullopt;
}

}  // namespace handsight
