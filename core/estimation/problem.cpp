// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "effects/own_effect.h"
#include "estimation/priors.h"
#include "session/by_time.h"

namespace handsight {
namespace {

bool reads_torques(const std::vector<EffectTerm>& terms, const OwnEffects& own) {
  return std::any_of(terms.begin(), terms.end(), [](const EffectTerm& t) { return t.own && t.own->reads_torque; }) ||
         std::any_of(own.begin(), own.end(), [](const auto& effect) { return effect->reads_torque; });
}

/// A marker has a place as soon as a point of its piece is seen: the shape says where it then is.
void place_unseen(Problem& problem) {
  if (!problem.has_shape_prior()) return;
  std::vector<char> is_seen(static_cast<std::size_t>(problem.shape->piece_count()), 0);
  for (std::size_t m = 0; m < problem.marker_is_seen.size(); ++m)
    if (problem.marker_is_seen[m]) is_seen[static_cast<std::size_t>(problem.shape->piece(m))] = 1;
  for (std::size_t m = 0; m < problem.marker_is_seen.size(); ++m)
    problem.marker_is_seen[m] = is_seen[static_cast<std::size_t>(problem.shape->piece(m))];
}

void require_bearable(const Session& session) {
  constexpr int most = 1024;
  if (session.marker_count > most)
    throw InputError(
        fmt::format("{}: a fit can bear {} points, and the target has {}; use one with fewer squares or "
                    "tags, or name fewer ids.",
                    session.file.filename().string(), most, session.marker_count));
}

}  // namespace

Problem make_problem(const Session& session, const Chain& chain, const std::vector<EffectTerm>& held,
                     const std::vector<EffectTerm>& estimated) {
  require_bearable(session);
  Problem problem;
  problem.rig = chain.rig;
  problem.shape = session.shape;
  problem.marker_count = chain.marker_count;
  problem.mount_is_estimated = session.mount.estimate;
  problem.marker_is_seen.assign(static_cast<std::size_t>(chain.marker_count), 0);
  problem.terms = held;
  for (const EffectTerm& term : estimated) {
    const Effect& effect = effect_of(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (is_free(effect, term, p))
        problem.columns_of_effects.push_back({problem.terms.size(), p, plausible_size(effect.parameters[p], chain)});
    problem.terms.push_back(term);
  }
  auto source = std::make_shared<ProblemSource>();
  source->chain = chain;
  source->circumstances = circumstances_of(session, source->chain);
  source->own_effects = own_effects_of(session, source->chain);
  if (reads_torques(problem.terms, source->own_effects))
    for (Circumstances& c : source->circumstances) c.torque = nominal_torques(source->chain, c.sensor);
  problem.source = source;

  const double usual = usual_sigma(session);
  for (const int index : by_time(session)) {
    const Observation& observation = session.observations[static_cast<std::size_t>(index)];
    if (!is_used(observation)) continue;
    ProblemObservation& o = problem.observations.emplace_back();
    o.index = index;
    o.sightings = observation.sightings;
    for (Sighting& s : o.sightings) s.usual_sigma = usual;
    for (const Sighting& s : observation.sightings) problem.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
  }
  place_unseen(problem);
  place_observations(problem);
  return problem;
}

Eigen::VectorXd effect_values(const Problem& problem) {
  Eigen::VectorXd values(problem.effect_count());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const EffectColumn& c = problem.columns_of_effects[static_cast<std::size_t>(i)];
    values[i] = problem.terms[c.term].values[c.parameter];
  }
  return values;
}

void set_effect_values(Problem& problem, const Eigen::VectorXd& values) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const EffectColumn& c = problem.columns_of_effects[static_cast<std::size_t>(i)];
    problem.terms[c.term].values[c.parameter] = values[i];
  }
}

void set_effects(Problem& problem, const Eigen::VectorXd& values) {
  set_effect_values(problem, values);
  place_observations(problem);
}

void hold_effects(Problem& problem) {
  problem.columns_of_effects.clear();
  problem.cameras_by_effect.resize(0, 0);
  for (ProblemObservation& o : problem.observations) o.motion = EffectMotion{};
}

Problem as_points(const Problem& problem, int& left_out) {
  left_out = 0;
  if (!problem.rig) return problem;
  Problem points = problem;
  points.rig.reset();
  points.marker_is_seen.assign(points.marker_is_seen.size(), 0);
  for (ProblemObservation& observation : points.observations) {
    std::vector<Sighting> kept;
    observation.point_covariances.clear();
    for (const Sighting& s : observation.sightings) {
      const auto point = triangulate(*problem.rig, s);
      if (!point) {
        ++left_out;
        continue;
      }
      kept.push_back({.marker = s.marker, .point = point->point, .by = s.by});
      observation.point_covariances.push_back(point->covariance);
      points.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
    }
    observation.sightings = std::move(kept);
  }
  std::erase_if(points.observations, [](const ProblemObservation& o) { return o.sightings.empty(); });
  place_unseen(points);
  return points;
}

Unknowns moved(const Problem& problem, const Unknowns& unknowns, const Eigen::VectorXd& step) {
  Unknowns next = unknowns;
  for (std::size_t m = 0; m < next.markers_in_tcp.size(); ++m)
    next.markers_in_tcp[m] += step.segment<3>(3 * static_cast<Eigen::Index>(m));
  if (problem.mount_is_estimated)
    next.mount_from_sensor = unknowns.mount_from_sensor * small_motion<double>(step.segment<6>(problem.mount_column()));
  next.effects += step.tail(problem.effect_count());
  return next;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> motion_by_columns(const Problem& problem, const ProblemObservation& o,
                                                           const Unknowns& u) {
  const Eigen::Index mount = problem.mount_is_estimated ? 6 : 0;
  Eigen::Matrix<double, 6, Eigen::Dynamic> motion(6, mount + problem.effect_count());
  if (problem.mount_is_estimated) motion.leftCols<6>() = -adjoint(inverse(o.sensor_motion));
  if (problem.effect_count() == 0) return motion;
  const Rigid sensor_from_root = inverse(o.root_from_mount * u.mount_from_sensor * o.sensor_motion);
  motion.rightCols(problem.effect_count()).noalias() = adjoint(sensor_from_root) * o.motion.tcp_by_effect;
  if (o.motion.sensor_by_effect.cols() > 0) motion.rightCols(problem.effect_count()) -= o.motion.sensor_by_effect;
  return motion;
}

Eigen::MatrixXd direct_by_effects(const Problem& problem, const ProblemObservation& o, const Sighting& sighting,
                                  const SightingResidual& residual, const Vector3& x_in_sensor,
                                  const Matrix3& sensor_from_tcp_rotation) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(residual.rows, problem.effect_count());
  for (const EffectMotion::MarkerColumn& m : o.motion.markers)
    if (m.marker == sighting.marker) rows.col(m.column) += residual.by_point * (sensor_from_tcp_rotation * m.direction);
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

/// One sighting's part. The usual two cameras have rows of a fixed number, whose products cost less.
template <int Rows>
void add_sighting_with_effects(const Problem& problem, const ProblemObservation& o, const Sighting& sighting,
                               const SightingResidual& r, const Vector3& x, double root, const Matrix3& rotation,
                               const Eigen::Matrix<double, 6, Eigen::Dynamic>& motion, bool direct, BodySums& sums,
                               NormalEquations& normal) {
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
  Eigen::Matrix<double, Rows, Eigen::Dynamic> by_columns = by_body * motion;
  by_columns.rightCols(problem.effect_count()) += root * direct_by_effects(problem, o, sighting, r, x, rotation);
  normal.information.block(mount, mount, count, count).noalias() += by_columns.transpose() * by_columns;
  normal.information.block(mount, m, count, 3).noalias() += by_columns.transpose() * by_marker;
  normal.gradient.segment(mount, count).noalias() += by_columns.transpose() * error;
}

/// The general road: effects among the columns, or a sensor or markers that move.
void add_observation_with_effects(const Problem& problem, const ProblemObservation& o, const Unknowns& u,
                                  NormalEquations& normal) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u.mount_from_sensor);
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
    const auto add = r.rows == 4 ? add_sighting_with_effects<4> : add_sighting_with_effects<Eigen::Dynamic>;
    add(problem, o, sighting, r, x, root, sensor_from_tcp.rotation, motion, direct, sums, normal);
  }
  if (direct) return;
  const Eigen::Matrix<double, 6, Eigen::Dynamic> weighed = sums.information * motion;
  normal.information.block(mount, mount, count, count).noalias() += motion.transpose() * weighed;
  normal.gradient.segment(mount, count).noalias() += motion.transpose() * sums.gradient;
}

bool is_plain(const Problem& problem, const ProblemObservation& o) {
  return problem.effect_count() == 0 && o.marker_shifts.empty() && !o.sensor_moves;
}

}  // namespace

void add_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                     NormalEquations& normal) {
  if (!is_plain(problem, observation)) return add_observation_with_effects(problem, observation, unknowns, normal);
  const Rigid sensor_from_tcp = sensor_from_tcp_at(observation, unknowns.mount_from_sensor);
  const Matrix3& r = sensor_from_tcp.rotation;
  const Eigen::Index mount = problem.mount_column();
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
    if (!problem.mount_is_estimated) continue;
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
  if (!problem.mount_is_estimated) return;
  normal.information.block<6, 6>(mount, mount) += mount_information;
  normal.gradient.segment<6>(mount) += mount_gradient;
}

void complete(NormalEquations& normal) {
  normal.information = Eigen::MatrixXd(normal.information.selfadjointView<Eigen::Lower>());
}

NormalEquations normal_equations(const Problem& problem, const Unknowns& unknowns, std::span<const int> places) {
  NormalEquations normal(problem.columns());
  if (places.empty()) {
    for (const ProblemObservation& o : problem.observations) add_observation(problem, o, unknowns, normal);
  } else {
    for (const int place : places)
      add_observation(problem, problem.observations[static_cast<std::size_t>(place)], unknowns, normal);
  }
  complete(normal);
  add_priors(problem, unknowns, normal);
  return normal;
}

}  // namespace handsight
