// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_shadow_lines.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr double reach_px = 64, reach_of_several = 192;  // px, to who saw an edge
constexpr double same_line = 1.5, drift_share = 0.03;    // px, and px a px of the way: between what two saw of one edge
constexpr double same_direction = 0.1;                   // sine
constexpr double usual_reach = 32;                       // px: what is nearer tells more
constexpr double arm_length = 4;                         // px, over which each tells the edge's direction

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

void ShadowLines::add(const CornerModel& beside) {
  Seen seen;
  seen.edge = beside.shadow, seen.from = beside.position;
  seen.normal = {std::cos(seen.edge.direction), std::sin(seen.edge.direction)};
  seen.foot = seen.from + seen.edge.distance * seen.normal;
  for (Seen& other : seen_)
    if (agree(seen, other)) ++seen.agree, ++other.agree;
  seen_.push_back(seen);
}

bool ShadowLines::agree(const Seen& a, const Seen& b) {
  const Eigen::Vector2d way = b.foot - a.foot;
  const double far = way.norm(), most = same_line + drift_share * far;
  return far < reach_of_several && std::abs(cross(a.normal, b.normal)) < same_direction &&
         std::abs(a.normal.dot(way)) < most && std::abs(b.normal.dot(way)) < most;
}

ShadowEdge ShadowLines::edge_at(const Eigen::Vector2d& position, const Seen& one) const {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double weights = 0;
  const auto each = [&](const auto& act) {
    for (const Seen& seen : seen_) {
      if (&seen != &one && !agree(one, seen)) continue;
      act(seen, 1 / (1 + (seen.foot - position).squaredNorm() / (usual_reach * usual_reach)));
    }
  };
  each([&](const Seen& seen, double weight) { middle += weight * seen.foot, weights += weight; });
  middle /= weights;
  // Of the line through all feet, which each tells the direction of too: the moments round the middle.
  double uu = 0, uv = 0, vv = 0;
  each([&](const Seen& seen, double weight) {
    const Eigen::Vector2d along(-seen.normal.y(), seen.normal.x()), off = seen.foot - middle;
    const double arm = arm_length * arm_length;
    uu += weight * (off.x() * off.x() + arm * along.x() * along.x());
    uv += weight * (off.x() * off.y() + arm * along.x() * along.y());
    vv += weight * (off.y() * off.y() + arm * along.y() * along.y());
  });
  const double angle = 0.5 * std::atan2(2 * uv, uu - vv);
  Eigen::Vector2d normal(-std::sin(angle), std::cos(angle));
  if (normal.dot(one.normal) < 0) normal = -normal;
  ShadowEdge edge = one.edge;
  edge.direction = std::atan2(normal.y(), normal.x());
  edge.distance = normal.dot(middle - position);
  return edge;
}

std::vector<NearShadow> ShadowLines::near(const Eigen::Vector2d& position, double farthest, int since) const {
  const Seen *shared = nullptr, *nearest = nullptr;
  double to_shared = reach_of_several * reach_of_several, to_nearest = reach_px * reach_px;
  bool is_new = false;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Seen& seen = seen_[i];
    const double far = (seen.from - position).squaredNorm(), reach = seen.agree > 0 ? reach_of_several : reach_px;
    is_new |= static_cast<int>(i) >= since && far < reach * reach;
    if (far < to_nearest) to_nearest = far, nearest = &seen;
    if (seen.agree > 0 && far < to_shared) to_shared = far, shared = &seen;
  }
  std::vector<NearShadow> edges;
  if (!is_new) return edges;
  const auto add = [&](const Seen* one) {
    if (!one) return;
    const ShadowEdge edge = edge_at(position, *one);
    if (std::abs(edge.distance) < farthest) edges.push_back({edge, one->agree > 0});
  };
  add(shared);
  if (nearest != shared && !(shared && nearest && agree(*shared, *nearest))) add(nearest);
  return edges;
}

}  // namespace handsight
