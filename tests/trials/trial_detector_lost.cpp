// SPDX-License-Identifier: Apache-2.0
// Of the corners that the detector loses before a camera: which of its tests speaks against each, in the whole image,
// and whether a fit from the truth takes it. Usage: trial_detector_lost [SEED [PICTURES]]
#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <string>

#include "vision/corners/corner_camera.h"
#include "vision/corners/corner_candidates.h"
#include "vision/corners/corner_detector.h"
#include "vision/corners/corner_likelihood.h"
#include "vision/corners/corner_model.h"
#include "vision/corners/corner_noise.h"
#include "vision/corners/corner_structure.h"
#include "vision/corners/corner_symmetry.h"

namespace handsight {
namespace {

using namespace corner_images;

const CornerCandidate* nearest(const std::vector<CornerCandidate>& candidates, const Eigen::Vector2d& truth) {
  const CornerCandidate* best = nullptr;
  for (const CornerCandidate& candidate : candidates)
    if ((candidate.position - truth).norm() < (best ? (best->position - truth).norm() : 3)) best = &candidate;
  return best;
}

std::string what_of(const Image& image, const std::optional<CornerFit>& fit, double noise) {
  if (!fit) return "no fit";
  if (2 * std::abs(fit->model.half_contrast) < 20) return "fit: too little contrast";
  if (fit->covariance.trace() > 2 * 0.3 * 0.3) return "fit: sigma";
  const double own = corner_log_odds(find_signs(*fit, noise));
  if (log_odds_among(own, -2) < least_log_odds) return "fit: unlikely by itself";
  const auto symmetric = symmetry_point(image, fit->model.position, 2, 0.6, 0);
  if (!symmetric) return "fit: no point of symmetry near";
  const double left = symmetric->noise * symmetric->noise - noise * noise;
  if (std::sqrt(std::max(left, 0.0)) > 0.3 * std::abs(fit->model.half_contrast)) return "fit: asymmetric";
  return fmt::format("fit: fine ({})", own > 0.4 ? "likely" : "weighed");
}

std::string why_no_fit(const Image& image, const Eigen::Vector2d& start, const CrossStructure& cross, double noise) {
  return what_of(image, fit_corner(image, start, cross, noise), noise);
}

// A small fit from the truth with the edges and the contrast of the nearest corner found.
std::string small(const Image& image, const std::vector<Corner>& corners, const TrueCorner& truth, double noise) {
  const Corner* best = nullptr;
  for (const Corner& c : corners)
    if (!best || (c.position - truth.position).norm() < (best->position - truth.position).norm()) best = &c;
  if (!best) return "none found";
  CrossStructure cross;
  cross.edges = best->edges;
  double sum = 0;
  const Eigen::Vector2i at = (truth.position.array() + 0.5).cast<int>();
  for (int v = -3; v <= 3; ++v)
    for (int u = -3; u <= 3; ++u) sum += image.row(at.y() + v)[at.x() + u] / 49.0;
  cross.level = sum;
  std::string result = "no fit";
  for (const double sign : {-0.5, 0.5}) {
    cross.half_contrast = sign * best->contrast;
    const auto fit = fit_small_corner(image, truth.position, cross, noise);
    if (fit) result = what_of(image, fit, noise);
  }
  const double far = (best->position - truth.position).norm() / truth.smallest_cell;
  return fmt::format("{} {}",
                     far < 1.6 ? "neighbour found,"
                     : far < 4 ? "near ones found,"
                               : "all round lost,",
                     result);
}

std::string why(const Image& image, const std::vector<CornerCandidate>& candidates, const Eigen::Vector2d& truth,
                double noise) {
  const CornerCandidate* const candidate = nearest(candidates, truth);
  if (!candidate) return "1 no saddle";
  if (!candidate->stationary) return "2 gradient vanishes elsewhere";
  const auto light = may_be_cross(image, (candidate->position.array() + 0.5).cast<int>(), 20, noise);
  if (!light) return "3 circle of 3 px";
  if (*light == Lighting::shadowed) return "4 circle of 3 px: shadowed";
  const auto cross = cross_structure(image, candidate->position, 20);
  if (!cross)
    return cross_structure(image, candidate->position, 20, Lighting::shadowed) ? "5 circles: asymmetric" : "5 circles";
  const double depth = std::sqrt(candidate->saddle) / std::abs(cross->half_contrast);
  if (!(depth > 0.025 && depth < 0.12)) return "6 depth";
  if (!(cross->asymmetry < 0.42 + 0.088 * std::log(depth))) return "7 asymmetric for its depth";
  if (sector_misfit(*cross) > 0.108) return "8 sectors";
  return "9 " + why_no_fit(image, candidate->position, *cross, noise);
}

std::string from_truth(const Image& image, const Eigen::Vector2d& truth, double noise) {
  const auto cross = cross_structure(image, truth, 20);
  return cross ? why_no_fit(image, truth, *cross, noise) : "circles";
}

// The same beside a shadow.
std::string from_truth_in_shadow(const Image& image, const Eigen::Vector2d& truth, double noise) {
  const auto cross = cross_structure(image, truth, 20, Lighting::shadowed);
  if (!cross) return "circles";
  return what_of(image, fit_beside_shadow(image, truth, *cross, first_guess(truth, *cross), Guess::from_circles, noise),
                 noise);
}

// Only those whose distance from a shadow's edge, px, is in `shadow`.
void tally(const std::string& name, int pictures, unsigned seed, const Conditions& conditions,
           const Range& shadow = {0, 1e10}) {
  std::mt19937 random(seed);
  std::map<std::string, std::pair<int, double>> count;
  int lost = 0, all = 0;
  for (int i = 0; i < pictures; ++i) {
    const Picture picture = take(conditions, random);
    const std::vector<Corner> corners = detect_corners(picture.image);
    const double noise = image_noise(picture.image);
    const auto candidates = saddle_candidates(picture.image, 20, noise);
    for (const TrueCorner& truth : picture.corners) {
      if (truth.bound > 0.1 || truth.smallest_cell < 4 || truth.visible < 0.4) continue;
      if (truth.shadow_distance < shadow[0] || truth.shadow_distance > shadow[1]) continue;
      ++all;
      const auto is_here = [&](const Corner& c) { return (c.position - truth.position).norm() < 2; };
      if (std::any_of(corners.begin(), corners.end(), is_here)) continue;
      ++lost;
      auto& [number, cells] = count[fmt::format(
          "{:<34} from the truth: {}; in shadow: {}; small: {}", why(picture.image, candidates, truth.position, noise),
          from_truth(picture.image, truth.position, noise),
          conditions.shade[0] < 1 ? from_truth_in_shadow(picture.image, truth.position, noise) : "-",
          small(picture.image, corners, truth, noise))];
      ++number, cells += truth.smallest_cell;
    }
  }
  fmt::print("{}: {} of {} lost\n", name, lost, all);
  for (const auto& [reason, number] : count)
    fmt::print("  {:5} {:<110} cells {:.1f} px\n", number.first, reason, number.second / number.first);
  std::fflush(stdout);
}

}  // namespace
}  // namespace handsight

int main(int count, char** words) {
  using namespace handsight;
  const unsigned seed = count > 1 ? static_cast<unsigned>(std::atoi(words[1])) : 11;
  const int pictures = count > 2 ? std::atoi(words[2]) : 30;
  tally("tilt 60-70 deg", pictures, seed, {.cell = {14, 30}, .tilt = {M_PI / 3, 7 * M_PI / 18}});
  tally("gamma, tilt 50-65 deg", pictures, seed, {.cell = {14, 30}, .tilt = {0.87, 1.13}, .gamma = {1.8, 2.4}});
  tally("cells 6-9", pictures / 2, seed, {.cell = {6, 9}, .tilt = {0, 0.7}, .blur = {0.4, 1.1}});
  tally("white clipped", pictures, seed, {.contrast = {80, 200}, .exposure = {1.3, 2.2}});
  const Conditions shadow{.shade = {0.25, 0.7}};
  tally("shadow's edge 4-12 px off", pictures, seed, shadow, {4, 12});
  tally("shadow's edge 1.5-4 px off", pictures, seed, shadow, {1.5, 4});
  tally("shadow's edge under 1.5 px", pictures, seed, shadow, {0, 1.5});
  tally("blur 2-3.5", pictures, seed, {.cell = {16, 34}, .blur = {2, 3.5}});
}
