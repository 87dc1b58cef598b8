// SPDX-License-Identifier: Apache-2.0
#include "robot/posture_tangent.h"

#include <Eigen/LU>
#include <cmath>

namespace handsight {
namespace {

const JointChange no_change{};
constexpr auto whole = static_cast<std::size_t>(-1);  // the robot as a whole, in place of a joint: all but its root

}  // namespace

PostureTangent::PostureTangent(const Robot& robot, const RobotChange& change, const Vector3& gravity,
                               const Posture& posture, int moved, int reference)
    : robot_(&robot),
      change_(&change),
      gravity_(posture_detail::tilted_gravity<double>(gravity, change)),
      posture_(&posture) {
  const std::size_t count = robot.joints.size();
  above_.assign(count, std::vector<char>(count, 0));
  direct_.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = robot.links[static_cast<std::size_t>(robot.joints[i].parent_link)].parent_joint;
    if (parent < 0) continue;
    above_[i] = above_[static_cast<std::size_t>(parent)];
    above_[i][static_cast<std::size_t>(parent)] = 1;
  }
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Link& link = robot.links[l];
    Vector3 moment = link.mass * link.center_of_mass;
    double mass = link.mass;
    if (static_cast<int>(l) == change.payload_link) {
      moment += change.payload_mass * link.center_of_mass + change.payload_moment;
      mass += change.payload_mass;
    }
    const Rigid& root_from_link = posture.root_from_link[l];
    moment = root_from_link.rotation * moment + mass * root_from_link.translation;
    whole_moment_ += moment;
    if (l != 0) turned_moment_ += moment;
  }
  for (const auto& [link, sign] : {std::pair(moved, 1.0), std::pair(reference, -1.0)}) {
    if (link != 0) base_direct_ += sign;
    for (int j = robot.links[static_cast<std::size_t>(link)].parent_joint; j >= 0;
         j = robot.links[static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(j)].parent_link)].parent_joint)
      direct_[static_cast<std::size_t>(j)] += sign;
  }
  describe_joints();
  add_value_shares();
  list_unknowns();
  answer_to_loads();
}

const JointChange& PostureTangent::change_of(std::size_t joint) const {
  return change_->joints.empty() ? no_change : change_->joints[joint];
}

bool PostureTangent::carries(std::size_t k, std::size_t i) const { return k == whole || above_[i][k] != 0; }

/// Of everything behind a joint, by a unit of its value.
Vector6 PostureTangent::axis_motion(std::size_t k) const {
  const Vector3& axis = joints_[k].axis;
  if (robot_->joints[k].kind != JointKind::prismatic)
    return rotation_about_point(axis, posture_->root_from_joint[k].translation);
  Vector6 motion;
  motion << axis, Vector3::Zero();
  return motion;
}

/// Of everything behind a joint, by its lateral deflection (in the rotated frame).
Eigen::Matrix<double, 6, 3> PostureTangent::lateral_motion(std::size_t k) const {
  Vector3 origin = posture_->root_from_joint[k].translation;
  if (robot_->joints[k].kind == JointKind::prismatic) origin += joints_[k].axis * posture_->value[k];
  const Matrix3 turned = joints_[k].root_from_rotated * left_jacobian(posture_->deflection.lateral[k]);
  Eigen::Matrix<double, 6, 3> motion;
  motion << cross_matrix(origin) * turned, turned;
  return motion;
}

/// Joint i's torque (force) by a motion of all from joint k's frame on; `moves_own_frame` false: of all after it.
PostureTangent::Row6 PostureTangent::torque_by_motion(std::size_t i, std::size_t k, bool moves_own_frame) const {
  Row6 row = Row6::Zero();
  const Vector3& axis = joints_[i].axis;
  const bool is_force = robot_->joints[i].kind == JointKind::prismatic;
  if (carries(k, i) || (i == k && moves_own_frame)) {
    // Carried as a whole, it sees gravity turn the other way.
    const Vector3& arm = joints_[i].arm;
    const Vector3 by_turn =
        is_force ? Vector3(posture_->distal_mass[i] * axis.cross(gravity_)) : Vector3(axis.cross(arm).cross(gravity_));
    row.tail<3>() = by_turn;
  } else if (!is_force && (i == k || carries(i, k))) {
    const Vector3 pull = gravity_.cross(axis);
    row.head<3>() = posture_->distal_mass[k] * pull;
    row.tail<3>() = first_moment(k).cross(pull);
  }
  return row;
}

/// The same of joint i's moment, as seen in its own frame but written in the root's.
Eigen::Matrix<double, 3, 6> PostureTangent::moment_by_motion(std::size_t i, std::size_t k, bool moves_own_frame) const {
  Eigen::Matrix<double, 3, 6> rows = Eigen::Matrix<double, 3, 6>::Zero();
  const Matrix3 g = cross_matrix(gravity_);
  if (carries(k, i) || (i == k && moves_own_frame)) {
    const Vector3& arm = joints_[i].arm;
    rows.rightCols<3>() = cross_matrix(arm) * g;
  } else if (i == k || carries(i, k)) {
    rows.leftCols<3>() = -posture_->distal_mass[k] * g;
    rows.rightCols<3>() = g * cross_matrix(first_moment(k));
  }
  return rows;
}

void PostureTangent::describe_joints() {
  joints_.resize(robot_->joints.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = robot_->joints[i];
    JointState& s = joints_[i];
    if (!joint.moves()) continue;
    const Rigid& frame = posture_->root_from_joint[i];
    s.axis = frame.rotation * joint.axis;
    s.first_moment = posture_->distal_mass[i] * posture_->distal_center[i];
    s.arm = s.first_moment - posture_->distal_mass[i] * frame.translation;
    s.root_from_rotated = frame.rotation;
    if (joint.kind != JointKind::prismatic)
      s.root_from_rotated = frame.rotation * rotation_about<double>(joint.axis, posture_->value[i]);
    s.carried = {{static_cast<int>(i), 1.0}};
  }
  if (!change_->joints.empty())
    for (std::size_t m = 0; m < joints_.size(); ++m)
      for (const Mimic& mimic : robot_->joints[m].mimics)
        if (change_of(m).share != 0)
          joints_[static_cast<std::size_t>(mimic.joint)].carried.push_back(
              {static_cast<int>(m), change_of(m).share * (mimic.multiplier + change_of(m).multiplier_error)});
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    JointState& s = joints_[i];
    const JointChange& c = change_of(i);
    for (const Share& share : s.carried)
      s.carried_torque += share.factor * posture_->torque[static_cast<std::size_t>(share.joint)];
    const double stiffness = robot_->joints[i].stiffness;
    s.slope = c.compliance + (stiffness > 0 ? 1 / stiffness : 0);
    if (c.gap == 0) continue;
    const double t = std::tanh(s.carried_torque / posture_detail::backlash_torque);
    s.slope += c.gap * (1 - t * t) / posture_detail::backlash_torque;
  }
}

Eigen::Vector2d PostureTangent::base_deflection(const Vector3& root_moment) const {
  const Vector3& b = change_->base_compliance;
  return {b.x() * root_moment.x() + b.y() * root_moment.y(), b.y() * root_moment.x() + b.z() * root_moment.y()};
}

void PostureTangent::add_value_shares() {
  const std::size_t count = robot_->joints.size();
  by_value_.assign(count, {});
  by_deflection_.assign(count, {});
  std::vector<char> done(count, 0);
  auto add = [&](auto&& self, std::size_t j) -> void {
    if (done[j]) return;
    done[j] = 1;
    by_value_[j] = by_deflection_[j] = {{static_cast<int>(j), 1.0}};
    for (std::size_t m = 0; m < count; ++m)
      for (const Mimic& mimic : robot_->joints[m].mimics) {
        if (mimic.joint != static_cast<int>(j)) continue;
        self(self, m);  // the reader has refused mimic loops
        const double factor = mimic.multiplier + change_of(m).multiplier_error;
        for (const Share& s : by_value_[m]) {
          by_value_[j].push_back({s.joint, factor * s.factor});
          if (change_of(m).share != 0) by_deflection_[j].push_back({s.joint, factor * change_of(m).share * s.factor});
        }
      }
  };
  for (std::size_t j = 0; j < count; ++j)
    if (robot_->joints[j].moves()) add(add, j);
}

void PostureTangent::list_unknowns() {
  auto add = [&](Block::Kind kind, std::size_t joint) {
    blocks_.push_back({kind, static_cast<int>(joint), unknowns_});
    unknowns_ += blocks_.back().size();
  };
  for (std::size_t j = 0; j < robot_->joints.size(); ++j) {
    if (!robot_->joints[j].moves()) continue;
    if (slope(j) != 0) add(Block::angle, j);
    if (change_of(j).lateral_compliance != 0) add(Block::lateral, j);
  }
  if (!change_->base_compliance.isZero(0)) add(Block::base, 0);
}

/// Every unknown by a motion of all from joint k's frame on: unknowns x 6.
Eigen::MatrixXd PostureTangent::loads_by_motion(std::size_t k, bool moves_own_frame) const {
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(unknowns_, 6);
  for (const Block& block : blocks_) {
    const auto i = static_cast<std::size_t>(block.joint);
    if (block.kind == Block::angle) {
      for (const Share& s : carried_torques(i))
        loads.row(block.first) +=
            slope(i) * s.factor * torque_by_motion(static_cast<std::size_t>(s.joint), k, moves_own_frame);
    } else if (block.kind == Block::lateral) {
      const Matrix3& root_from_rotated = joints_[i].root_from_rotated;
      const Vector3& axis = robot_->joints[i].axis;
      loads.middleRows<3>(block.first) = change_of(i).lateral_compliance *
                                         (Matrix3::Identity() - axis * axis.transpose()) *
                                         root_from_rotated.transpose() * moment_by_motion(i, k, moves_own_frame);
    } else {
      const Matrix3 g = cross_matrix(gravity_);
      Eigen::Matrix<double, 3, 6> rows;  // the base only turns about the root's origin
      rows << -(k == whole ? 0.0 : posture_->distal_mass[k]) * g,
          g * cross_matrix<double>(k == whole ? turned_moment_ : first_moment(k));
      for (int c = 0; c < 6; ++c) loads.col(c).segment<2>(block.first) += base_deflection(rows.col(c));
    }
  }
  return loads;
}

void PostureTangent::answer_to_loads() {
  const std::size_t count = robot_->joints.size();
  response_.assign(count, Matrix6::Zero());
  after_response_.assign(count, Matrix6::Zero());
  by_axis_.assign(count, Vector6::Zero());
  by_corrected_.assign(count, Vector6::Zero());
  std::vector<Eigen::MatrixXd> loads(count), after(count);
  Eigen::MatrixXd base_loads;
  if (unknowns_ > 0) {
    for (std::size_t k = 0; k < count; ++k) {
      if (!robot_->joints[k].moves()) continue;
      loads[k] = loads_by_motion(k, true);
      after[k] = loads_by_motion(k, false);
    }
    base_loads = loads_by_motion(whole, true);
  }
  // What a unit of each unknown moves directly, and how it changes all unknowns through the loads.
  Eigen::MatrixXd through = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
  by_unknown_ = Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, unknowns_);
  for (const Block& block : blocks_) {
    const auto j = static_cast<std::size_t>(block.joint);
    if (block.kind == Block::angle) {
      for (const Share& s : by_deflection_[j]) {
        const auto k = static_cast<std::size_t>(s.joint);
        const Vector6 motion = s.factor * axis_motion(k);
        by_unknown_.col(block.first) += direct_[k] * motion;
        const bool own = robot_->joints[k].kind != JointKind::prismatic;
        through.col(block.first) += (own ? loads[k] : after[k]) * motion;
      }
    } else if (block.kind == Block::lateral) {
      const Eigen::Matrix<double, 6, 3> motion = lateral_motion(j);
      by_unknown_.middleCols<3>(block.first) = direct_[j] * motion;
      through.middleCols<3>(block.first) = after[j] * motion;
    } else {
      Eigen::Matrix<double, 6, 2> motion = Eigen::Matrix<double, 6, 2>::Zero();
      motion.bottomRows<3>() = left_jacobian(posture_->deflection.base).leftCols<2>();
      by_unknown_.middleCols<2>(block.first) = base_direct_ * motion;
      through.middleCols<2>(block.first) = base_loads * motion;
    }
  }
  if (unknowns_ > 0) {
    const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(unknowns_, unknowns_) - through;
    by_unknown_ =
        Eigen::PartialPivLU<Eigen::MatrixXd>(system.transpose()).solve(by_unknown_.transpose()).transpose().eval();
    base_response_ = by_unknown_ * base_loads;
  }
  base_response_ += base_direct_ * Matrix6::Identity();
  for (std::size_t k = 0; k < count; ++k) {
    if (!robot_->joints[k].moves()) continue;
    response_[k] = after_response_[k] = direct_[k] * Matrix6::Identity();
    if (unknowns_ > 0) {
      response_[k] += by_unknown_ * loads[k];
      after_response_[k] += by_unknown_ * after[k];
    }
    const bool own = robot_->joints[k].kind != JointKind::prismatic;
    by_axis_[k] = (own ? response_[k] : after_response_[k]) * axis_motion(k);
  }
  for (std::size_t k = 0; k < count; ++k)
    for (const Share& s : by_value_[k]) by_corrected_[k] += s.factor * by_axis_[static_cast<std::size_t>(s.joint)];
}

}  // namespace handsight
