// SPDX-License-Identifier: Apache-2.0
#include "blunders/zero_search.h"

#include <cmath>
#include <numbers>

#include "blunders/places.h"
#include "blunders/seen_points.h"

namespace handsight {
namespace {

constexpr double near_quarter =
    1.5 * std::numbers::pi / 180;  // rad: so far from a multiple of 90 degrees it is meant to be that

class ShiftedJoint {
 public:
  ShiftedJoint(const Session& points, const std::string& joint)
      : session_(points), joint_(joint_place(points, joint, "joint_zero")) {}

  double left_at(double shift) {
    for (Observation& o : session_.observations) o.position[joint_] += shift - shift_;
    shift_ = shift;
    const auto found = solve_hand_eye(session_);
    return found ? found->mean_square : 1e30;
  }

 private:
  Session session_;
  Eigen::Index joint_;
  double shift_ = 0;
};

/// The lowest of a valley between two shifts.
double lowest_between(ShiftedJoint& joint, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = joint.left_at(a), at_b = joint.left_at(b);
  for (int i = 0; i < 18; ++i) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      at_a = joint.left_at(a = high - golden * (high - low));
    } else {
      low = a, a = b, at_a = at_b;
      at_b = joint.left_at(b = low + golden * (high - low));
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

double find_zero(const Session& points, const std::string& name) {
  ShiftedJoint joint(points, name);
  const bool slides = joint_named(points, name).kind == JointKind::prismatic;
  const double step = slides ? 0.05 : std::numbers::pi / 12;
  double best = 0, least = joint.left_at(0);
  for (int i = -11; i <= 12; ++i)
    if (const double left = joint.left_at(i * step); left < least) best = i * step, least = left;
  const double found = lowest_between(joint, best - step, best + step);
  const double quarter = std::round(found / (std::numbers::pi / 2)) * (std::numbers::pi / 2);
  return !slides && quarter != 0 && std::abs(found - quarter) < near_quarter ? quarter : found;
}

}  // namespace handsight
