// SPDX-License-Identifier: Apache-2.0
#include "vision/markers/body_hypothesis.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

const Vector3& in_body(const KnownMarkers& known, int marker) {
  return *known.in_body[static_cast<std::size_t>(marker)];
}

double known_variance(const KnownMarkers& known, int marker) {
  const double sigma = known.sigma[static_cast<std::size_t>(marker)];
  return sigma * sigma;
}

/// The pose that carries the known markers onto the pairs; with fewer than three the rotation of the prediction is
/// kept as far as the markers leave it open.
Rigid align(const std::vector<CornerPair>& pairs, const KnownMarkers& known, const std::vector<MarkerNode>& nodes,
            const std::optional<Rigid>& prediction) {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  Eigen::Matrix3Xd measured(3, count), body(3, count);
  Eigen::VectorXd weights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const MarkerNode& node = nodes[static_cast<std::size_t>(i)];
    const StereoPoint& point = pairs[static_cast<std::size_t>(node.pair)].point;
    measured.col(i) = point.point;
    body.col(i) = in_body(known, node.marker);
    weights[i] = 1 / (point.covariance.trace() + 3 * known_variance(known, node.marker));
  }
  if (count >= 3) return align_points(measured, body, weights);
  const Matrix3 start = prediction ? prediction->rotation : Matrix3::Identity();
  const Vector3 measured_center = measured.rowwise().mean(), body_center = body.rowwise().mean();
  Matrix3 rotation = start;
  if (count == 2)
    rotation =
        turn_between(start * (body.col(1) - body.col(0)), measured.col(1) - measured.col(0)).toRotationMatrix() * start;
  return {rotation, measured_center - rotation * body_center};
}

struct Miss {
  double distance = 0;  // m
  double sigma = 0;     // m, along the miss
  double chi2 = 0;
};

Miss miss_of(const CornerPair& pair, const KnownMarkers& known, int marker, const Rigid& sensor_from_body) {
  const Vector3 miss = pair.point.point - sensor_from_body * in_body(known, marker);
  const Matrix3 covariance = pair.point.covariance + known_variance(known, marker) * Matrix3::Identity();
  Miss m;
  m.distance = miss.norm();
  m.sigma = m.distance > 0 ? std::sqrt(miss.dot(covariance * miss)) / m.distance : std::sqrt(covariance.trace() / 3);
  m.chi2 = miss.dot(covariance.inverse() * miss);
  return m;
}

struct Taken {
  std::vector<int> markers, left, right;
  bool has(const MarkerNode& node, const CornerPair& pair) const {
    auto contains = [](const std::vector<int>& v, int x) { return std::find(v.begin(), v.end(), x) != v.end(); };
    return contains(markers, node.marker) || contains(left, pair.left) || contains(right, pair.right);
  }
  void add(const MarkerNode& node, const CornerPair& pair) {
    markers.push_back(node.marker);
    left.push_back(pair.left);
    right.push_back(pair.right);
  }
};

/// Nodes that the pose meets within the gate, the best first, each marker and corner once.
std::vector<MarkerNode> met_nodes(const std::vector<CornerPair>& pairs, const KnownMarkers& known,
                                  const std::vector<MarkerNode>& all, const Rigid& sensor_from_body, double gate) {
  std::vector<std::pair<double, MarkerNode>> near;
  for (const MarkerNode& node : all) {
    const Miss m = miss_of(pairs[static_cast<std::size_t>(node.pair)], known, node.marker, sensor_from_body);
    // Far along the ray a point is badly known: a marker may be off by what its own sigma allows, no more in sigmas
    // than the gate allows the body in metres.
    if (m.distance <= gate + 3 * m.sigma && m.chi2 < 25 + std::pow(gate / std::max(m.sigma, 1e-6), 2))
      near.push_back({m.chi2, node});
  }
  std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Taken taken;
  std::vector<MarkerNode> met;
  for (const auto& [chi2, node] : near) {
    const CornerPair& pair = pairs[static_cast<std::size_t>(node.pair)];
    if (taken.has(node, pair)) continue;
    taken.add(node, pair);
    met.push_back(node);
  }
  return met;
}

}  // namespace

bool lengths_agree(const std::vector<CornerPair>& pairs, const KnownMarkers& known, const MarkerNode& a,
                   const MarkerNode& b) {
  const StereoPoint& p = pairs[static_cast<std::size_t>(a.pair)].point;
  const StereoPoint& q = pairs[static_cast<std::size_t>(b.pair)].point;
  const Vector3 difference = q.point - p.point;
  const double length = difference.norm();
  if (length < 1e-6) return false;
  const Vector3 along = difference / length;
  const double variance = along.dot((p.covariance + q.covariance) * along) + known_variance(known, a.marker) +
                          known_variance(known, b.marker);
  const double expected = (in_body(known, b.marker) - in_body(known, a.marker)).norm();
  return std::abs(length - expected) <= 3 * std::sqrt(variance);
}

std::optional<BodyHypothesis> body_hypothesis(const std::vector<CornerPair>& pairs, const KnownMarkers& known,
                                              const std::vector<MarkerNode>& seed,
                                              const std::vector<MarkerNode>& all_nodes,
                                              const std::optional<Rigid>& prediction, const MatchOptions& options) {
  BodyHypothesis h;
  h.sensor_from_body = align(pairs, known, seed, prediction);
  h.nodes = met_nodes(pairs, known, all_nodes, h.sensor_from_body, options.marker_gate);
  if (h.nodes.size() < seed.size()) return std::nullopt;
  h.sensor_from_body = align(pairs, known, h.nodes, prediction);
  Vector3 center = Vector3::Zero();
  for (const MarkerNode& node : h.nodes) {
    const Miss m = miss_of(pairs[static_cast<std::size_t>(node.pair)], known, node.marker, h.sensor_from_body);
    if (m.distance > options.marker_gate + 3 * m.sigma) return std::nullopt;
    h.misfit += m.chi2 + std::pow(pairs[static_cast<std::size_t>(node.pair)].unlikeness, 2);
    center += in_body(known, node.marker) / static_cast<double>(h.nodes.size());
  }
  if (prediction) {
    h.body_offset = (h.sensor_from_body * center - *prediction * center).norm();
    h.body_turn = vector_from_rotation(h.sensor_from_body.rotation * prediction->rotation.transpose()).norm();
    // A third of a gate stands for one sigma of what sagging arms do.
    h.misfit += std::pow(3 * h.body_offset / options.body_gate, 2) + std::pow(3 * h.body_turn / options.turn_gate, 2);
  }
  std::sort(h.nodes.begin(), h.nodes.end(),
            [](const MarkerNode& a, const MarkerNode& b) { return a.marker < b.marker; });
  return h;
}

}  // namespace handsight
