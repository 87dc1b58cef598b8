// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/flange_error.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

bool is_carried(const Robot& robot, int link) {
  const std::vector<int> joints = joints_to(robot, link);
  return std::any_of(joints.begin(), joints.end(),
                     [&](int j) { return robot.joints[static_cast<std::size_t>(j)].moves(); });
}

/// Whichever end of the chain the flange carries; of a robot of poses it is the last link.
Rigid tcp_from_flange(const Chain& chain, const ProblemObservation& o) {
  const bool carries_sensor =
      chain.robot.is_of_poses ? chain.mount_link > chain.tcp_link : !is_carried(chain.robot, chain.tcp_link);
  return carries_sensor ? inverse(o.root_from_tcp) * o.root_from_mount : Rigid{};
}

Matrix6 share_of_joints(const Chain& chain, const ProblemObservation& o) {
  constexpr double metres_per_radian = 0.3;  // of prismatic joints
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_joints = adjoint(inverse(o.root_from_tcp)) * o.motion.tcp_by_value;
  for (Eigen::Index j = 0; j < by_joints.cols(); ++j) {
    const int joint = chain.joints[static_cast<std::size_t>(j)];
    if (chain.robot.joints[static_cast<std::size_t>(joint)].kind == JointKind::prismatic)
      by_joints.col(j) *= metres_per_radian;
  }
  return by_joints * by_joints.transpose();
}

}  // namespace

FlangeErrorShares flange_error_shares(const Problem& problem, const ProblemObservation& o) {
  const Chain& chain = *problem.source->states[static_cast<std::size_t>(o.index)].chain;
  const Matrix6 by_flange = adjoint(tcp_from_flange(chain, o));
  const auto by_place = by_flange.leftCols<3>(), by_turn = by_flange.rightCols<3>();
  return {by_place * by_place.transpose(),
          chain.robot.is_of_poses ? Matrix6(by_turn * by_turn.transpose()) : share_of_joints(chain, o)};
}

Matrix6 make_covariance(const FlangeErrorShares& shares, const FlangeError& error) {
  return error.place * error.place * shares.place + error.turn * error.turn * shares.turn;
}

Matrix6 root_of_covariance(const Matrix6& covariance) {
  const Eigen::LDLT<Matrix6> ldlt(covariance);
  Matrix6 root = ldlt.matrixL();
  root = root * ldlt.vectorD().cwiseMax(0).cwiseSqrt().asDiagonal();
  return ldlt.transpositionsP().transpose() * root;
}

Eigen::Matrix<double, Eigen::Dynamic, 6> markers_by_motion(const Problem& problem, const ProblemObservation& o,
                                                           const Unknowns& unknowns) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> motions(3 * problem.marker_count, 6);
  for (int m = 0; m < problem.marker_count; ++m) {
    motions.block<3, 3>(3 * m, 0) = Matrix3::Identity();
    motions.block<3, 3>(3 * m, 3) = -cross_matrix(marker_at(o, unknowns, m));
  }
  return motions;
}

FlangeSums flange_sums(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns,
                       const NormalEquations& one) {
  const auto markers = markers_by_motion(problem, o, unknowns);
  FlangeSums sums;
  sums.shared = one.information.leftCols(markers.rows()) * markers;
  sums.own = markers.transpose() * sums.shared.topRows(markers.rows());
  sums.gradient = markers.transpose() * one.gradient.head(markers.rows());
  return sums;
}

FlangeSums along(const FlangeSums& sums, const Matrix6& g) {
  return {sums.shared * g, g.transpose() * sums.own * g, g.transpose() * sums.gradient};
}

void add_without_flange_error(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns,
                              const NormalEquations& one, NormalEquations& normal) {
  const Matrix6 covariance = make_covariance(flange_error_shares(problem, o), problem.flange_error);
  FlangeSums sums = along(flange_sums(problem, o, unknowns, one), root_of_covariance(covariance) / problem.noise);
  sums.own.diagonal().array() += 1;
  const Eigen::LLT<Matrix6> llt(sums.own);
  const Vector6 best = llt.solve(sums.gradient);
  normal.information += one.information - sums.shared * llt.solve(sums.shared.transpose());
  normal.gradient += one.gradient - sums.shared * best;
  normal.cost += one.cost - sums.gradient.dot(best);
  normal.rows += one.rows;
  normal.in_front = normal.in_front && one.in_front;
}

}  // namespace handsight
