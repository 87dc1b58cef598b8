// SPDX-License-Identifier: Apache-2.0
#include "vision/markers/first_observation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace handsight {
namespace {

int nearest_corner(const std::vector<Corner>& corners, const Vector2& where, double& distance) {
  int nearest = -1;
  distance = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const double d = (corners[c].position - where).norm();
    if (d >= distance) continue;
    distance = d;
    nearest = static_cast<int>(c);
  }
  return nearest;
}

struct Choice {
  std::vector<int> pairs;  // per marker, index into its candidates
  double score = std::numeric_limits<double>::infinity();
};

double pair_score(const CornerPair& pair, const PairOptions& options) {
  return std::pow(pair.point.epipolar_distance / options.epipolar_threshold, 2) + 2 * pair.unlikeness;
}

/// Depth-first over the markers. `score` only grows, and what the markers that are left add at least is known, so that
/// a beginning that cannot win is given up; after `most_looked_at` beginnings the search ends undecided.
class Chooser {
 public:
  static constexpr int most_looked_at = 2'000'000;

  Chooser(const std::vector<std::vector<CornerPair>>& candidates, const LabelOptions& options)
      : candidates_(candidates), options_(options), least_after_(candidates.size() + 1, 0.0) {
    for (std::size_t m = candidates.size(); m-- > 0;) {
      double least = std::numeric_limits<double>::infinity();
      for (const CornerPair& pair : candidates[m]) least = std::min(least, pair_score(pair, options.pairs));
      least_after_[m] = least_after_[m + 1] + least;
    }
    search(0);
  }
  const Choice& best() const { return best_; }
  bool is_undecided() const { return looked_at_ > most_looked_at; }

 private:
  void search(double score) {
    if (score + least_after_[taken_.size()] >= best_.score || ++looked_at_ > most_looked_at) return;
    const std::size_t marker = taken_.size();
    if (marker == candidates_.size()) {
      best_ = {taken_, score};
      return;
    }
    std::vector<std::pair<double, int>> next;  // the likeliest first: a good choice early gives up most others
    for (std::size_t k = 0; k < candidates_[marker].size(); ++k)
      if (const auto added = compute_cost(candidates_[marker][k])) next.emplace_back(*added, static_cast<int>(k));
    std::stable_sort(next.begin(), next.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [added, k] : next) {
      taken_.push_back(k);
      search(score + added);
      taken_.pop_back();
    }
  }

  /// Nothing where the pair cannot stand beside those that are taken.
  std::optional<double> compute_cost(const CornerPair& pair) const {
    double added = pair_score(pair, options_.pairs);
    for (std::size_t m = 0; m < taken_.size(); ++m) {
      const CornerPair& other = candidates_[m][static_cast<std::size_t>(taken_[m])];
      const double apart = (pair.point.point - other.point.point).norm();
      if (pair.right == other.right || apart > options_.most_spread) return std::nullopt;
      // Of two partners on one epipolar line, the one at the depth of the other markers is the likelier.
      added += std::pow(std::abs(pair.point.point.z() - other.point.point.z()) / (0.3 * options_.most_spread), 2) /
               static_cast<double>(candidates_.size());
    }
    return added;
  }

  const std::vector<std::vector<CornerPair>>& candidates_;
  const LabelOptions& options_;
  std::vector<double> least_after_;
  std::vector<int> taken_;
  Choice best_;
  int looked_at_ = 0;
};

Message refuse_triangle(const std::vector<LabelledMarker>& markers, const LabelOptions& options) {
  double longest = 0, shortest = std::numeric_limits<double>::infinity(), height = 0;
  std::string sides;
  for (std::size_t a = 0; a < markers.size(); ++a)
    for (std::size_t b = a + 1; b < markers.size(); ++b) {
      const Vector3 side = markers[b].point.point - markers[a].point.point;
      sides += fmt::format("{}{:.0f}", sides.empty() ? "" : ", ", 1e3 * side.norm());
      shortest = std::min(shortest, side.norm());
      if (side.norm() <= longest) continue;
      longest = side.norm();
      height = 0;
      for (const LabelledMarker& c : markers)
        height = std::max(height, side.cross(c.point.point - markers[a].point.point).norm() / longest);
    }
  if (markers.size() >= 3 && height < options.line_sine * longest)
    return message(
        "The corners lie on a line ({:.1f} mm off): the hand's rotation about it cannot be seen; take a corner to the "
        "side.",
        1e3 * height);
  if (shortest < 1e-3)
    return message("Two of the markers are the same corner (sides {} mm); take another corner.", sides);
  if (longest < options.smallest_side)
    return message("Sides {} mm: too small, the hand's rotation would be known badly; take corners farther apart.",
                   sides);
  return {};
}

}  // namespace

FirstLabels label_first(const StereoRig& rig, const std::vector<Corner>& left, const std::vector<Corner>& right,
                        const std::vector<Vector2>& pointed, const LabelOptions& options) {
  FirstLabels result;
  auto refuse = [&](Message sentence) {
    result.markers.clear();
    result.refusal = std::move(sentence);
    return result;
  };
  std::vector<std::vector<CornerPair>> candidates;
  std::vector<int> corners;  // of the left image, per marker
  for (std::size_t m = 0; m < pointed.size(); ++m) {
    double distance = 0;
    const int corner = nearest_corner(left, pointed[m], distance);
    if (corner < 0 || distance > options.snap_distance)
      return refuse(
          message("Marker {}: no corner within {:.0f} px of ({:.1f}, {:.1f}) in the left image{}; point nearer to one.",
                  m, options.snap_distance, pointed[m].x(), pointed[m].y(),
                  corner < 0 ? Message(" (it has none)") : message(" (the nearest is {:.1f} px away)", distance)));
    if (const auto before = std::find(corners.begin(), corners.end(), corner); before != corners.end())
      return refuse(message(
          "Markers {} and {}: both are nearest to the corner at ({:.1f}, {:.1f}) of the left image; point each at a "
          "corner of its own.",
          before - corners.begin(), m, left[static_cast<std::size_t>(corner)].position.x(),
          left[static_cast<std::size_t>(corner)].position.y()));
    corners.push_back(corner);
    candidates.push_back(corner_pairs(rig, left, right, options.pairs, {corner}));
    if (candidates.back().empty())
      return refuse(
          message("Marker {}: no corner of the right image lies within {:.1f} px of the epipolar line of ({:.1f}, "
                  "{:.1f}) and in "
                  "front of both cameras; take another corner or the next observation.",
                  m, options.pairs.epipolar_threshold, left[static_cast<std::size_t>(corner)].position.x(),
                  left[static_cast<std::size_t>(corner)].position.y()));
  }
  const Chooser chooser(candidates, options);
  const Choice& best = chooser.best();
  if (chooser.is_undecided())
    return refuse(message(
        "{} corners have too many partners in the right image to choose among; point at fewer markers, or at corners "
        "with a less crowded epipolar line.",
        pointed.size()));
  if (best.pairs.size() != pointed.size())
    return refuse(message(
        "The {} corners have no partners in the right image that are all different and within {:.0f} mm of each other; "
        "check that they are on the hand.",
        pointed.size(), 1e3 * options.most_spread));
  for (std::size_t m = 0; m < pointed.size(); ++m) {
    const CornerPair& pair = candidates[m][static_cast<std::size_t>(best.pairs[m])];
    const Corner &seen = left[static_cast<std::size_t>(pair.left)],
                 &partner = right[static_cast<std::size_t>(pair.right)];
    result.markers.push_back({seen.position, partner.position, measured_covariance(seen, options.pairs),
                              measured_covariance(partner, options.pairs), pair.point,
                              static_cast<int>(candidates[m].size()) - 1});
  }
  if (result.markers.size() >= 2)
    if (auto sentence = refuse_triangle(result.markers, options); !sentence.empty()) return refuse(sentence);
  return result;
}

}  // namespace handsight
