// SPDX-License-Identifier: Apache-2.0
#include "vision/markers/body_candidates.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "vision/markers/body_hypothesis.h"

namespace handsight {
namespace {

/// More triples than this are not laid onto the body.
constexpr std::size_t most_triples = 4000;

struct Nodes {
  std::vector<MarkerNode> all;
  std::vector<std::vector<int>> of_marker;  // per known marker, places in `all`
};

Nodes nodes_of(const std::vector<CornerPair>& pairs, const KnownMarkers& known) {
  Nodes nodes;
  for (std::size_t m = 0; m < known.in_body.size(); ++m) {
    if (!known.in_body[m]) continue;
    nodes.of_marker.emplace_back();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      nodes.of_marker.back().push_back(static_cast<int>(nodes.all.size()));
      nodes.all.push_back({static_cast<int>(m), static_cast<int>(p)});
    }
  }
  return nodes;
}

bool are_apart(const std::vector<CornerPair>& pairs, const MarkerNode& a, const MarkerNode& b) {
  const CornerPair& p = pairs[static_cast<std::size_t>(a.pair)];
  const CornerPair& q = pairs[static_cast<std::size_t>(b.pair)];
  return p.left != q.left && p.right != q.right;
}

/// Per node of `from`, the nodes of `to` that may stand beside it.
std::vector<std::vector<int>> neighbours(const std::vector<CornerPair>& pairs, const KnownMarkers& known,
                                         const Nodes& nodes, std::size_t from, std::size_t to) {
  std::vector<std::vector<int>> list;
  for (const int a : nodes.of_marker[from]) {
    list.emplace_back();
    for (const int b : nodes.of_marker[to]) {
      const MarkerNode &x = nodes.all[static_cast<std::size_t>(a)], &y = nodes.all[static_cast<std::size_t>(b)];
      if (are_apart(pairs, x, y) && lengths_agree(pairs, known, x, y)) list.back().push_back(b);
    }
  }
  return list;
}

using Triple = std::vector<MarkerNode>;

void add_triples(const std::vector<CornerPair>& pairs, const KnownMarkers& known, const Nodes& nodes,
                 const std::array<std::size_t, 3>& markers, std::vector<Triple>& triples) {
  const auto seconds = neighbours(pairs, known, nodes, markers[0], markers[1]);
  const auto thirds = neighbours(pairs, known, nodes, markers[0], markers[2]);
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    const MarkerNode& a = nodes.all[static_cast<std::size_t>(nodes.of_marker[markers[0]][i])];
    for (const int j : seconds[i]) {
      const MarkerNode& b = nodes.all[static_cast<std::size_t>(j)];
      for (const int k : thirds[i]) {
        const MarkerNode& c = nodes.all[static_cast<std::size_t>(k)];
        if (triples.size() >= most_triples) return;
        if (are_apart(pairs, b, c) && lengths_agree(pairs, known, b, c)) triples.push_back({a, b, c});
      }
    }
  }
}

/// The worst of the markers' points, and how far that turns a body whose markers lie about their middle as these do.
void know_sigmas(const std::vector<CornerPair>& pairs, const KnownMarkers& known, const BodyHypothesis& h,
                 BodyCandidate& candidate) {
  Vector3 middle = Vector3::Zero();
  for (const MarkerNode& n : h.nodes)
    middle += *known.in_body[static_cast<std::size_t>(n.marker)] / static_cast<double>(h.nodes.size());
  Matrix3 spread = Matrix3::Zero();
  for (const MarkerNode& n : h.nodes) {
    const Vector3 from_middle = *known.in_body[static_cast<std::size_t>(n.marker)] - middle;
    spread += from_middle * from_middle.transpose();
    const double own = known.sigma[static_cast<std::size_t>(n.marker)];
    const double sigma = std::sqrt(pairs[static_cast<std::size_t>(n.pair)].point.covariance.trace() + own * own);
    candidate.sigma = std::max(candidate.sigma, sigma);
  }
  // The rotation about the body's longest direction is known worst: by what lies beside that direction.
  const Vector3 widths = spread.selfadjointView<Eigen::Lower>().eigenvalues();
  const double beside = std::sqrt(std::max(widths[0] + widths[1], 1e-12));
  candidate.turn_sigma = candidate.sigma / beside;
}

BodyCandidate make_candidate(const std::vector<CornerPair>& pairs, const KnownMarkers& known, const BodyHypothesis& h) {
  BodyCandidate candidate{.markers = {}, .sensor_from_body = h.sensor_from_body, .misfit = h.misfit};
  for (const MarkerNode& n : h.nodes) {
    const CornerPair& pair = pairs[static_cast<std::size_t>(n.pair)];
    candidate.markers.push_back({n.marker, pair.left, pair.right});
  }
  know_sigmas(pairs, known, h, candidate);
  return candidate;
}

bool same_corners(const BodyCandidate& a, const BodyCandidate& b) {
  return std::equal(a.markers.begin(), a.markers.end(), b.markers.begin(), b.markers.end(),
                    [](const MatchedMarker& x, const MatchedMarker& y) {
                      return x.marker == y.marker && x.left == y.left && x.right == y.right;
                    });
}

}  // namespace

std::vector<BodyCandidate> body_candidates(const StereoRig& rig, const std::vector<Corner>& left,
                                           const std::vector<Corner>& right, const KnownMarkers& known,
                                           const MatchOptions& options, std::size_t most) {
  const std::vector<CornerPair> pairs = corner_pairs(rig, left, right, options.pairs);
  const Nodes nodes = nodes_of(pairs, known);
  const std::size_t count = nodes.of_marker.size();
  std::vector<Triple> triples;
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      for (std::size_t c = b + 1; c < count; ++c) add_triples(pairs, known, nodes, {a, b, c}, triples);

  std::vector<BodyCandidate> found;
  for (const Triple& triple : triples) {
    const auto h = body_hypothesis(pairs, known, triple, count > 3 ? nodes.all : triple, std::nullopt, options);
    if (h && h->nodes.size() >= 3) found.push_back(make_candidate(pairs, known, *h));
  }
  std::stable_sort(found.begin(), found.end(), [](const BodyCandidate& a, const BodyCandidate& b) {
    return a.markers.size() != b.markers.size() ? a.markers.size() > b.markers.size() : a.misfit < b.misfit;
  });
  std::vector<BodyCandidate> different;
  for (BodyCandidate& candidate : found) {
    if (different.size() >= most) break;
    const auto same = [&](const BodyCandidate& known_one) { return same_corners(known_one, candidate); };
    if (std::none_of(different.begin(), different.end(), same)) different.push_back(std::move(candidate));
  }
  return different;
}

}  // namespace handsight
