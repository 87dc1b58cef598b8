// SPDX-License-Identifier: Apache-2.0
// The motions that a posture's tangent gives for single changes: of gravity, of masses, of a joint, of all.
#include <cmath>

#include "robot/posture_tangent.h"

namespace handsight {

Vector6 PostureTangent::motion_by_gravity(const Vector3& change) const {
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(unknowns_);
  for (const Block& block : blocks_) {
    const auto i = static_cast<std::size_t>(block.joint);
    auto arm = [&](std::size_t j) -> Vector3 {
      return first_moment(j) - posture_->distal_mass[j] * posture_->root_from_joint[j].translation;
    };
    if (block.kind == Block::angle) {
      for (const Share& s : carried_torques(i)) {
        const auto j = static_cast<std::size_t>(s.joint);
        const Vector3 axis = posture_->root_from_joint[j].rotation * robot_->joints[j].axis;
        const double torque = robot_->joints[j].kind == JointKind::prismatic
                                  ? axis.dot(change) * posture_->distal_mass[j]
                                  : axis.dot(arm(j).cross(change));
        loads[block.first] += slope(i) * s.factor * torque;
      }
    } else if (block.kind == Block::lateral) {
      const Vector3& axis = robot_->joints[i].axis;
      Matrix3 rotation = posture_->root_from_joint[i].rotation;
      if (robot_->joints[i].kind != JointKind::prismatic) rotation *= rotation_about<double>(axis, posture_->value[i]);
      loads.segment<3>(block.first) = change_of(i).lateral_compliance *
                                      (Matrix3::Identity() - axis * axis.transpose()) * rotation.transpose() *
                                      arm(i).cross(change);
    } else {
      loads.segment<2>(block.first) = base_deflection(whole_moment_.cross(change));
    }
  }
  return by_unknown_ * loads;
}

/// By a mass and a first moment about the root's origin, added to a link.
Vector6 PostureTangent::motion_by_mass(int link, double mass, const Vector3& first_moment_in_root) const {
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(unknowns_);
  const int last = robot_->links[static_cast<std::size_t>(link)].parent_joint;
  auto bears = [&](std::size_t i) {
    return last >= 0 && (static_cast<int>(i) == last || carries(i, static_cast<std::size_t>(last)));
  };
  for (const Block& block : blocks_) {
    const auto i = static_cast<std::size_t>(block.joint);
    auto moment = [&](std::size_t j) -> Vector3 {
      const Vector3 arm = first_moment_in_root - mass * posture_->root_from_joint[j].translation;
      return bears(j) ? Vector3(arm.cross(gravity_)) : Vector3(Vector3::Zero());
    };
    if (block.kind == Block::angle) {
      for (const Share& s : carried_torques(i)) {
        const auto j = static_cast<std::size_t>(s.joint);
        const Vector3 axis = posture_->root_from_joint[j].rotation * robot_->joints[j].axis;
        const double torque = robot_->joints[j].kind != JointKind::prismatic ? axis.dot(moment(j))
                              : bears(j)                                     ? mass * axis.dot(gravity_)
                                                                             : 0.0;
        loads[block.first] += slope(i) * s.factor * torque;
      }
    } else if (block.kind == Block::lateral) {
      const Vector3& axis = robot_->joints[i].axis;
      Matrix3 rotation = posture_->root_from_joint[i].rotation;
      if (robot_->joints[i].kind != JointKind::prismatic) rotation *= rotation_about<double>(axis, posture_->value[i]);
      loads.segment<3>(block.first) = change_of(i).lateral_compliance *
                                      (Matrix3::Identity() - axis * axis.transpose()) * rotation.transpose() *
                                      moment(i);
    } else {
      loads.segment<2>(block.first) = base_deflection(first_moment_in_root.cross(gravity_));
    }
  }
  return by_unknown_ * loads;
}

/// Of everything behind a joint, by a change of the motion after its rotation.
Vector6 PostureTangent::motion_after(std::size_t j, const Vector6& change) const {
  const Joint& joint = robot_->joints[j];
  const Rigid link_from_joint = inverse(joint.joint_from_child);
  const Rigid root_from_after = posture_->root_from_link[static_cast<std::size_t>(joint.child_link)] * link_from_joint;
  const Vector6& now = change_of(j).after;
  const Matrix3 before = root_from_after.rotation * rotation_from_vector<double>(now.tail<3>()).transpose();
  Vector6 motion =
      rotation_about_point(before * (left_jacobian(now.tail<3>()) * change.tail<3>()), root_from_after.translation);
  motion.head<3>() += before * change.head<3>();
  return motion;
}

Vector6 PostureTangent::motion_by_joint(std::size_t j, const JointChange& d) const {
  Vector6 motion = d.angle * by_corrected_[j];
  if (!d.frame.isZero(0)) {
    const Rigid& after = posture_->root_from_joint[j];
    const Vector6& now = change_of(j).frame;
    const Matrix3 before = after.rotation * rotation_from_vector<double>(now.tail<3>()).transpose();
    Vector6 change =
        rotation_about_point(before * (left_jacobian(now.tail<3>()) * d.frame.tail<3>()), after.translation);
    change.head<3>() += before * d.frame.head<3>();
    motion += response_[j] * change;
  }
  if (!d.after.isZero(0)) motion += after_response_[j] * motion_after(j, d.after);
  const auto by_deflection = [&](std::size_t i) -> Vector6 {
    Vector6 sum = Vector6::Zero();
    for (const Share& s : by_deflection_[i]) sum += s.factor * by_axis_[static_cast<std::size_t>(s.joint)];
    return sum;
  };
  if (d.compliance != 0) motion += d.compliance * carried_torque(j) * by_deflection(j);
  if (d.gap != 0) motion += d.gap * std::tanh(carried_torque(j) / posture_detail::backlash_torque) * by_deflection(j);
  if (d.lateral_compliance != 0) {
    const Joint& joint = robot_->joints[j];
    Matrix3 rotation = posture_->root_from_joint[j].rotation;
    if (joint.kind != JointKind::prismatic) rotation *= rotation_about<double>(joint.axis, posture_->value[j]);
    const Vector3 moment = rotation.transpose() * posture_->moment[j];
    const Vector3 across = moment - joint.axis * joint.axis.dot(moment);
    motion += after_response_[j] * (lateral_motion(j) * across) * d.lateral_compliance;
  }
  for (const Mimic& mimic : robot_->joints[j].mimics) {
    const auto i = static_cast<std::size_t>(mimic.joint);
    const JointChange& c = change_of(j);
    const double deflection = posture_->deflection.angle[i];
    const double corrected = posture_->value[i] - deflection;
    const double factor = mimic.multiplier + c.multiplier_error;
    motion +=
        (d.multiplier_error * (corrected + c.share * deflection) + d.share * factor * deflection) * by_corrected_[j];
    const double load = (d.multiplier_error * c.share + d.share * factor) * posture_->torque[j];
    if (load != 0) motion += slope(i) * load * by_deflection(i);
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
