// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/held_fit.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "chain/sighting.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/least_squares.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {

HeldFit::HeldFit(const Problem& problem, const Unknowns& start) : unknowns_(start) {
  check(problem.shape.has_value(), "a body that is held without a known shape");
  problem_.rig = problem.rig;
  problem_.shape = problem.shape;
  problem_.marker_count = problem.marker_count;
  problem_.mount_is_estimated = problem.mount_is_estimated;
  columns_ = 6 * problem.shape->piece_count() + (problem.mount_is_estimated ? 6 : 0);
}

HeldFit::Sums HeldFit::sums_at(const Unknowns& u) const {
  Sums sums;
  sums.information = sums.middle = Eigen::MatrixXd::Zero(columns_, columns_);
  sums.gradient = Eigen::VectorXd::Zero(columns_);
  const Eigen::Index mount = columns_ - 6;
  Eigen::Matrix<double, 3, Eigen::Dynamic> by(3, columns_);
  for (const ProblemObservation& o : observations_) {
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
    Eigen::VectorXd own = Eigen::VectorXd::Zero(columns_);
    for (const Sighting& s : o.sightings) {
      const auto m = static_cast<std::size_t>(s.marker);
      const Vector3& in_tcp = u.markers_in_tcp[m];
      const Vector3 x = sensor_from_tcp * in_tcp;
      const SightingNormal n = sighting_normal(problem_.rig_or_null(), s, x);
      by.setZero();
      const Eigen::Index piece = 6 * problem_.shape->piece(m);
      by.middleCols<3>(piece) = sensor_from_tcp.rotation;
      by.middleCols<3>(piece + 3) = -sensor_from_tcp.rotation * cross_matrix(in_tcp);
      if (problem_.mount_is_estimated) {
        by.middleCols<3>(mount) = -Matrix3::Identity();
        by.middleCols<3>(mount + 3) = cross_matrix(x);
      }
      sums.information.noalias() += by.transpose() * (n.information * by);
      own.noalias() += by.transpose() * n.gradient;
      sums.cost += n.cost;
      sums.rows += n.rows;
      sums.in_front = sums.in_front && n.in_front;
    }
    sums.gradient += own;
    sums.middle.noalias() += own * own.transpose();
  }
  return sums;
}

Unknowns HeldFit::moved(const Unknowns& from, const Eigen::VectorXd& v) const {
  Unknowns next = from;
  for (std::size_t m = 0; m < next.markers_in_tcp.size(); ++m)
    next.markers_in_tcp[m] =
        small_motion<double>(Vector6(v.segment<6>(6 * problem_.shape->piece(m)))) * next.markers_in_tcp[m];
  if (problem_.mount_is_estimated)
    next.mount_from_sensor = from.mount_from_sensor * small_motion<double>(Vector6(v.tail<6>()));
  return next;
}

/// Few observations leave directions open, along which an undamped step would run away.
void HeldFit::descend(int most_steps) {
  double damping = 1e-9;
  for (int i = 0; i < most_steps; ++i) {
    Eigen::MatrixXd damped = sums_.information;
    damped.diagonal() *= 1 + damping;
    const Eigen::VectorXd step = pseudo_inverse(damped) * sums_.gradient;
    if (!step.allFinite()) return;
    const Unknowns next = moved(unknowns_, step);
    Sums sums = sums_at(next);
    if (std::isfinite(sums.cost) && sums.cost <= sums_.cost) {
      unknowns_ = next;
      sums_ = std::move(sums);
      damping = std::max(0.1 * damping, 1e-12);
    } else {
      damping = std::max(100 * damping, 1e-4);
    }
    if (step.cwiseAbs().maxCoeff() < 1e-10) return;
  }
}

void HeldFit::add(const ProblemObservation& observation) {
  observations_.push_back(observation);
  sums_ = sums_at(unknowns_);
  descend(observations_.size() < 20 ? 20 : 6);
}

void HeldFit::try_from(const Unknowns& other) {
  const HeldFit before = *this;
  unknowns_ = other;
  sums_ = sums_at(unknowns_);
  descend(40);
  const bool is_better = sums_.in_front && (!before.sums_.in_front || sums_.cost < before.sums_.cost);
  if (!is_better) *this = before;
}

Eigen::MatrixXd HeldFit::markers_by_unknowns() const {
  Eigen::MatrixXd by = Eigen::MatrixXd::Zero(3 * problem_.marker_count, columns());
  for (int m = 0; m < problem_.marker_count; ++m) {
    const auto i = static_cast<std::size_t>(m);
    const Eigen::Index piece = 6 * problem_.shape->piece(i);
    by.block<3, 3>(3 * m, piece) = Matrix3::Identity();
    by.block<3, 3>(3 * m, piece + 3) = -cross_matrix(unknowns_.markers_in_tcp[i]);
  }
  return by;
}

Eigen::MatrixXd HeldFit::unit_covariance() const { return pseudo_inverse(sums_.information); }

Eigen::MatrixXd HeldFit::repeatability_covariance() const {
  const Eigen::MatrixXd bread = pseudo_inverse(sums_.information);
  const auto n = static_cast<double>(observations_.size());
  return n / std::max(n - 1, 1.0) * bread * sums_.middle * bread;
}

}  // namespace handsight
