// SPDX-License-Identifier: Apache-2.0
#include "robot/posture_tangent.h"

#include <Eigen/LU>
#include <cmath>

namespace handsight {
namespace {

const JointChange no_change{};

/// Two unit vectors across a unit vector, as rows.
Eigen::Matrix<double, 2, 3> across(const Vector3& axis) {
  Eigen::Matrix<double, 2, 3> rows;
  rows.row(0) = axis.cross(std::abs(axis.x()) < 0.9 ? Vector3::UnitX() : Vector3::UnitY()).normalized();
  rows.row(1) = axis.cross(rows.row(0).transpose());
  return rows;
}

}  // namespace

PostureTangent::PostureTangent(const Robot& robot, const RobotChange& change, const Vector3& gravity,
                               const Posture& posture, int moved, int reference)
    : robot_(&robot),
      change_(&change),
      gravity_(posture_detail::tilted_gravity<double>(gravity, change)),
      gravity_cross_(cross_matrix(gravity_)),
      posture_(&posture) {
  mark_carried(moved, reference);
  sum_masses();
  describe_joints();
  add_value_shares();
  list_unknowns();
  list_loads();
  solve_springs();
  answer_to_motions();
}

const JointChange& PostureTangent::find_change(std::size_t joint) const {
  return change_->joints.empty() ? no_change : change_->joints[joint];
}

void PostureTangent::mark_carried(int moved, int reference) {
  const std::size_t count = robot_->joints.size();
  joints_.resize(count);
  above_.assign(count * count, 0);
  direct_.assign(count, 0);
  const auto parent_of = [&](int link) { return robot_->links[static_cast<std::size_t>(link)].parent_joint; };
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = parent_of(robot_->joints[i].parent_link);
    if (parent < 0) continue;
    const auto p = static_cast<std::size_t>(parent);
    std::copy_n(&above_[p * count], count, &above_[i * count]);
    above_[i * count + p] = 1;
  }
  for (const auto& [link, sign] : {std::pair(moved, 1.0), std::pair(reference, -1.0)}) {
    if (link != 0) base_direct_ += sign;
    for (int j = parent_of(link); j >= 0; j = parent_of(robot_->joints[static_cast<std::size_t>(j)].parent_link))
      direct_[static_cast<std::size_t>(j)] += sign;
  }
}

void PostureTangent::sum_masses() {
  for (std::size_t l = 0; l < robot_->links.size(); ++l) {
    const Link& link = robot_->links[l];
    Vector3 moment = link.mass * link.center_of_mass;
    double mass = link.mass;
    if (static_cast<int>(l) == change_->payload_link) {
      moment += change_->payload_mass * link.center_of_mass + change_->payload_moment;
      mass += change_->payload_mass;
    }
    const Rigid& root_from_link = posture_->root_from_link[l];
    moment = root_from_link.rotation * moment + mass * root_from_link.translation;
    whole_moment_ += moment;
    if (l != 0) turned_moment_ += moment;
  }
}

/// Of everything behind a joint, by a unit of its value.
Vector6 PostureTangent::axis_motion(std::size_t k) const {
  const Vector3& axis = joints_[k].axis;
  if (!slides(k)) return rotation_about_point(axis, posture_->root_from_joint[k].translation);
  Vector6 motion;
  motion << axis, Vector3::Zero();
  return motion;
}

/// Of everything behind a joint, by its lateral deflection (in the rotated frame).
PostureTangent::Columns3 PostureTangent::lateral_motion(std::size_t k) const {
  Vector3 origin = posture_->root_from_joint[k].translation;
  if (slides(k)) origin += joints_[k].axis * posture_->value[k];
  const Matrix3 turned = posture_->root_from_turned[k] * left_jacobian(posture_->deflection.lateral[k]);
  Columns3 motion;
  motion << cross_matrix(origin) * turned, turned;
  return motion;
}

/// How masses that a motion carries along change the moment of a joint nearer to the root.
Eigen::Matrix<double, 3, 6> PostureTangent::moment_of_masses(double mass, const Vector3& first_moment) const {
  Eigen::Matrix<double, 3, 6> rows;
  rows << -mass * gravity_cross_, gravity_cross_ * cross_matrix(first_moment);
  return rows;
}

void PostureTangent::describe_joints() {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!robot_->joints[i].moves()) continue;
    JointState& s = joints_[i];
    const Rigid& frame = posture_->root_from_joint[i];
    s.axis = frame.rotation * robot_->joints[i].axis;
    s.first_moment = posture_->distal_mass[i] * posture_->distal_center[i];
    s.arm = s.first_moment - posture_->distal_mass[i] * frame.translation;
    s.carried_torque = posture_->torque[i];
    s.shift_by_frame = s.turn_by_frame = frame.rotation;
    const Vector3 turned = find_change(i).frame.tail<3>();
    if (turned.isZero(0)) continue;
    s.shift_by_frame = frame.rotation * rotation_from_vector<double>(turned).transpose();
    s.turn_by_frame = s.shift_by_frame * left_jacobian(turned);
  }
  if (!change_->joints.empty())
    for (std::size_t m = 0; m < joints_.size(); ++m)
      for (const Mimic& mimic : robot_->joints[m].mimics) {
        const double factor = find_change(m).share * (mimic.multiplier + find_change(m).multiplier_error);
        if (factor == 0) continue;
        JointState& s = joints_[static_cast<std::size_t>(mimic.joint)];
        s.mimics_carried.push_back({static_cast<int>(m), factor});
        s.carried_torque += factor * posture_->torque[m];
      }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    JointState& s = joints_[i];
    const JointChange& c = find_change(i);
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
  const std::size_t count = joints_.size();
  by_value_.assign(count, {});
  by_deflection_.assign(count, {});
  std::vector<char> done(count, 0);
  auto add = [&](auto&& self, std::size_t j) -> void {
    if (done[j]) return;
    done[j] = 1;
    for (std::size_t m = 0; m < count; ++m)
      for (const Mimic& mimic : robot_->joints[m].mimics) {
        if (mimic.joint != static_cast<int>(j)) continue;
        self(self, m);  // the reader has refused mimic loops
        const double factor = mimic.multiplier + find_change(m).multiplier_error;
        const double deflected = factor * find_change(m).share;
        by_value_[j].push_back({static_cast<int>(m), factor});
        if (deflected != 0) by_deflection_[j].push_back({static_cast<int>(m), deflected});
        for (const Share& s : by_value_[m]) {
          by_value_[j].push_back({s.joint, factor * s.factor});
          if (deflected != 0) by_deflection_[j].push_back({s.joint, deflected * s.factor});
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
    if (find_change(j).lateral_compliance != 0) add(Block::lateral, j);
  }
  if (!change_->base_compliance.isZero(0)) add(Block::base, 0);
}

void PostureTangent::add_load(std::size_t block, std::size_t joint, const Load::Rows& by_moment,
                              const Load::Rows& by_force) {
  Load load{block, static_cast<int>(joint), by_moment, by_force};
  // Carried as a whole, a joint sees gravity turn the other way.
  load.by_turn = by_moment * cross_matrix(joints_[joint].arm) * gravity_cross_ +
                 posture_->distal_mass[joint] * by_force * gravity_cross_;
  loads_.push_back(load);
}

void PostureTangent::list_loads() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto i = static_cast<std::size_t>(blocks_[b].joint);
    Load::Rows rows = Load::Rows::Zero();
    const auto add_torque = [&](std::size_t j, double factor) {
      rows.row(0) = slope(i) * factor * joints_[j].axis.transpose();
      slides(j) ? add_load(b, j, Load::Rows::Zero(), rows) : add_load(b, j, rows, Load::Rows::Zero());
    };
    if (blocks_[b].kind == Block::angle) {
      add_torque(i, 1);
      for (const Share& s : joints_[i].mimics_carried) add_torque(static_cast<std::size_t>(s.joint), s.factor);
    } else if (blocks_[b].kind == Block::lateral) {
      rows = find_change(i).lateral_compliance * across(robot_->joints[i].axis) *
             posture_->root_from_turned[i].transpose();
      add_load(b, i, rows, Load::Rows::Zero());
    } else {  // the base only turns about the root's origin
      for (int c = 0; c < 3; ++c) rows.col(c) = base_deflection(Vector3::Unit(c));
      loads_.push_back({b, -1, rows, Load::Rows::Zero(), rows * gravity_cross_ * cross_matrix(turned_moment_)});
    }
  }
}

/// Adds how a motion of all from a joint's frame on (-1: of all but the root; `moves_own_frame` false: of all after
/// it) changes every unknown through the loads.
template <int N>
void PostureTangent::add_through(const Eigen::Matrix<double, 6, N>& motion, int joint, bool moves_own_frame,
                                 Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, N>> through) const {
  const auto k = static_cast<std::size_t>(joint);
  const Eigen::Matrix<double, 3, N> turn = motion.template bottomRows<3>();
  Eigen::Matrix<double, 3, N> moment = Eigen::Matrix<double, 3, N>::Zero();
  if (joint >= 0)
    moment = gravity_cross_ *
             (cross_matrix(joints_[k].first_moment) * turn - posture_->distal_mass[k] * motion.template topRows<3>());
  for (const Load& load : loads_) {
    const Block& block = blocks_[load.block];
    const auto add = [&](const Eigen::Matrix<double, 2, N>& rows) {
      through.middleRows(block.first, block.size()) += rows.topRows(block.size());
    };
    const auto i = static_cast<std::size_t>(load.joint);
    if (joint < 0 || (load.joint >= 0 && (carries(k, i) || (i == k && moves_own_frame))))
      add(load.by_turn * turn);
    else if (load.joint < 0 || i == k || carries(i, k))
      add(load.by_moment * moment);
  }
}

/// What a unit of each unknown moves, once the springs have answered to how it changes all loads.
void PostureTangent::solve_springs() {
  by_unknown_ = Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, unknowns_);
  if (unknowns_ == 0) return;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
  for (const Block& block : blocks_) {
    const auto j = static_cast<std::size_t>(block.joint);
    if (block.kind == Block::angle) {
      const auto add = [&](std::size_t k, double factor) {
        const Vector6 motion = factor * axis_motion(k);
        by_unknown_.col(block.first) += direct_[k] * motion;
        add_through<1>(motion, static_cast<int>(k), !slides(k), system.col(block.first));
      };
      add(j, 1);
      for (const Share& s : by_deflection_[j]) add(static_cast<std::size_t>(s.joint), s.factor);
    } else if (block.kind == Block::lateral) {
      const Eigen::Matrix<double, 6, 2> motion = lateral_motion(j) * across(robot_->joints[j].axis).transpose();
      by_unknown_.middleCols<2>(block.first) = direct_[j] * motion;
      add_through<2>(motion, block.joint, false, system.middleCols<2>(block.first));
    } else {
      Eigen::Matrix<double, 6, 2> motion = Eigen::Matrix<double, 6, 2>::Zero();
      motion.bottomRows<3>() = left_jacobian(posture_->deflection.base).leftCols<2>();
      by_unknown_.middleCols<2>(block.first) = base_direct_ * motion;
      add_through<2>(motion, -1, true, system.middleCols<2>(block.first));
    }
  }
  system = Eigen::MatrixXd::Identity(unknowns_, unknowns_) - system;
  by_unknown_ =
      Eigen::PartialPivLU<Eigen::MatrixXd>(system.transpose()).solve(by_unknown_.transpose()).transpose().eval();
}

void PostureTangent::answer_to_motions() {
  const std::size_t count = joints_.size();
  response_.assign(count, Matrix6::Zero());
  after_response_.assign(count, Matrix6::Zero());
  by_axis_.assign(count, Vector6::Zero());
  by_corrected_.assign(count, Vector6::Zero());
  answers_.resize(loads_.size());
  base_response_ = base_direct_ * Matrix6::Identity();
  for (std::size_t l = 0; l < loads_.size(); ++l) {
    const Load& load = loads_[l];
    const Block& block = blocks_[load.block];
    Eigen::Matrix<double, 6, 2> y = Eigen::Matrix<double, 6, 2>::Zero();
    y.leftCols(block.size()) = by_unknown_.middleCols(block.first, block.size());
    answers_[l] = {y * load.by_moment, y * load.by_force, y * load.by_turn};
    base_response_.rightCols<3>() += answers_[l].by_turn;
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (!robot_->joints[k].moves()) continue;
    Columns3 by_moment = Columns3::Zero(), by_turn = Columns3::Zero();
    Columns3 own_moment = Columns3::Zero(), own_turn = Columns3::Zero();
    for (std::size_t l = 0; l < loads_.size(); ++l) {
      const auto i = static_cast<std::size_t>(loads_[l].joint);
      if (loads_[l].joint < 0 || (i != k && carries(i, k)))
        by_moment += answers_[l].by_moment;
      else if (i == k)
        own_moment += answers_[l].by_moment, own_turn += answers_[l].by_turn;
      else if (carries(k, i))
        by_turn += answers_[l].by_turn;
    }
    const Eigen::Matrix<double, 3, 6> moment = moment_of_masses(posture_->distal_mass[k], joints_[k].first_moment);
    Matrix6 response = by_moment * moment;
    response.rightCols<3>() += by_turn;
    response.diagonal().array() += direct_[k];
    response_[k] = after_response_[k] = response;
    response_[k].rightCols<3>() += own_turn;
    after_response_[k] += own_moment * moment;
    by_axis_[k] = (slides(k) ? after_response_[k] : response_[k]) * axis_motion(k);
  }
  for (std::size_t k = 0; k < count; ++k) {
    by_corrected_[k] = by_axis_[k];
    for (const Share& s : by_value_[k]) by_corrected_[k] += s.factor * by_axis_[static_cast<std::size_t>(s.joint)];
  }
}

}  // namespace handsight
