// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/dh.h"

#include <cmath>

namespace handsight {
namespace {

/// A joint's axis with the robot at zero, in the root's frame.
struct Axis {
  int joint = 0;
  Vector3 point, direction;
};

struct Axes {
  std::vector<Axis> all;
  Rigid root_from_link;
};

Axes axes_to(const Robot& robot, int link) {
  Axes axes;
  Rigid root_from_here;
  for (const int j : joints_to(robot, link)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    root_from_here = root_from_here * joint.parent_from_joint;
    if (joint.moves()) axes.all.push_back({j, root_from_here.translation, root_from_here.rotation * joint.axis});
    root_from_here = root_from_here * joint.joint_from_child;
  }
  axes.root_from_link = root_from_here;
  return axes;
}

/// A rotation whose z is this direction; its x is the direction nearest to `x`.
Matrix3 frame_along(const Vector3& z, const Vector3& x) {
  Vector3 across = x - z * z.dot(x);
  if (across.norm() < 1e-6) across = z.unitOrthogonal();
  Matrix3 frame;
  frame.col(0) = across.normalized();
  frame.col(2) = z;
  frame.col(1) = z.cross(frame.col(0));
  return frame;
}

Rigid turned_about(const Vector3& axis, double angle) { return {rotation_about<double>(axis, angle), Vector3::Zero()}; }
Rigid shifted(const Vector3& axis, double by) { return {Matrix3::Identity(), Vector3(by * axis)}; }

/// About and along z (theta, d), and about and along x (alpha, a) from one axis to the next, in the frame whose z is
/// the first axis.
struct Screws {
  double theta = 0, d = 0, a = 0, alpha = 0;
};

/// The same screws with x the other way, where that turns theta less: tables are read by people, whose zeros are near.
Screws with_small_turn(Screws s) {
  if (std::abs(s.theta) <= M_PI / 2 + 1e-9) return s;
  s.theta -= std::copysign(M_PI, s.theta);
  s.a = -s.a;
  s.alpha = -s.alpha;
  return s;
}

Screws screws_between(const Rigid& root_from_frame, const Axis& next) {
  constexpr double parallel = 1e-12;
  const Rigid frame_from_root = inverse(root_from_frame);
  const Vector3 direction = frame_from_root.rotation * next.direction, point = frame_from_root * next.point;
  Screws s;
  const double across = std::hypot(direction.x(), direction.y());
  s.alpha = std::atan2(across, direction.z());
  if (across < parallel) {  // the common normal through this frame's origin
    s.alpha = direction.z() > 0 ? 0 : M_PI;
    s.a = std::hypot(point.x(), point.y());
    if (s.a > parallel) s.theta = std::atan2(point.y(), point.x());
    return s;
  }
  // x is across both axes: z cross direction. The axes cross or pass each other at d along z.
  s.theta = std::atan2(direction.x(), -direction.y());
  const Vector3 x(std::cos(s.theta), std::sin(s.theta), 0), y(-x.y(), x.x(), 0);
  s.a = point.dot(x);
  // The next axis in the plane of y and z: (0, -sin alpha, cos alpha) through (point.y, point.z).
  s.d = point.z() + point.dot(y) * std::cos(s.alpha) / std::sin(s.alpha);
  return s;
}

}  // namespace

Rigid modified_motion(const DhRow& r, double value, bool slides) {
  const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  return turned_about(x, r.alpha) * shifted(x, r.a) * turned_about(z, r.theta + (slides ? 0 : value)) *
         shifted(z, r.d + (slides ? value : 0));
}

Rigid classical_motion(const DhRow& r, double value, bool slides) {
  const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  return turned_about(z, r.theta + (slides ? 0 : value)) * shifted(z, r.d + (slides ? value : 0)) * shifted(x, r.a) *
         turned_about(x, r.alpha);
}

DhChain classical_dh(const Robot& robot, int link) {
  const Axes axes = axes_to(robot, link);
  DhChain chain;
  if (axes.all.empty()) {
    chain.tool = axes.root_from_link;
    return chain;
  }
  chain.base = {frame_along(axes.all[0].direction, Vector3::UnitX()), axes.all[0].point};
  Rigid root_from_frame = chain.base;
  for (std::size_t i = 0; i < axes.all.size(); ++i) {
    const bool is_last = i + 1 == axes.all.size();
    const Screws s = is_last ? Screws{} : with_small_turn(screws_between(root_from_frame, axes.all[i + 1]));
    chain.rows.push_back({axes.all[i].joint, s.a, s.alpha, s.d, s.theta});
    root_from_frame = root_from_frame * classical_motion(chain.rows.back(), 0, false);
  }
  chain.tool = inverse(root_from_frame) * axes.root_from_link;
  return chain;
}

DhChain modified_dh(const Robot& robot, int link) {
  DhChain chain = classical_dh(robot, link);
  // The same screws, grouped otherwise: a and alpha stand with the joint after them.
  double a = 0, alpha = 0;
  for (DhRow& row : chain.rows) {
    std::swap(row.a, a);
    std::swap(row.alpha, alpha);
  }
  return chain;
}

}  // namespace handsight
