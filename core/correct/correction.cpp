// SPDX-License-Identifier: Apache-2.0
#include "correct/correction.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/median.h"
#include "robot/posture_memory.h"
#include "robot/posture_tangent.h"

namespace handsight {
namespace {

using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic>;

constexpr double length_of_radian = 0.3;  // m: what a turn counts as beside a shift, where not all can be had
constexpr double widest_step = 0.3;       // rad (m)
constexpr double reached_m = 1e-6, reached_rad = 1e-6;
constexpr int most_iterations = 200;
constexpr double least_damping = 1e-10, most_damping = 1e6;  // of the derivatives' squares

ObservationState at(const ObservationState& commanded, const Eigen::VectorXd& position) {
  ObservationState c = commanded;
  c.sensor = joint_values(c.chain->robot, c.chain->joints, position);
  c.torque.resize(0);
  c.tcp.reset();
  return c;
}

Eigen::VectorXd make_position(const ObservationState& c) {
  Eigen::VectorXd position(static_cast<Eigen::Index>(c.chain->joints.size()));
  for (std::size_t i = 0; i < c.chain->joints.size(); ++i)
    position[static_cast<Eigen::Index>(i)] = c.sensor[c.chain->joints[i]];
  return position;
}

/// The hand, and how it moves with each joint of the position: m, then rad, root axes.
struct MovedHand {
  Rigid root_from_hand;
  Columns by_joint;
};

MovedHand moved_hand(const ObservationState& c, const std::vector<EffectTerm>& effects) {
  const Chain& chain = *c.chain;
  const Sites sites = moved_sites(c, effects);
  const Posture posture = solve_equilibrium(chain.robot, c.sensor, sites.robot, chain.gravity, true);
  const PostureTangent tangent(chain.robot, sites.robot, chain.gravity, posture, chain.tcp_link, 0);
  MovedHand hand;
  hand.root_from_hand =
      posture.root_from_link[static_cast<std::size_t>(chain.tcp_link)] * small_motion<double>(sites.hand);
  hand.by_joint.resize(6, static_cast<Eigen::Index>(chain.joints.size()));
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Vector6& motion = tangent.motion_by_value(chain.joints[i]);
    const Vector3 turn = motion.tail<3>();
    hand.by_joint.col(static_cast<Eigen::Index>(i)) << motion.head<3>() + turn.cross(hand.root_from_hand.translation),
        turn;
  }
  return hand;
}

/// What is left to the target: m, then rad, root axes.
Vector6 way_to(const Rigid& target, const Rigid& hand) {
  Vector6 way;
  way << target.translation - hand.translation, vector_from_rotation(target.rotation * hand.rotation.transpose());
  return way;
}

/// The shortest step of the joints that closes `way`, damped by a share of the derivatives; a joint that would leave
/// its limits stops at them, and the others do the rest.
Eigen::VectorXd limited_step(const Chain& chain, Columns by_joint, Vector6 way, const Eigen::VectorXd& position,
                             double damping) {
  by_joint.bottomRows<3>() *= length_of_radian;
  way.tail<3>() *= length_of_radian;
  const Eigen::Index count = position.size();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(count);
  std::vector<char> is_free(static_cast<std::size_t>(count), 1);
  Columns columns = by_joint;
  for (bool has_new = true; has_new;) {
    const Matrix6 squared = columns * columns.transpose();
    const Matrix6 damped = squared + (damping * squared.trace() + 1e-30) * Matrix6::Identity();
    const Eigen::VectorXd free_step = columns.transpose() * damped.ldlt().solve(way);
    has_new = false;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (!is_free[static_cast<std::size_t>(i)]) continue;
      const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(i)])];
      step[i] = free_step[i];
      const double there = position[i] + step[i];
      if (there >= joint.lower && there <= joint.upper) continue;
      step[i] = (there < joint.lower ? joint.lower : joint.upper) - position[i];
      way -= by_joint.col(i) * step[i];
      is_free[static_cast<std::size_t>(i)] = 0;
      columns.col(i).setZero();
      has_new = true;
    }
  }
  return step;
}

double measure_length(const Vector6& way) {
  return std::hypot(way.head<3>().norm(), length_of_radian * way.tail<3>().norm());
}

/// The eigenvectors of a covariance, each as long as its sigma.
Matrix3 square_root(const Matrix3& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(covariance);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

Rigid nominal_hand(const ObservationState& c) { return observed_ends(c, {}).ends.root_from_tcp; }

}  // namespace

Correction corrected(const ObservationState& commanded, const PredictionModel& model,
                     const std::optional<Rigid>& target) {
  const Rigid wanted = target ? *target : nominal_hand(commanded);
  Correction result;
  result.position = make_position(commanded);
  MovedHand hand = moved_hand(at(commanded, result.position), model.effects);
  Vector6 way = way_to(wanted, hand.root_from_hand);
  result.error_before_m = way.head<3>().norm();
  result.error_before_rad = way.tail<3>().norm();
  double damping = least_damping;
  for (; result.iterations < most_iterations && damping < most_damping; ++result.iterations) {
    Eigen::VectorXd step = limited_step(*commanded.chain, hand.by_joint, way, result.position, damping);
    const double size = step.size() ? step.cwiseAbs().maxCoeff() : 0;
    if (!(size > 1e-12)) break;
    step *= std::min(1.0, widest_step / size);
    const MovedHand moved = moved_hand(at(commanded, result.position + step), model.effects);
    const Vector6 left = way_to(wanted, moved.root_from_hand);
    if (measure_length(left) > measure_length(way)) {  // too far, as near a stretched arm: shorter
      damping *= 100;
      continue;
    }
    damping = std::max(least_damping, damping / 100);
    result.position += step;
    hand = moved;
    way = left;
  }
  const TcpPrediction there = predict_tcp(at(commanded, result.position), model);
  way = way_to(wanted, there.root_from_tcp_est);
  result.error_after_m = way.head<3>().norm();
  result.error_after_rad = way.tail<3>().norm();
  result.reached = result.error_after_m <= reached_m && result.error_after_rad <= reached_rad;
  result.sigma_m = std::sqrt(std::max(0.0, there.covariance.topLeftCorner<3, 3>().trace()));
  for (std::size_t i = 0; i < commanded.chain->joints.size(); ++i) {
    const Joint& joint = commanded.chain->robot.joints[static_cast<std::size_t>(commanded.chain->joints[i])];
    const double q = result.position[static_cast<Eigen::Index>(i)];
    if (q <= joint.lower || q >= joint.upper) result.at_limit.push_back(static_cast<int>(i));
  }
  return result;
}

CorrectionGain correction_gain(const Chain& chain, const PredictionModel& model,
                               const std::vector<Eigen::VectorXd>& measured, int count, std::uint64_t seed) {
  CorrectionGain gain;
  if (measured.empty()) return gain;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < count; ++i) {
    const Eigen::VectorXd &a = measured[random() % measured.size()], &b = measured[random() % measured.size()];
    const double share = uniform(random);
    const ObservationState pose = states_at(chain, Eigen::VectorXd(a + share * (b - a)));
    const Correction c = corrected(pose, model);
    const Rigid wanted = nominal_hand(pose);
    const double z = normal(random), y = normal(random), x = normal(random);  // in one order for every compiler
    const Vector3 draw(x, y, z);
    const TcpPrediction as_commanded = predict_tcp(pose, model), there = predict_tcp(at(pose, c.position), model);
    const auto error = [&](const TcpPrediction& p) {
      return (p.root_from_tcp_est.translation - wanted.translation +
              square_root(p.covariance.topLeftCorner<3, 3>()) * draw)
          .norm();
    };
    gain.before.push_back(error(as_commanded));
    gain.after.push_back(error(there));
    gain.not_reached += !c.reached;
  }
  gain.median_before = median(gain.before);
  gain.median_after = median(gain.after);
  return gain;
}

}  // namespace handsight
