// SPDX-License-Identifier: Apache-2.0
#include "compare/change_rows.h"

#include <Eigen/Dense>

#include "estimation/fit/noise.h"
#include "estimation/problem/column_products.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {
namespace {

/// The noise-like part of M = (S^-1 + B^T B)^-1, of a singular S too.
Matrix6 posterior(const Matrix6& repeatability, const Matrix6& body_squares) {
  const Matrix6 m = (Matrix6::Identity() + repeatability * body_squares).partialPivLu().solve(repeatability);
  return 0.5 * (m + m.transpose());
}

/// Rows of one observation, not weighed yet.
struct ObservationParts : SingleRows {
  Eigen::Index row = 0;
};

/// The body's motions in the sensor's frame by mount and effects, and by the curves.
struct BodyMotions {
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_effects, by_curves;
};

void add_sighting(const Problem& p, const ProblemObservation& o, const Unknowns& u, const Sighting& s,
                  const Rigid& sensor_from_tcp, const BodyMotions& motion, const ChangeColumns& columns,
                  ObservationParts& parts) {
  const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
  const SightingResidual r = sighting_residual(p.rig_or_null(), s, x);
  SightingRows<6> body(r.rows, 6);
  body << r.by_point, -r.by_point * cross_matrix(x);
  parts.by_body.middleRows(parts.row, r.rows) = body;
  parts.error.segment(parts.row, r.rows) = r.error;
  auto rows = parts.by_columns.middleRows(parts.row, r.rows);
  rows.middleCols<3>(3 * s.marker) = r.by_point * sensor_from_tcp.rotation;
  const Eigen::Index mount = p.effect_column() - p.mount_column(), changes = p.effect_count() - columns.effects;
  if (mount > 0) rows.middleCols<6>(p.mount_column()) = body * motion.by_effects.leftCols(6);
  if (p.effect_count() > 0) {
    const Eigen::MatrixXd by_effects = body * motion.by_effects.rightCols(p.effect_count()) +
                                       direct_by_effects(p, o, s, r, x, sensor_from_tcp.rotation);
    rows.middleCols(p.effect_column(), columns.effects) = by_effects.leftCols(columns.effects);
    rows.middleCols(columns.shared(p), changes) = by_effects.rightCols(changes);
  }
  if (columns.curve_columns > 0)
    rows.middleCols(p.effect_column() + columns.effects, columns.curve_columns) = body * motion.by_curves;
  parts.row += r.rows;
}

/// Per column: what one unit of it is.
Eigen::VectorXd list_sizes(const Problem& p, const ChangeColumns& columns) {
  Eigen::VectorXd sizes = Eigen::VectorXd::Ones(columns.shared(p) + columns.changes);
  for (Eigen::Index c = 0; c < p.effect_count(); ++c)
    sizes[c < columns.effects ? p.effect_column() + c : columns.shared(p) + c - columns.effects] =
        p.columns_of_effects[static_cast<std::size_t>(c)].sigma;
  return sizes;
}

ObservationParts list_parts(const Problem& p, const ProblemObservation& o, const SharedState& state,
                            const ChangeColumns& columns, const Eigen::VectorXd& sizes, double weight) {
  Eigen::Index count = 0;
  for (const Sighting& s : o.sightings) count += row_count(s);
  ObservationParts parts{
      {Eigen::MatrixXd::Zero(count, sizes.size()), Eigen::MatrixXd(count, 6), Eigen::VectorXd(count)}};
  const Unknowns& u = state.unknowns;
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  BodyMotions motion{motion_by_columns(p, o, u), {}};
  if (columns.curve_columns > 0) motion.by_curves = motion_by_curves(*columns.curves, p, o, u);
  for (const Sighting& s : o.sightings) add_sighting(p, o, u, s, sensor_from_tcp, motion, columns, parts);
  // Curves do not move the problem: what they explain already is taken off here.
  if (columns.curve_columns > 0)
    parts.error -=
        parts.by_columns.middleCols(p.effect_column() + columns.effects, columns.curve_columns) * state.curves;
  parts.by_columns = weight * (parts.by_columns * sizes.asDiagonal());
  parts.by_body *= weight;
  parts.error *= weight;
  return parts;
}

/// The markers' own columns by a rigid motion of all of them.
Eigen::MatrixXd motions_of(const std::vector<Vector3>& markers) {
  Eigen::MatrixXd motions(3 * static_cast<Eigen::Index>(markers.size()), 6);
  for (std::size_t m = 0; m < markers.size(); ++m)
    motions.middleRows<3>(3 * static_cast<Eigen::Index>(m)) << Matrix3::Identity(), -cross_matrix(markers[m]);
  return motions;
}

/// Old columns by new ones: the markers' own replaced by a rigid motion of all of them.
Eigen::MatrixXd by_rigid_markers(Eigen::Index columns, const std::vector<Vector3>& markers) {
  const Eigen::Index points = 3 * static_cast<Eigen::Index>(markers.size());
  Eigen::MatrixXd by_new = Eigen::MatrixXd::Zero(columns, columns - points + 6);
  by_new.topLeftCorner(points, 6) = motions_of(markers);
  by_new.bottomRightCorner(columns - points, columns - points).setIdentity();
  return by_new;
}

}  // namespace

void ChangeRows::add(const ChangeRows& other) {
  observations.insert(observations.end(), other.observations.begin(), other.observations.end());
  information += other.information;
  gradient += other.gradient;
  squares += other.squares;
  rows += other.rows;
}

ChangeRows change_rows(const Problem& p, const SharedState& state, const ChangeColumns& columns, double weight) {
  const Eigen::VectorXd sizes = list_sizes(p, columns);
  ChangeRows all;
  all.information = Eigen::MatrixXd::Zero(sizes.size(), sizes.size());
  all.gradient = Eigen::VectorXd::Zero(sizes.size());
  GatheredRows gathered(all.information);
  for (const ProblemObservation& o : p.observations) {
    const ObservationParts parts = list_parts(p, o, state, columns, sizes, weight);
    ChangeObservation& summed = all.observations.emplace_back();
    summed.body_by_columns = parts.by_body.transpose() * parts.by_columns;
    summed.body_by_error = parts.by_body.transpose() * parts.error;
    summed.body_squares = parts.by_body.transpose() * parts.by_body;
    all.gradient += parts.by_columns.transpose() * parts.error;
    all.squares += parts.error.squaredNorm();
    all.rows += static_cast<int>(parts.error.size());
    gathered.add(parts.by_columns);
  }
  gathered.settle();
  all.information.triangularView<Eigen::StrictlyUpper>() = all.information.transpose();
  return all;
}

SingleRows single_rows(const Problem& p, const ProblemObservation& o, const SharedState& state,
                       const ChangeColumns& columns, double weight) {
  SingleRows rows = list_parts(p, o, state, columns, list_sizes(p, columns), weight);
  const Eigen::MatrixXd motions = motions_of(state.unknowns.markers_in_tcp);
  const Eigen::Index points = motions.rows(), others = rows.by_columns.cols() - points;
  Eigen::MatrixXd by_new(rows.by_columns.rows(), 6 + others);
  by_new << rows.by_columns.leftCols(points) * motions, rows.by_columns.rightCols(others);
  rows.by_columns = std::move(by_new);
  return rows;
}

ChangeRows with_rigid_markers(const ChangeRows& rows, const std::vector<Vector3>& markers) {
  const Eigen::MatrixXd by_new = by_rigid_markers(rows.gradient.size(), markers);
  ChangeRows rigid = rows;
  rigid.information = by_new.transpose() * rows.information * by_new;
  rigid.gradient = by_new.transpose() * rows.gradient;
  for (ChangeObservation& o : rigid.observations) o.body_by_columns = (o.body_by_columns * by_new).eval();
  return rigid;
}

ScatteredNormal scattered(const ChangeRows& rows, const Matrix6& repeatability) {
  ScatteredNormal n{rows.information, rows.gradient, rows.squares};
  if (repeatability.isZero(0)) return n;
  for (const ChangeObservation& o : rows.observations) {
    const Matrix6 m = posterior(repeatability, o.body_squares);
    n.information -= o.body_by_columns.transpose() * m * o.body_by_columns;
    n.gradient -= o.body_by_columns.transpose() * (m * o.body_by_error);
    n.squares -= o.body_by_error.dot(m * o.body_by_error);
  }
  return n;
}

Matrix6 repeatability_of(const BodyErrors& left) {
  const auto count = static_cast<double>(left.errors.size());
  Matrix6 repeatability = Matrix6::Zero();
  for (std::size_t i = 0; i < left.errors.size(); ++i) {
    const Vector6 motion = left.body_squares[i].completeOrthogonalDecomposition().solve(left.errors[i]);
    repeatability.diagonal() += motion.cwiseAbs2() / count;
  }
  for (int round = 0; round < 60; ++round) {
    Matrix6 next = Matrix6::Zero();
    for (std::size_t i = 0; i < left.errors.size(); ++i) {
      const Matrix6 m = posterior(repeatability, left.body_squares[i]);
      const Vector6 motion = m * left.errors[i];
      next += motion * motion.transpose() + m;
    }
    repeatability = next / count;
  }
  return 0.5 * (repeatability + repeatability.transpose());
}

LeftOver left_over(const ChangeRows& rows, const Eigen::VectorXd& step, double parameters, double noise_degrees) {
  BodyErrors errors;
  for (const ChangeObservation& o : rows.observations) {
    errors.errors.emplace_back(o.body_by_error - o.body_by_columns * step);
    errors.body_squares.push_back(o.body_squares);
  }
  const double left = rows.squares - 2 * rows.gradient.dot(step) + step.dot(rows.information * step);
  LeftOver over;
  if (const auto test = noise_test(left, rows.rows - parameters, noise_degrees)) over.p = test->p;
  if (over.p <= more_than_noise) over.repeatability = repeatability_of(errors);
  return over;
}

}  // namespace handsight
