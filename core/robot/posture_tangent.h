// SPDX-License-Identifier: Apache-2.0
// How two links of a robot at static equilibrium move against each other when its numbers change: exact first
// derivatives, the answer of the springs to the changed loads included.
#pragma once

#include "robot/posture.h"

namespace handsight {

/// The motion of a rotation w about a point.
inline Vector6 rotation_about_point(const Vector3& w, const Vector3& point) {
  Vector6 motion;
  motion << point.cross(w), w;
  return motion;
}

/// Motions are rates (v, w) of x' = v + w cross x, in the root's frame. Worked out once per posture; every direction
/// of change then costs a few products. Derivation: docs/method.md, "Derivatives of a posture".
class PostureTangent {
 public:
  /// `posture` must be solve_posture's with loads, for the same arguments. `moved` and `reference` are links; a link
  /// 0 as reference stands on the floor.
  PostureTangent(const Robot& robot, const RobotChange& change, const Vector3& gravity, const Posture& posture,
                 int moved, int reference);

  /// The motion of `moved` against `reference` per unit of change along `direction` (a change's numbers, all linear).
  Vector6 motion(const RobotChange& direction) const;

  /// The same for a direction that changes one joint alone.
  Vector6 motion_by_joint(std::size_t joint, const JointChange& direction) const;

  /// The same for a unit of one joint's sensor value (rad, m): mimic joints follow.
  const Vector6& motion_by_value(int joint) const { return by_corrected_[static_cast<std::size_t>(joint)]; }

 private:
  struct Share {  // of a joint's value
    int joint;
    double factor;
  };
  struct Block {  // unknowns of the equilibrium that answer to loads
    enum Kind { angle, lateral, base } kind;
    int joint;
    Eigen::Index first;
    Eigen::Index size() const { return kind == angle ? 1 : kind == lateral ? 3 : 2; }
  };
  using Row6 = Eigen::Matrix<double, 1, 6>;
  struct JointState {  // in the root frame
    Vector3 axis = Vector3::Zero();
    Vector3 first_moment = Vector3::Zero();  // kg m, of what is distal, about the root's origin
    Vector3 arm = Vector3::Zero();           // kg m, about the joint's origin
    Matrix3 root_from_rotated = Matrix3::Identity();
    std::vector<Share> carried;  // the torques that its spring carries: its own, and with a linkage its mimic joints'
    double carried_torque = 0;
    double slope = 0;  // d deflection / d carried torque
  };

  const JointChange& change_of(std::size_t joint) const;
  bool carries(std::size_t k, std::size_t i) const;
  const Vector3& first_moment(std::size_t k) const { return joints_[k].first_moment; }
  Vector6 axis_motion(std::size_t k) const;
  Eigen::Matrix<double, 6, 3> lateral_motion(std::size_t k) const;
  Row6 torque_by_motion(std::size_t i, std::size_t k, bool moves_own_frame) const;
  Eigen::Matrix<double, 3, 6> moment_by_motion(std::size_t i, std::size_t k, bool moves_own_frame) const;
  const std::vector<Share>& carried_torques(std::size_t joint) const { return joints_[joint].carried; }
  double slope(std::size_t joint) const { return joints_[joint].slope; }
  double carried_torque(std::size_t joint) const { return joints_[joint].carried_torque; }
  void describe_joints();
  Eigen::Vector2d base_deflection(const Vector3& root_moment) const;
  void list_unknowns();
  void add_value_shares();
  Eigen::MatrixXd loads_by_motion(std::size_t k, bool moves_own_frame) const;
  void answer_to_loads();
  Vector6 motion_after(std::size_t joint, const Vector6& change) const;
  Vector6 motion_by_gravity(const Vector3& change) const;
  Vector6 motion_by_mass(int link, double mass, const Vector3& first_moment_in_root) const;

  const Robot* robot_;
  const RobotChange* change_;
  Vector3 gravity_;  // tilted
  const Posture* posture_;
  std::vector<JointState> joints_;
  std::vector<std::vector<char>> above_;  // [i][k]: is joint k on the way from the root to joint i, i itself excluded
  std::vector<double> direct_;            // per joint: 1 moves `moved`, -1 `reference`, 0 both or neither
  double base_direct_ = 0;
  Vector3 whole_moment_ = Vector3::Zero();         // kg m about the root's origin, of all links
  Vector3 turned_moment_ = Vector3::Zero();        // ... of all but the root
  std::vector<std::vector<Share>> by_value_;       // per joint: what a unit of its corrected angle adds to the values
  std::vector<std::vector<Share>> by_deflection_;  // ... and a unit of its deflection
  std::vector<Block> blocks_;
  Eigen::Index unknowns_ = 0;
  std::vector<Matrix6> response_;        // per joint: motion by a motion of all from its frame on
  std::vector<Matrix6> after_response_;  // ... of all after it, its own frame at rest
  Matrix6 base_response_ = Matrix6::Zero();
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_unknown_;  // motion by a unit added to an unknown, springs included
  std::vector<Vector6> by_axis_;                         // motion by a unit of a joint's own value alone
  std::vector<Vector6> by_corrected_;
};

}  // namespace handsight
