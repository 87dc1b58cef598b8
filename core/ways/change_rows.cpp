// SPDX-License-Identifier: Apache-2.0
#include "ways/change_rows.h"

#include <Eigen/Dense>
#include <boost/math/distributions/chi_squared.hpp>

namespace handsight {
namespace {

/// The noise-like part of M = (S^-1 + B^T B)^-1, of a singular S too.
Matrix6 posterior(const Matrix6& scatter, const Matrix6& body_squares) {
  const Matrix6 m = (Matrix6::Identity() + scatter * body_squares).partialPivLu().solve(scatter);
  return 0.5 * (m + m.transpose());
}

void add_sighting(const Problem& p, const ProblemObservation& o, const Unknowns& u, const Sighting& s,
                  const Rigid& sensor_from_tcp, const Eigen::Matrix<double, 6, Eigen::Dynamic>& motion,
                  Eigen::Index base_effects, Eigen::Index first_change, Eigen::MatrixXd& rows, Eigen::MatrixXd& by_body,
                  Eigen::VectorXd& error, Eigen::Index& row) {
  const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
  const SightingResidual r = sighting_residual(p.rig_or_null(), s, x);
  SightingRows<6> body(r.rows, 6);
  body << r.by_point, -r.by_point * cross_matrix(x);
  by_body.middleRows(row, r.rows) = body;
  error.segment(row, r.rows) = r.error;
  rows.block(row, 3 * s.marker, r.rows, 3) = r.by_point * sensor_from_tcp.rotation;
  const Eigen::Index mount = p.effect_column() - p.mount_column(), changes = p.effect_count() - base_effects;
  if (mount > 0) rows.block(row, p.mount_column(), r.rows, 6) = body * motion.leftCols(6);
  if (p.effect_count() > 0) {
    const Eigen::MatrixXd by_effects =
        body * motion.rightCols(p.effect_count()) + direct_by_effects(p, o, s, r, x, sensor_from_tcp.rotation);
    rows.block(row, p.effect_column(), r.rows, base_effects) = by_effects.leftCols(base_effects);
    rows.block(row, first_change, r.rows, changes) = by_effects.rightCols(changes);
  }
  row += r.rows;
}

}  // namespace

void ChangeRows::add(const ChangeRows& other) {
  observations.insert(observations.end(), other.observations.begin(), other.observations.end());
  information += other.information;
  gradient += other.gradient;
  squares += other.squares;
  rows += other.rows;
}

ChangeRows change_rows(const Problem& p, const Unknowns& u, Eigen::Index base_effects, Eigen::Index first_change,
                       Eigen::Index columns, double weight) {
  ChangeRows all;
  all.information = Eigen::MatrixXd::Zero(columns, columns);
  all.gradient = Eigen::VectorXd::Zero(columns);
  Eigen::VectorXd sizes = Eigen::VectorXd::Ones(columns);
  for (Eigen::Index c = 0; c < p.effect_count(); ++c)
    sizes[c < base_effects ? p.effect_column() + c : first_change + c - base_effects] =
        p.columns_of_effects[static_cast<std::size_t>(c)].sigma;
  for (const ProblemObservation& o : p.observations) {
    Eigen::Index count = 0;
    for (const Sighting& s : o.sightings) count += row_count(s);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, columns), by_body(count, 6);
    Eigen::VectorXd error(count);
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u.mount_from_sensor);
    const Eigen::Matrix<double, 6, Eigen::Dynamic> motion = motion_by_columns(p, o, u);
    Eigen::Index row = 0;
    for (const Sighting& s : o.sightings)
      add_sighting(p, o, u, s, sensor_from_tcp, motion, base_effects, first_change, rows, by_body, error, row);
    rows = weight * (rows * sizes.asDiagonal());
    by_body *= weight;
    error *= weight;
    ChangeObservation& part = all.observations.emplace_back();
    part.body_by_columns = by_body.transpose() * rows;
    part.body_by_error = by_body.transpose() * error;
    part.body_squares = by_body.transpose() * by_body;
    all.information += rows.transpose() * rows;
    all.gradient += rows.transpose() * error;
    all.squares += error.squaredNorm();
    all.rows += static_cast<int>(count);
  }
  return all;
}

ChangeRows with_rigid_markers(const ChangeRows& rows, const std::vector<Vector3>& markers) {
  const Eigen::Index points = 3 * static_cast<Eigen::Index>(markers.size()), columns = rows.gradient.size();
  Eigen::MatrixXd by_new = Eigen::MatrixXd::Zero(columns, columns - points + 6);
  for (std::size_t m = 0; m < markers.size(); ++m)
    by_new.block<3, 6>(3 * static_cast<Eigen::Index>(m), 0) << Matrix3::Identity(), -cross_matrix(markers[m]);
  by_new.bottomRightCorner(columns - points, columns - points).setIdentity();
  ChangeRows rigid = rows;
  rigid.information = by_new.transpose() * rows.information * by_new;
  rigid.gradient = by_new.transpose() * rows.gradient;
  for (ChangeObservation& o : rigid.observations) o.body_by_columns = (o.body_by_columns * by_new).eval();
  return rigid;
}

ScatteredNormal scattered(const ChangeRows& rows, const Matrix6& scatter) {
  ScatteredNormal n{rows.information, rows.gradient, rows.squares};
  if (scatter.isZero(0)) return n;
  for (const ChangeObservation& o : rows.observations) {
    const Matrix6 m = posterior(scatter, o.body_squares);
    n.information -= o.body_by_columns.transpose() * m * o.body_by_columns;
    n.gradient -= o.body_by_columns.transpose() * (m * o.body_by_error);
    n.squares -= o.body_by_error.dot(m * o.body_by_error);
  }
  return n;
}

Matrix6 scatter_left(const ChangeRows& rows, const Eigen::VectorXd& step, int parameters) {
  std::vector<Vector6> errors;
  Matrix6 start = Matrix6::Zero();
  for (const ChangeObservation& o : rows.observations) {
    errors.push_back(o.body_by_error - o.body_by_columns * step);
    const Vector6 motion = o.body_squares.completeOrthogonalDecomposition().solve(errors.back());
    start.diagonal() += motion.cwiseAbs2() / static_cast<double>(rows.observations.size());
  }
  const double left = rows.squares - 2 * rows.gradient.dot(step) + step.dot(rows.information * step);
  const double degrees = std::max(1, rows.rows - parameters);
  if (!(left > 0) || boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), left)) > 1e-3)
    return Matrix6::Zero();
  Matrix6 scatter = start;
  for (int round = 0; round < 60; ++round) {
    Matrix6 next = Matrix6::Zero();
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const Matrix6 m = posterior(scatter, rows.observations[i].body_squares);
      const Vector6 motion = m * errors[i];
      next += motion * motion.transpose() + m;
    }
    scatter = next / static_cast<double>(errors.size());
  }
  return 0.5 * (scatter + scatter.transpose());
}

}  // namespace handsight
