// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/flange_error.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace handsight {

Rigid tcp_from_flange(const Problem& problem, const ProblemObservation& o) {
  const Chain& chain = problem.source->chain;
  const bool carries_sensor = chain.mount_link > chain.tcp_link;  // of a robot of poses the flange is the last link
  return carries_sensor ? inverse(o.root_from_tcp) * o.root_from_mount : Rigid{};
}

Eigen::Matrix<double, Eigen::Dynamic, 6> markers_by_flange(const Problem& problem, const ProblemObservation& o,
                                                           const Unknowns& unknowns) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> motions(3 * problem.marker_count, 6);
  for (int m = 0; m < problem.marker_count; ++m) {
    motions.block<3, 3>(3 * m, 0) = Matrix3::Identity();
    motions.block<3, 3>(3 * m, 3) = -cross_matrix(marker_at(o, unknowns, m));
  }
  return motions * adjoint(tcp_from_flange(problem, o));
}

Vector6 flange_error_weights(const FlangeError& error, double noise) {
  constexpr double least_place = 1e-9, least_turn = 1e-9;  // m, rad: as good as none
  Vector6 weights;
  weights.head<3>().setConstant(std::pow(noise / std::max(error.place, least_place), 2));
  weights.tail<3>().setConstant(std::pow(noise / std::max(error.turn, least_turn), 2));
  return weights;
}

FlangeSums flange_sums(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns,
                       const NormalEquations& one) {
  const auto markers = markers_by_flange(problem, o, unknowns);
  FlangeSums sums;
  sums.shared = one.information.leftCols(markers.rows()) * markers;
  sums.own = markers.transpose() * sums.shared.topRows(markers.rows());
  sums.gradient = markers.transpose() * one.gradient.head(markers.rows());
  return sums;
}

void add_without_flange_error(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns,
                              const NormalEquations& one, NormalEquations& normal) {
  FlangeSums sums = flange_sums(problem, o, unknowns, one);
  sums.own.diagonal() += flange_error_weights(problem.flange_error, problem.noise);
  const Eigen::LLT<Matrix6> llt(sums.own);
  const Vector6 best = llt.solve(sums.gradient);
  normal.information += one.information - sums.shared * llt.solve(sums.shared.transpose());
  normal.gradient += one.gradient - sums.shared * best;
  normal.cost += one.cost - sums.gradient.dot(best);
  normal.rows += one.rows;
  normal.in_front = normal.in_front && one.in_front;
}

}  // namespace handsight
