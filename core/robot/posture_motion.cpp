// SPDX-License-Identifier: Apache-2.0
// The motions that a posture's tangent gives for single changes: of gravity, of masses, of a joint, of all.
#include <cmath>

#include "robot/posture_tangent.h"

namespace handsight {

Vector6 PostureTangent::motion_by_gravity(const Vector3& change) const {
  Vector6 motion = Vector6::Zero();
  for (std::size_t l = 0; l < loads_.size(); ++l) {
    const int joint = loads_[l].joint;
    const auto i = static_cast<std::size_t>(joint);
    const Vector3& first_moment = joint < 0 ? whole_moment_ : joints_[i].arm;
    motion += answers_[l].by_moment * first_moment.cross(change);
    if (joint >= 0 && slides(i)) motion += answers_[l].by_force * (posture_->distal_mass[i] * change);
  }
  return motion;
}

/// By a mass and a first moment about the root's origin, added to a link.
Vector6 PostureTangent::motion_by_mass(int link, double mass, const Vector3& first_moment_in_root) const {
  Vector6 motion = Vector6::Zero();
  const int last = robot_->links[static_cast<std::size_t>(link)].parent_joint;
  for (std::size_t l = 0; l < loads_.size(); ++l) {
    const int joint = loads_[l].joint;
    const auto i = static_cast<std::size_t>(joint);
    if (joint < 0) {
      motion += answers_[l].by_moment * first_moment_in_root.cross(gravity_);
    } else if (last >= 0 && (joint == last || carries(i, static_cast<std::size_t>(last)))) {
      const Vector3 arm = first_moment_in_root - mass * posture_->root_from_joint[i].translation;
      motion += answers_[l].by_moment * arm.cross(gravity_);
      if (slides(i)) motion += answers_[l].by_force * (mass * gravity_);
    }
  }
  return motion;
}

/// Of everything behind a joint, by a change of the motion after its rotation.
Vector6 PostureTangent::motion_after(std::size_t j, const Vector6& change) const {
  const Joint& joint = robot_->joints[j];
  const Rigid link_from_joint = inverse(joint.joint_from_child);
  const Rigid root_from_after = posture_->root_from_link[static_cast<std::size_t>(joint.child_link)] * link_from_joint;
  const Vector6& now = find_change(j).after;
  const Matrix3 before = root_from_after.rotation * rotation_from_vector<double>(now.tail<3>()).transpose();
  Vector6 motion =
      rotation_about_point(before * (left_jacobian(now.tail<3>()) * change.tail<3>()), root_from_after.translation);
  motion.head<3>() += before * change.head<3>();
  return motion;
}

Vector6 PostureTangent::motion_by_deflection(std::size_t joint) const {
  Vector6 motion = by_axis_[joint];
  for (const Share& s : by_deflection_[joint]) motion += s.factor * by_axis_[static_cast<std::size_t>(s.joint)];
  return motion;
}

Vector6 PostureTangent::motion_by_joint(std::size_t j, const JointChange& d) const {
  Vector6 motion = d.angle * by_corrected_[j];
  if (!d.frame.isZero(0)) {
    const JointState& s = joints_[j];
    Vector6 change =
        rotation_about_point(s.turn_by_frame * d.frame.tail<3>(), posture_->root_from_joint[j].translation);
    change.head<3>() += s.shift_by_frame * d.frame.head<3>();
    motion += response_[j] * change;
  }
  if (!d.after.isZero(0)) motion += after_response_[j] * motion_after(j, d.after);
  if (d.compliance != 0) motion += d.compliance * carried_torque(j) * motion_by_deflection(j);
  if (d.gap != 0)
    motion += d.gap * std::tanh(carried_torque(j) / posture_detail::backlash_torque) * motion_by_deflection(j);
  if (d.lateral_compliance != 0) {
    const Vector3& axis = robot_->joints[j].axis;
    const Vector3 moment = posture_->root_from_turned[j].transpose() * posture_->moment[j];
    const Vector3 across = moment - axis * axis.dot(moment);
    motion += after_response_[j] * (lateral_motion(j) * across) * d.lateral_compliance;
  }
  for (const Mimic& mimic : robot_->joints[j].mimics) {
    const auto i = static_cast<std::size_t>(mimic.joint);
    const JointChange& c = find_change(j);
    const double deflection = posture_->deflection.angle[i];
    const double corrected = posture_->value[i] - deflection;
    const double factor = mimic.multiplier + c.multiplier_error;
    motion +=
        (d.multiplier_error * (corrected + c.share * deflection) + d.share * factor * deflection) * by_corrected_[j];
    const double load = (d.multiplier_error * c.share + d.share * factor) * posture_->torque[j];
    if (load != 0) motion += slope(i) * load * motion_by_deflection(i);
  }
  return motion;
}

Vector6 PostureTangent::motion(const RobotChange& direction) const {
  Vector6 motion = Vector6::Zero();
  for (std::size_t j = 0; j < direction.joints.size(); ++j)
    if (robot_->joints[j].moves()) motion += motion_by_joint(j, direction.joints[j]);
  if (direction.tilt_x != 0 || direction.tilt_y != 0) {
    const Vector3 turn =
        left_jacobian({change_->tilt_x, change_->tilt_y, 0}) * Vector3(direction.tilt_x, direction.tilt_y, 0);
    motion += motion_by_gravity(turn.cross(gravity_));
  }
  const Vector3& b = direction.base_compliance;
  if (!b.isZero(0)) {
    const Vector3 m = whole_moment_.cross(gravity_);
    const Vector3 turn(b.x() * m.x() + b.y() * m.y(), b.y() * m.x() + b.z() * m.y(), 0);
    Vector6 change = Vector6::Zero();
    change.tail<3>() = left_jacobian(posture_->deflection.base) * turn;
    motion += base_response_ * change;
  }
  if (direction.payload_link >= 0 && (direction.payload_mass != 0 || !direction.payload_moment.isZero(0))) {
    const auto link = static_cast<std::size_t>(direction.payload_link);
    const Rigid& root_from_link = posture_->root_from_link[link];
    const Vector3 center = root_from_link * robot_->links[link].center_of_mass;
    motion += motion_by_mass(direction.payload_link, direction.payload_mass,
                             center * direction.payload_mass + root_from_link.rotation * direction.payload_moment);
  }
  return motion;
}

}  // namespace handsight
