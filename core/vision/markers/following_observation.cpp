// SPDX-License-Identifier: Apache-2.0
#include "vision/markers/following_observation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "vision/markers/body_hypothesis.h"

namespace handsight {
namespace {

/// More triples than this are not tried; those nearest to the prediction come first.
constexpr std::size_t most_triples_tried = 20000;
/// Nor more nodes looked at in all: boards full of corners that look alike have millions of triples, each of which
/// looks at every node. A few tenths of a second; a hand among distractors needs a hundredth of it.
constexpr std::size_t most_looks = 5'000'000;

struct Search {
  const std::vector<CornerPair>& pairs;
  const KnownMarkers& known;
  const std::optional<Rigid>& prediction;
  const MatchOptions& options;
  std::size_t needed;             // markers for a pose
  std::vector<MarkerNode> nodes;  // nearest to the prediction first
  std::vector<BodyHypothesis> found;
  std::size_t tried = 0, looked = 0;
  bool gave_up() const { return tried >= most_triples_tried || looked >= most_looks; }
};

int known_count(const KnownMarkers& known) {
  return static_cast<int>(
      std::count_if(known.in_body.begin(), known.in_body.end(), [](const auto& x) { return x.has_value(); }));
}

/// Which pair may be which marker: near enough to where the prediction puts it.
std::vector<MarkerNode> nodes_near(const std::vector<CornerPair>& pairs, const KnownMarkers& known,
                                   const std::optional<Rigid>& prediction, const MatchOptions& options) {
  std::vector<std::pair<double, MarkerNode>> near;
  Vector3 center = Vector3::Zero();
  for (const auto& x : known.in_body)
    if (x) center += *x / known_count(known);
  for (std::size_t m = 0; m < known.in_body.size(); ++m) {
    if (!known.in_body[m]) continue;
    const double reach =
        options.body_gate + options.turn_gate * (*known.in_body[m] - center).norm() + options.marker_gate;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const MarkerNode node{static_cast<int>(m), static_cast<int>(p)};
      if (!prediction) {
        near.push_back({pairs[p].point.epipolar_distance, node});
        continue;
      }
      const double distance = (pairs[p].point.point - *prediction * *known.in_body[m]).norm();
      const double sigma = std::sqrt(pairs[p].point.covariance.trace());
      if (distance <= reach + 3 * sigma) near.push_back({distance, node});
    }
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<MarkerNode> nodes;
  for (const auto& [distance, node] : near) nodes.push_back(node);
  return nodes;
}

bool share_something(const std::vector<CornerPair>& pairs, const MarkerNode& a, const MarkerNode& b) {
  const CornerPair& p = pairs[static_cast<std::size_t>(a.pair)];
  const CornerPair& q = pairs[static_cast<std::size_t>(b.pair)];
  return a.marker == b.marker || p.left == q.left || p.right == q.right;
}

void try_seed(Search& search, const std::vector<MarkerNode>& seed) {
  ++search.tried;
  search.looked += search.nodes.size();
  auto h = body_hypothesis(search.pairs, search.known, seed, search.nodes, search.prediction, search.options);
  if (h && h->nodes.size() >= search.needed) search.found.push_back(std::move(*h));
}

/// All sets of `needed` nodes whose side lengths agree, extended one node at a time.
void extend(Search& search, std::vector<MarkerNode>& seed, std::size_t from) {
  if (seed.size() == search.needed) return try_seed(search, seed);
  for (std::size_t i = from; i < search.nodes.size() && !search.gave_up(); ++i) {
    ++search.looked;
    const MarkerNode& node = search.nodes[i];
    const bool agrees = std::all_of(seed.begin(), seed.end(), [&](const MarkerNode& other) {
      return !share_something(search.pairs, node, other) && lengths_agree(search.pairs, search.known, node, other);
    });
    if (!agrees) continue;
    seed.push_back(node);
    extend(search, seed, i + 1);
    seed.pop_back();
  }
}

bool better(const BodyHypothesis& a, const BodyHypothesis& b) {
  if (a.nodes.size() != b.nodes.size()) return a.nodes.size() > b.nodes.size();
  return a.misfit < b.misfit;
}

bool within_gates(const BodyHypothesis& h, const Search& search) {
  return !search.prediction || (h.body_offset <= search.options.body_gate && h.body_turn <= search.options.turn_gate);
}

bool same_nodes(const BodyHypothesis& a, const BodyHypothesis& b) {
  return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                    [](const MarkerNode& p, const MarkerNode& q) { return p.marker == q.marker && p.pair == q.pair; });
}

/// Another assignment of as many markers, hardly worse, that puts some marker elsewhere: nobody can tell which.
const BodyHypothesis* rival_of(const BodyHypothesis& best, const Search& search) {
  for (const BodyHypothesis& h : search.found) {
    if (!within_gates(h, search) || h.nodes.size() != best.nodes.size() || same_nodes(h, best)) continue;
    if (h.misfit > best.misfit + 6) continue;
    return &h;
  }
  return nullptr;
}

Message too_few_reason(const Search& search, std::size_t epipolar_pairs) {
  std::vector<char> seen(search.known.in_body.size(), 0);
  for (const MarkerNode& n : search.nodes) seen[static_cast<std::size_t>(n.marker)] = 1;
  const auto count = std::count(seen.begin(), seen.end(), 1);
  if (count == 0)
    return message("none of the {} markers has a corner pair near where it must be ({} epipolar pairs in the images)",
                   known_count(search.known), epipolar_pairs);
  if (static_cast<std::size_t>(count) < search.needed)
    return message("only {} of {} markers have a corner pair near where they must be ({} epipolar pairs in the images)",
                   count, known_count(search.known), epipolar_pairs);
  if (search.gave_up())
    return message(
        "too many corners look alike to tell the markers among them ({} epipolar pairs in the images): no "
        "assignment was found among those nearest to the prediction",
        epipolar_pairs);
  return message("no {} corners near the prediction have the side lengths of the markers within 3 sigma",
                 search.needed);
}

/// A marker of which only one camera shows a corner: it joins where exactly one free corner is at its place.
void add_single_views(const StereoRig& rig, const std::vector<Corner>& left, const std::vector<Corner>& right,
                      const KnownMarkers& known, Match& match) {
  for (std::size_t m = 0; m < known.in_body.size(); ++m) {
    const bool has = std::any_of(match.markers.begin(), match.markers.end(),
                                 [&](const MatchedMarker& k) { return k.marker == static_cast<int>(m); });
    if (!known.in_body[m] || has) continue;
    const Vector3 x = match.sensor_from_body * *known.in_body[m];
    auto only_corner = [&](const Camera& camera, const Vector3& in_camera, const std::vector<Corner>& corners,
                           bool is_left) {
      int only = -1;
      if (!is_visible(camera, in_camera)) return only;
      const Vector2 expected = project(camera, in_camera);
      for (std::size_t c = 0; c < corners.size(); ++c) {
        const bool used = std::any_of(match.markers.begin(), match.markers.end(), [&](const MatchedMarker& k) {
          return (is_left ? k.left : k.right) == static_cast<int>(c);
        });
        const double limit = 1.0 + 3 * std::sqrt(corners[c].covariance.trace());
        if (used || (corners[c].position - expected).norm() > limit) continue;
        if (only >= 0) return -1;
        only = static_cast<int>(c);
      }
      return only;
    };
    const int in_left = only_corner(rig.left, x, left, true);
    const int in_right = only_corner(rig.right, rig.right_from_left * x, right, false);
    if ((in_left >= 0) != (in_right >= 0)) match.markers.push_back({static_cast<int>(m), in_left, in_right});
  }
  std::sort(match.markers.begin(), match.markers.end(),
            [](const MatchedMarker& a, const MatchedMarker& b) { return a.marker < b.marker; });
}

Search searched(const std::vector<CornerPair>& pairs, const KnownMarkers& known, const std::optional<Rigid>& prediction,
                const MatchOptions& options) {
  Search search{pairs, known, prediction, options, static_cast<std::size_t>(std::min(3, known_count(known))), {}, {}};
  search.nodes = nodes_near(pairs, known, prediction, options);
  std::vector<MarkerNode> seed;
  extend(search, seed, 0);
  std::stable_sort(search.found.begin(), search.found.end(), better);
  return search;
}

/// Why nothing was found: the body may simply be farther off than the gate allows, which is worth saying. By how much,
/// the model says that is fitted in the end: here it is a prediction of few observations.
Message refusal(const Search& search, const std::vector<CornerPair>& pairs) {
  if (search.prediction) {
    MatchOptions wide = search.options;
    wide.body_gate *= 5;
    wide.turn_gate *= 3;
    const Search again = searched(pairs, search.known, search.prediction, wide);
    for (const BodyHypothesis& h : again.found) {
      if (h.body_offset > search.options.body_gate)
        return message("the markers as a whole are more than {:.0f} mm from where they must be",
                       1e3 * search.options.body_gate);
      if (h.body_turn > search.options.turn_gate)
        return message("the markers as a whole are turned by more than {:.0f} deg from how they must lie",
                       57.29578 * search.options.turn_gate);
    }
  }
  return too_few_reason(search, pairs.size());
}

}  // namespace

Match match_markers(const StereoRig& rig, const std::vector<Corner>& left, const std::vector<Corner>& right,
                    const KnownMarkers& known, const std::optional<Rigid>& prediction, const MatchOptions& options) {
  const std::vector<CornerPair> pairs = corner_pairs(rig, left, right, options.pairs);
  const Search search = searched(pairs, known, prediction, options);
  const auto best = std::find_if(search.found.begin(), search.found.end(),
                                 [&](const BodyHypothesis& h) { return within_gates(h, search); });
  Match match;
  if (best == search.found.end()) {
    match.reason = refusal(search, pairs);
    return match;
  }
  if (rival_of(*best, search)) {
    match.reason = "two assignments of corners to markers fit equally well, and nothing tells which is right";
    return match;
  }
  match.sensor_from_body = best->sensor_from_body;
  match.body_offset = best->body_offset;
  for (const MarkerNode& node : best->nodes) {
    const CornerPair& pair = pairs[static_cast<std::size_t>(node.pair)];
    match.markers.push_back({node.marker, pair.left, pair.right});
  }
  if (search.needed == 3) add_single_views(rig, left, right, known, match);
  return match;
}

}  // namespace handsight
