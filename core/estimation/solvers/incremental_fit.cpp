// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/incremental_fit.h"

#include <algorithm>
#include <cmath>

#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {
namespace {

/// Right Jacobian of the rotation group: exp(w + d) = exp(w) exp(J d).
Matrix3 right_jacobian(const Vector3& w) {
  const double a2 = w.squaredNorm();
  const Matrix3 k = cross_matrix(w);
  if (a2 < 1e-8) return Matrix3::Identity() - 0.5 * k + k * k / 6;
  const double a = std::sqrt(a2);
  return Matrix3::Identity() - (1 - std::cos(a)) / a2 * k + (a - std::sin(a)) / (a2 * a) * k * k;
}

}  // namespace

IncrementalFit::IncrementalFit(const Problem& problem, const Unknowns& start, int relinearised_per_step)
    : mount_reference_(start.mount_from_sensor),
      current_(std::make_shared<Unknowns>(start)),
      per_step_(static_cast<std::size_t>(relinearised_per_step)) {
  problem_.rig = problem.rig;
  problem_.marker_count = problem.marker_count;
  problem_.mount_is_estimated = problem.mount_is_estimated;
  const Eigen::Index columns = problem_.columns();
  information_ = middle_ = Eigen::MatrixXd::Zero(columns, columns);
  right_ = Eigen::VectorXd::Zero(columns);
}

/// Markers as they are, the mount as the small motion from its reference: coordinates that add, so that equations
/// linearised at different places have one sum.
Eigen::VectorXd IncrementalFit::coordinates(const Unknowns& u) const {
  Eigen::VectorXd x(problem_.columns());
  for (int m = 0; m < problem_.marker_count; ++m) x.segment<3>(3 * m) = u.markers_in_tcp[static_cast<std::size_t>(m)];
  if (problem_.mount_is_estimated) {
    const Rigid motion = inverse(mount_reference_) * u.mount_from_sensor;
    x.tail<6>() << motion.translation, vector_from_rotation(motion.rotation);
  }
  return x;
}

Unknowns IncrementalFit::from_coordinates(const Eigen::VectorXd& x) const {
  Unknowns u = *current_;
  for (int m = 0; m < problem_.marker_count; ++m) u.markers_in_tcp[static_cast<std::size_t>(m)] = x.segment<3>(3 * m);
  if (problem_.mount_is_estimated) u.mount_from_sensor = mount_reference_ * small_motion<double>(x.tail<6>());
  return u;
}

void IncrementalFit::accumulate(const Entry& entry, double sign) {
  NormalEquations normal(problem_.columns());
  add_observation(problem_, entry.observation, *entry.at, normal);
  complete(normal);
  const Eigen::VectorXd x = coordinates(*entry.at);
  if (problem_.mount_is_estimated) {
    // exp(x + d) = exp(x) exp(u): u = (R^T d_t, J_r d_r); the columns were by u.
    Matrix6 u_by_x = Matrix6::Zero();
    u_by_x.topLeftCorner<3, 3>() = rotation_from_vector<double>(x.tail<3>()).transpose();
    u_by_x.bottomRightCorner<3, 3>() = right_jacobian(x.tail<3>());
    const Eigen::Index markers = 3 * problem_.marker_count;
    normal.information.rightCols<6>() = (normal.information.rightCols<6>() * u_by_x).eval();
    normal.information.bottomRows<6>() = (u_by_x.transpose() * normal.information.bottomRows<6>()).eval();
    normal.gradient.segment<6>(markers) = (u_by_x.transpose() * normal.gradient.segment<6>(markers)).eval();
  }
  information_ += sign * normal.information;
  right_ += sign * (normal.gradient + normal.information * x);
  middle_ += sign * normal.gradient * normal.gradient.transpose();
  cost_ += sign * normal.cost;
  rows_ += sign > 0 ? normal.rows : -normal.rows;
}

void IncrementalFit::relinearise(Entry& entry) {
  if (entry.at == current_) return;
  accumulate(entry, -1);
  entry.at = current_;
  accumulate(entry, +1);
}

void IncrementalFit::relinearise_oldest(std::size_t count) {
  for (std::size_t i = 0; i < std::min(count, entries_.size()); ++i) {
    relinearise(entries_[next_]);
    next_ = (next_ + 1) % entries_.size();
  }
}

void IncrementalFit::solve_step() {
  const Eigen::VectorXd x = coordinates(*current_);
  const Eigen::VectorXd step = pseudo_inverse(information_) * (right_ - information_ * x);
  current_ = std::make_shared<Unknowns>(from_coordinates(x + step));
}

IncrementalFit::Entry& IncrementalFit::place_for(Entry entry) {
  if (entries_.size() < most_kept) return entries_.emplace_back(std::move(entry));
  Entry& place = entries_[next_];
  next_ = (next_ + 1) % entries_.size();
  return place = std::move(entry);
}

void IncrementalFit::add(const ProblemObservation& observation) {
  ++count_;
  Entry& entry = place_for({observation, current_});
  accumulate(entry, +1);
  solve_step();
  relinearise(entry);  // it may show a marker for the first time, far from its start
  solve_step();
  // A few observations are brought to the minimum at once; with more, one turn a step keeps the work bounded.
  const bool all_fit = entries_.size() <= per_step_;
  for (int pass = 0; pass < (all_fit ? 3 : 1); ++pass) {
    relinearise_oldest(all_fit ? entries_.size() : per_step_);
    solve_step();
  }
}

void IncrementalFit::place_marker(int marker, const Vector3& in_tcp) {
  Unknowns moved = *current_;
  moved.markers_in_tcp[static_cast<std::size_t>(marker)] = in_tcp;
  current_ = std::make_shared<Unknowns>(moved);
}

Eigen::MatrixXd IncrementalFit::unit_covariance() const { return pseudo_inverse(information_); }

Eigen::MatrixXd IncrementalFit::repeatability_covariance() const {
  const Eigen::MatrixXd bread = pseudo_inverse(information_);
  const auto n = static_cast<double>(count_);
  return n / std::max(n - 1, 1.0) * bread * middle_ * bread;
}

int IncrementalFit::unobservable() const {
  int left_out = 0;
  pseudo_inverse(information_, &left_out);
  return left_out;
}

}  // namespace handsight
