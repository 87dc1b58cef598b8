// SPDX-License-Identifier: Apache-2.0
#include "robot/posture_memory.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace handsight {
namespace {

const JointChange no_change_of_joint{};

const JointChange& change_of(const RobotChange& change, std::size_t joint) {
  return change.joints.empty() ? no_change_of_joint : change.joints[joint];
}

void flatten(const Deflection& d, Eigen::VectorXd& flat) {
  const auto joints = static_cast<Eigen::Index>(d.angle.size());
  flat.resize(4 * joints + 3);
  flat.head(joints) = Eigen::Map<const Eigen::VectorXd>(d.angle.data(), joints);
  for (Eigen::Index j = 0; j < joints; ++j) flat.segment<3>(joints + 3 * j) = d.lateral[static_cast<std::size_t>(j)];
  flat.tail<3>() = d.base;
}

void unflatten(const Eigen::VectorXd& flat, Deflection& d) {
  const auto joints = static_cast<Eigen::Index>(d.angle.size());
  Eigen::Map<Eigen::VectorXd>(d.angle.data(), joints) = flat.head(joints);
  for (Eigen::Index j = 0; j < joints; ++j) d.lateral[static_cast<std::size_t>(j)] = flat.segment<3>(joints + 3 * j);
  d.base = flat.tail<3>();
}

}  // namespace

void EquilibriumMixing::lead_on(const Deflection& now, Deflection& next) {
  constexpr double leads_away = 0.99;     // of the pass before, and the same way
  constexpr double next_to_none = 1e-12;  // of the squares: where passes say the same again
  constexpr double farthest = 0.5;        // rad, m: beyond, passes that say nearly the same are believed too much
  flatten(next, new_to_);
  flatten(now, new_by_);
  new_by_ = new_to_ - new_by_;
  if (count_ > 0 && new_by_.dot(by_) > leads_away * by_.squaredNorm()) count_ = 0;
  if (count_ > 0) {
    const int last = (count_ - 1) % most, mixed = std::min(count_, most);
    by_to_.resize(new_to_.size(), most);
    by_by_.resize(new_by_.size(), most);
    by_to_.col(last) = new_to_ - to_;
    by_by_.col(last) = new_by_ - by_;
    SmallMatrix squares = by_by_.leftCols(mixed).transpose() * by_by_.leftCols(mixed);
    squares.diagonal() *= 1 + next_to_none;
    const SmallVector shares = squares.ldlt().solve(by_by_.leftCols(mixed).transpose() * new_by_);
    const Eigen::VectorXd farther = by_to_.leftCols(mixed) * shares;
    if (farther.lpNorm<Eigen::Infinity>() < farthest) unflatten(new_to_ - farther, next);
  }
  std::swap(to_, new_to_);
  std::swap(by_, new_by_);
  ++count_;
}

void PostureMemory::place_joints(const Robot& robot, const RobotChange& change) {
  if (robot_ != &robot) {
    robot_ = &robot;
    passes_.emplace(robot, change);
    frame_.resize(robot.joints.size());
    after_.resize(robot.joints.size());
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      frame_[j] = change_of(change, j).frame;
      after_[j] = change_of(change, j).after;
    }
    return;
  }
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const JointChange& c = change_of(change, j);
    if (c.frame != frame_[j])
      passes_->parent_from_joint[j] = robot.joints[j].parent_from_joint * small_motion<double>(frame_[j] = c.frame);
    if (c.after != after_[j])
      passes_->bent_from_child[j] = small_motion<double>(after_[j] = c.after) * robot.joints[j].joint_from_child;
  }
}

void PostureMemory::clear(const Robot& robot) {
  const std::size_t joints = robot.joints.size();
  posture_.root_from_link.resize(robot.links.size());
  posture_.root_from_joint.resize(joints);
  posture_.root_from_turned.resize(joints);
  posture_.value.assign(joints, 0.0);
  posture_.torque.assign(joints, 0.0);
  posture_.moment.assign(joints, Vector3::Zero());
  posture_.distal_mass.assign(joints, 0.0);
  posture_.distal_center.assign(joints, Vector3::Zero());
  posture_.deflection.angle.assign(joints, 0.0);
  posture_.deflection.lateral.assign(joints, Vector3::Zero());
  posture_.deflection.base.setZero();
  posture_.converged = true;
}

const Posture& PostureMemory::solve(const Robot& robot, const Eigen::VectorXd& sensor, const RobotChange& change,
                                    const Vector3& gravity, bool with_loads, const Deflection* start) {
  namespace detail = posture_detail;
  const std::size_t joints = robot.joints.size();
  check(static_cast<std::size_t>(sensor.size()) == joints, "{} joint values for a robot of {} joints", sensor.size(),
        joints);
  clear(robot);
  place_joints(robot, change);
  mixing_.begin();
  const bool elastic = detail::is_elastic(robot, change);
  const Vector3 gravity_in_root = detail::tilted_gravity(gravity, change);
  Deflection& deflection = posture_.deflection;
  if (elastic && start && start->angle.size() == joints) deflection = *start;
  constexpr int most_passes = 500, most_in_vain = 40;
  double shortest = 10;  // rad, m
  int in_vain = 0;       // passes since it was halved
  for (posture_.iterations = 0; posture_.iterations <= most_passes; ++posture_.iterations) {
    detail::set_values(robot, sensor, change, deflection, *passes_, posture_);
    detail::set_frames(robot, deflection, elastic, *passes_, posture_);
    if (!elastic && !with_loads) return posture_;
    const Vector3 root_moment = detail::set_loads(robot, gravity_in_root, change, *passes_, posture_);
    if (!elastic) return posture_;
    detail::set_deflections(robot, change, posture_, root_moment, *passes_);
    const double step = detail::largest_change(passes_->next, deflection);
    if (step < 1e-11) return posture_;
    in_vain = step < 0.5 * shortest ? 0 : in_vain + 1;
    if (in_vain == 0) shortest = step;
    if (!(step < 10) || in_vain > most_in_vain) break;  // unstable: springs too soft for the load
    mixing_.lead_on(deflection, passes_->next);
    std::swap(deflection, passes_->next);
  }
  posture_.converged = false;
  return posture_;
}

Posture solve_equilibrium(const Robot& robot, const Eigen::VectorXd& sensor, const RobotChange& change,
                          const Vector3& gravity, bool with_loads) {
  return PostureMemory().solve(robot, sensor, change, gravity, with_loads);
}

}  // namespace handsight
