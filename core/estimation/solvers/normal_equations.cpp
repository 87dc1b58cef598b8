// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/normal_equations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/threads.h"
#include "estimation/problem/column_products.h"
#include "estimation/solvers/flange_error.h"
#include "estimation/solvers/priors.h"

namespace handsight {

Unknowns moved(const Problem& problem, const Unknowns& unknowns, const Eigen::VectorXd& step) {
  Unknowns next = unknowns;
  for (std::size_t m = 0; m < next.markers_in_tcp.size(); ++m)
    next.markers_in_tcp[m] += step.segment<3>(3 * static_cast<Eigen::Index>(m));
  for (int i = 0; i < problem.mount_count(); ++i)
    if (const Eigen::Index column = problem.column_of_mount(i); column >= 0)
      next.mount(i) = unknowns.mount(i) * small_motion<double>(step.segment<6>(column));
  next.effects += step.tail(problem.effect_count());
  return next;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> motion_by_columns(const Problem& problem, const ProblemObservation& o,
                                                           const Unknowns& u) {
  const Eigen::Index mounts = problem.mount_columns(), mount = problem.column_of_mount(o.mount);
  Eigen::Matrix<double, 6, Eigen::Dynamic> motion(6, mounts + problem.effect_count());
  if (mounts > 6 || mount < 0) motion.leftCols(mounts).setZero();
  if (mount >= 0) motion.middleCols<6>(mount - problem.mount_column()) = -adjoint(inverse(o.sensor_motion));
  if (problem.effect_count() == 0) return motion;
  const Rigid sensor_from_root = inverse(o.root_from_mount * find_mount(o, u) * o.sensor_motion);
  motion.rightCols(problem.effect_count()).noalias() = adjoint(sensor_from_root) * o.motion.tcp_by_effect;
  if (o.motion.sensor_by_effect.cols() > 0) motion.rightCols(problem.effect_count()) -= o.motion.sensor_by_effect;
  return motion;
}

Eigen::MatrixXd direct_by_effects(const Problem& problem, const ProblemObservation& o, const Sighting& sighting,
                                  const SightingResidual& residual, const Vector3& x_in_sensor,
                                  const Matrix3& sensor_from_tcp_rotation) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(residual.rows, problem.effect_count());
  const std::vector<EffectMotion::MarkerColumn>& moved = o.motion.markers;
  auto m = std::ranges::lower_bound(moved, sighting.marker, {}, &EffectMotion::MarkerColumn::marker);
  for (; m != moved.end() && m->marker == sighting.marker; ++m)
    rows.col(m->column) += residual.by_point * (sensor_from_tcp_rotation * m->direction);
  if (problem.cameras_by_effect.cols() == 0 || !problem.rig) return rows;
  // Camera by camera: what a sighting's rows owe to the numbers of the others is zero.
  const CameraColumns by_numbers = camera_columns(*problem.rig, sighting, x_in_sensor);
  const int cameras = problem.rig->count();
  Eigen::Index row = 0;
  for (const CameraPoint& seen : sighting.in_cameras) {
    const Eigen::Index first = first_number(cameras, seen.camera);
    rows.middleRows<2>(row) += by_numbers.block<2, camera_number_count>(row, first)
                                   .lazyProduct(problem.cameras_by_effect.middleRows<camera_number_count>(first));
    if (seen.camera > 0)
      rows.middleRows<2>(row) += by_numbers.block<2, 6>(row, motion_number(seen.camera))
                                     .lazyProduct(problem.cameras_by_effect.middleRows<6>(motion_number(seen.camera)));
    row += 2;
  }
  return rows;
}

namespace {

/// What the sightings of an observation add up to by the six motions of the body.
struct BodySums {
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
};

/// For the columns from the mount on, of that many observations.
GatheredRows rows_for(const Problem& problem, NormalEquations& normal, std::size_t observations) {
  const Eigen::Index count = problem.columns() - problem.mount_column();
  return GatheredRows(normal.information.bottomRightCorner(count, count),
                      max_rows * static_cast<Eigen::Index>(observations));
}

/// A matrix R with R^T R = m, for m >= 0.
Matrix6 require_root(const Matrix6& m) {
  const Eigen::LDLT<Matrix6> ldlt(m);
  Matrix6 root = Matrix6::Identity();
  root = ldlt.transpositionsP() * root;
  root = ldlt.matrixU() * root;
  return ldlt.vectorD().cwiseMax(0).cwiseSqrt().asDiagonal() * root;
}

/// What products of large matrices are prepared with costs more than two rows' products themselves.
template <int Rows, class A, class B>
auto product(const A& a, const B& b) {
  if constexpr (Rows == 2)
    return a.lazyProduct(b);
  else
    return a * b;
}

/// One sighting's part. The usual two cameras, and one, have rows of a fixed number, whose products cost less.
template <int Rows>
void add_sighting_with_effects(const Problem& problem, const ProblemObservation& o, const Sighting& sighting,
                               const SightingResidual& r, const Vector3& x, double root, const Matrix3& rotation,
                               const Eigen::Matrix<double, 6, Eigen::Dynamic>& motion, bool direct, BodySums& sums,
                               GatheredRows& gathered, NormalEquations& normal) {
  constexpr int most = Rows == Eigen::Dynamic ? max_rows : Rows;
  const Eigen::Index mount = problem.mount_column(), count = problem.columns() - mount, m = 3 * sighting.marker;
  const Eigen::Matrix<double, Rows, 3, 0, most, 3> by_point = root * r.by_point;
  const auto by_body = by_motion(by_point, x);
  const Eigen::Matrix<double, Rows, 3, 0, most, 3> by_marker = by_point * rotation;
  const Eigen::Matrix<double, Rows, 1, 0, most, 1> error = root * r.error;
  normal.cost += error.squaredNorm();
  normal.information.block<3, 3>(m, m).noalias() += by_marker.transpose() * by_marker;
  normal.gradient.segment<3>(m).noalias() += by_marker.transpose() * error;
  if (!direct) {
    sums.information.noalias() += by_body.transpose() * by_body;
    sums.gradient.noalias() += by_body.transpose() * error;
    normal.information.block(mount, m, count, 3).noalias() += motion.transpose() * (by_body.transpose() * by_marker);
    return;
  }
  Eigen::Matrix<double, Rows, Eigen::Dynamic> by_columns = product<Rows>(by_body, motion);
  by_columns.rightCols(problem.effect_count()) += root * direct_by_effects(problem, o, sighting, r, x, rotation);
  gathered.add(by_columns);
  normal.information.block(mount, m, count, 3).noalias() += product<Rows>(by_columns.transpose(), by_marker);
  normal.gradient.segment(mount, count).noalias() += product<Rows>(by_columns.transpose(), error);
}

/// The general road: effects among the columns, or a sensor or markers that move.
void add_observation_with_effects(const Problem& problem, const ProblemObservation& o, const Unknowns& u,
                                  GatheredRows& gathered, NormalEquations& normal) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  const Eigen::Index mount = problem.mount_column();
  const Eigen::Index count = problem.columns() - mount;
  const auto motion = motion_by_columns(problem, o, u);
  const bool direct = problem.cameras_by_effect.cols() > 0 || !o.motion.markers.empty();
  BodySums sums;
  for (std::size_t i = 0; i < o.sightings.size(); ++i) {
    const Sighting& sighting = o.sightings[i];
    const Vector3 x = sensor_from_tcp * marker_at(o, u, sighting.marker);
    const SightingResidual r = sighting_residual(problem.rig_or_null(), sighting, x);
    const double root = o.weights.empty() ? 1.0 : std::sqrt(o.weights[i]);
    normal.rows += r.rows;
    normal.in_front = normal.in_front && r.in_front;
    const auto add = r.rows == 4   ? add_sighting_with_effects<4>
                     : r.rows == 2 ? add_sighting_with_effects<2>
                                   : add_sighting_with_effects<Eigen::Dynamic>;
    add(problem, o, sighting, r, x, root, sensor_from_tcp.rotation, motion, direct, sums, gathered, normal);
  }
  if (direct) return;
  gathered.add(require_root(sums.information).lazyProduct(motion));
  normal.gradient.segment(mount, count).noalias() += motion.transpose() * sums.gradient;
}

bool is_plain(const Problem& problem, const ProblemObservation& o) {
  return problem.effect_count() == 0 && o.marker_shifts.empty() && !o.sensor_moves;
}

void add_plain_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                           NormalEquations& normal) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(observation, unknowns);
  const Matrix3& r = sensor_from_tcp.rotation;
  const Eigen::Index mount = problem.column_of_mount(observation.mount);
  Matrix6 mount_information = Matrix6::Zero();
  Vector6 mount_gradient = Vector6::Zero();
  for (std::size_t i = 0; i < observation.sightings.size(); ++i) {
    const Sighting& sighting = observation.sightings[i];
    const Vector3 x = sensor_from_tcp * unknowns.markers_in_tcp[static_cast<std::size_t>(sighting.marker)];
    SightingNormal n = sighting_normal(problem.rig_or_null(), sighting, x);
    if (!observation.weights.empty()) {
      n.information *= observation.weights[i];
      n.gradient *= observation.weights[i];
      n.cost *= observation.weights[i];
    }
    normal.cost += n.cost;
    normal.rows += n.rows;
    normal.in_front = normal.in_front && n.in_front;
    const Eigen::Index m = 3 * sighting.marker;
    const Matrix3 information_r = n.information * r;
    normal.information.block<3, 3>(m, m).noalias() += r.transpose() * information_r;
    normal.gradient.segment<3>(m).noalias() += r.transpose() * n.gradient;
    if (mount < 0) continue;
    // The mount's exp(v) moves the point in the sensor's frame by -(v_t + v_r cross x).
    const Matrix3 k = cross_matrix(x);
    const Matrix3 information_k = n.information * k;
    mount_information.topLeftCorner<3, 3>() += n.information;
    mount_information.bottomLeftCorner<3, 3>().noalias() += k * n.information;
    mount_information.bottomRightCorner<3, 3>().noalias() -= k * information_k;
    mount_gradient.head<3>() -= n.gradient;
    mount_gradient.tail<3>().noalias() -= k * n.gradient;
    normal.information.block<3, 3>(mount, m) -= information_r;
    normal.information.block<3, 3>(mount + 3, m).noalias() -= k * information_r;
  }
  if (mount < 0) return;
  normal.information.block<6, 6>(mount, mount) += mount_information;
  normal.gradient.segment<6>(mount) += mount_gradient;
}

void add_observation_of_a_robot_that_errs(const Problem& problem, const ProblemObservation& o, const Unknowns& unknowns,
                                          NormalEquations& normal) {
  NormalEquations one(problem.columns());
  add_observation(problem, o, unknowns, one);
  complete(one);
  add_without_flange_error(problem, o, unknowns, one, normal);
}

/// Of the observations at `places` in the problem's order from `first` on; of all of them where there are no places.
NormalEquations sum_of(const Problem& problem, const Unknowns& unknowns, std::span<const int> places, std::size_t first,
                       std::size_t count) {
  NormalEquations normal(problem.columns());
  GatheredRows gathered = rows_for(problem, normal, count);
  for (std::size_t i = first; i < first + count; ++i) {
    const ProblemObservation& o = problem.observations[places.empty() ? i : static_cast<std::size_t>(places[i])];
    if (problem.flange_error.is_any())
      add_observation_of_a_robot_that_errs(problem, o, unknowns, normal);
    else if (is_plain(problem, o))
      add_plain_observation(problem, o, unknowns, normal);
    else
      add_observation_with_effects(problem, o, unknowns, gathered, normal);
  }
  gathered.settle();
  return normal;
}

void add_sum(const NormalEquations& part, NormalEquations& normal) {
  normal.information += part.information;
  normal.gradient += part.gradient;
  normal.cost += part.cost;
  normal.rows += part.rows;
  normal.in_front = normal.in_front && part.in_front;
}

/// In parts, as many however many threads there are: sums then are the same bit by bit.
NormalEquations sums_of(const Problem& problem, const Unknowns& unknowns, std::span<const int> places) {
  constexpr std::size_t most_parts = 8, of_sightings = 10, least_work = 4'000;
  const std::size_t count = places.empty() ? problem.observations.size() : places.size();
  const auto effects = static_cast<std::size_t>(problem.effect_count());
  if (count < most_parts || effects == 0 || count * (effects + of_sightings) < least_work)
    return sum_of(problem, unknowns, places, 0, count);
  std::vector<NormalEquations> sums(most_parts, NormalEquations(0));
  each_part(most_parts, true, [&](int part) {
    const std::size_t first = count * static_cast<std::size_t>(part) / most_parts;
    const std::size_t end = count * static_cast<std::size_t>(part + 1) / most_parts;
    sums[static_cast<std::size_t>(part)] = sum_of(problem, unknowns, places, first, end - first);
  });
  for (std::size_t part = 1; part < most_parts; ++part) add_sum(sums[part], sums.front());
  return std::move(sums.front());
}

}  // namespace

void add_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                     NormalEquations& normal) {
  if (is_plain(problem, observation)) return add_plain_observation(problem, observation, unknowns, normal);
  GatheredRows gathered = rows_for(problem, normal, 1);
  add_observation_with_effects(problem, observation, unknowns, gathered, normal);
  gathered.settle();
}

Eigen::VectorXd compute_gradient(const Problem& problem, const ProblemObservation& o, const Unknowns& u) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(problem.columns());
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
  const bool direct = problem.cameras_by_effect.cols() > 0 || !o.motion.markers.empty();
  Vector6 by_body = Vector6::Zero();
  for (std::size_t i = 0; i < o.sightings.size(); ++i) {
    const Sighting& sighting = o.sightings[i];
    const Vector3 x = sensor_from_tcp * marker_at(o, u, sighting.marker);
    SightingResidual r = sighting_residual(problem.rig_or_null(), sighting, x);
    if (!o.weights.empty()) r.error *= o.weights[i];
    gradient.segment<3>(3 * sighting.marker) +=
        sensor_from_tcp.rotation.transpose() * (r.by_point.transpose() * r.error);
    by_body += by_motion(r.by_point, x).transpose() * r.error;
    if (direct)
      gradient.tail(problem.effect_count()) +=
          direct_by_effects(problem, o, sighting, r, x, sensor_from_tcp.rotation).transpose() * r.error;
  }
  gradient.tail(problem.columns() - problem.mount_column()) += motion_by_columns(problem, o, u).transpose() * by_body;
  return gradient;
}

void complete(NormalEquations& normal) {
  normal.information = Eigen::MatrixXd(normal.information.selfadjointView<Eigen::Lower>());
}

namespace {

/// A socket has no turn: what a linear step would win by one is not there once it is taken.
void hold_turns_of_sockets(const Problem& problem, NormalEquations& normal) {
  if (!has_fixtures(problem)) return;
  for (const ProblemObservation& o : problem.observations) {
    const ObservationState& c = problem.source->states[static_cast<std::size_t>(o.index)];
    const bool is_socket =
        c.chain->is_fixture && !o.sightings.empty() && !o.sightings.front().along && !o.sightings.front().reading;
    const Eigen::Index turns = is_socket ? problem.column_of_mount(o.mount) + 3 : -1;
    if (turns < 3 || normal.information(turns, turns) == 0) continue;
    normal.information.middleRows<3>(turns).setZero();
    normal.information.middleCols<3>(turns).setZero();
    normal.gradient.segment<3>(turns).setZero();
  }
}

}  // namespace

NormalEquations normal_equations(const Problem& problem, const Unknowns& unknowns, std::span<const int> places) {
  NormalEquations normal = sums_of(problem, unknowns, places);
  complete(normal);
  add_priors(problem, unknowns, normal);
  hold_turns_of_sockets(problem, normal);
  return normal;
}

}  // namespace handsight
