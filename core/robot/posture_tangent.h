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
    /// The lateral deflection has no part along the axis.
    Eigen::Index size() const { return kind == angle ? 1 : 2; }
  };
  /// How a block's unknowns answer to what one joint (or the base) bears: at most two rows are used.
  struct Load {
    using Rows = Eigen::Matrix<double, 2, 3>;
    std::size_t block;
    int joint;                      // whose load it is; -1: the base's
    Rows by_moment = Rows::Zero();  // unknowns by the moment about the joint's origin, root frame
    Rows by_force = Rows::Zero();   // ... by the force (sliding joints)
    Rows by_turn = Rows::Zero();    // ... by a turn of the joint itself and all that it bears
  };
  using Columns3 = Eigen::Matrix<double, 6, 3>;
  struct LoadAnswer {  // the motion of `moved` by what Load is by, springs included
    Columns3 by_moment, by_force, by_turn;
  };
  struct JointState {  // in the root frame
    Vector3 axis = Vector3::Zero();
    Vector3 first_moment = Vector3::Zero();        // kg m, of what is distal, about the root's origin
    Vector3 arm = Vector3::Zero();                 // kg m, about the joint's origin
    Matrix3 shift_by_frame = Matrix3::Identity();  // of all from its frame on, by the change of its frame: m by m
    Matrix3 turn_by_frame = Matrix3::Identity();   // ... rad by rad
    std::vector<Share> mimics_carried;             // torques that its spring carries beside its own: a linkage's
    double carried_torque = 0;
    double slope = 0;  // d deflection / d carried torque
  };

  const JointChange& find_change(std::size_t joint) const;
  bool carries(std::size_t k, std::size_t i) const { return above_[i * joints_.size() + k] != 0; }
  bool slides(std::size_t k) const { return robot_->joints[k].kind == JointKind::prismatic; }
  Vector6 axis_motion(std::size_t k) const;
  Columns3 lateral_motion(std::size_t k) const;
  Eigen::Matrix<double, 3, 6> moment_of_masses(double mass, const Vector3& first_moment) const;
  double slope(std::size_t joint) const { return joints_[joint].slope; }
  double carried_torque(std::size_t joint) const { return joints_[joint].carried_torque; }
  Vector6 motion_by_deflection(std::size_t joint) const;
  void sum_masses();
  void mark_carried(int moved, int reference);
  void describe_joints();
  Eigen::Vector2d base_deflection(const Vector3& root_moment) const;
  void list_unknowns();
  void add_load(std::size_t block, std::size_t joint, const Load::Rows& by_moment, const Load::Rows& by_force);
  void list_loads();
  void add_value_shares();
  template <int N>
  void add_through(const Eigen::Matrix<double, 6, N>& motion, int joint, bool moves_own_frame,
                   Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, N>> through) const;
  void solve_springs();
  void answer_to_motions();
  Vector6 motion_after(std::size_t joint, const Vector6& change) const;
  Vector6 motion_by_gravity(const Vector3& change) const;
  Vector6 motion_by_mass(int link, double mass, const Vector3& first_moment_in_root) const;

  const Robot* robot_;
  const RobotChange* change_;
  Vector3 gravity_;  // tilted
  Matrix3 gravity_cross_;
  const Posture* posture_;
  std::vector<JointState> joints_;
  std::vector<char> above_;     // [i * joints + k]: is joint k on the way from the root to joint i, i itself excluded
  std::vector<double> direct_;  // per joint: 1 moves `moved`, -1 `reference`, 0 both or neither
  double base_direct_ = 0;
  Vector3 whole_moment_ = Vector3::Zero();         // kg m about the root's origin, of all links
  Vector3 turned_moment_ = Vector3::Zero();        // ... of all but the root
  std::vector<std::vector<Share>> by_value_;       // per joint: what mimic joints add to a unit of its corrected angle
  std::vector<std::vector<Share>> by_deflection_;  // ... and of its deflection
  std::vector<Block> blocks_;
  Eigen::Index unknowns_ = 0;
  std::vector<Load> loads_;
  std::vector<LoadAnswer> answers_;      // of loads_
  std::vector<Matrix6> response_;        // per joint: motion by a motion of all from its frame on
  std::vector<Matrix6> after_response_;  // ... of all after it, its own frame at rest
  Matrix6 base_response_ = Matrix6::Zero();
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_unknown_;  // motion by a unit added to an unknown, springs included
  std::vector<Vector6> by_axis_;                         // motion by a unit of a joint's own value alone
  std::vector<Vector6> by_corrected_;
};

}  // namespace handsight
