// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem.h"

#include <algorithm>
#include <numeric>

namespace handsight {
namespace {

Eigen::VectorXd zero_position(const Chain& chain) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chain.joints.size()));
}

}  // namespace

Problem make_problem(const Session& session, const Chain& chain, const std::vector<EffectTerm>& terms) {
  Problem problem;
  problem.rig = chain.stereo;
  problem.marker_count = chain.marker_count;
  problem.mount_is_estimated = session.mount.estimate;
  problem.marker_is_seen.assign(static_cast<std::size_t>(chain.marker_count), 0);
  if (chain.stereo && !terms.empty())
    problem.rig = moved_rig(*chain.stereo, moved_sites(circumstances_at(chain, zero_position(chain)), terms));
  const std::vector<Circumstances> circumstances = circumstances_of(session, chain);

  std::vector<int> order(session.observations.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    const Observation& first = session.observations[static_cast<std::size_t>(a)];
    const Observation& second = session.observations[static_cast<std::size_t>(b)];
    return std::pair(first.time, first.id) < std::pair(second.time, second.id);
  });
  for (const int index : order) {
    const Observation& observation = session.observations[static_cast<std::size_t>(index)];
    if (!is_used(observation)) continue;
    const Circumstances& c = circumstances[static_cast<std::size_t>(index)];
    const ObservedEnds seen = observed_ends(c, moved_sites(c, terms));
    // A mount that moves against its link is the link moving the other way round the mount's place in the session.
    const Rigid& mount = session.mount.mount_from_sensor;
    const Rigid root_from_mount = seen.ends.root_from_mount * (mount * seen.mount_motion * inverse(mount));
    problem.observations.push_back(
        {index, seen.ends.root_from_tcp, root_from_mount, observation.sightings, {}, {}, seen.ends.converged});
    for (const Sighting& s : observation.sightings) problem.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
  }
  return problem;
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
      const auto point = s.left && s.right ? triangulate(*problem.rig, *s.left, *s.right) : std::nullopt;
      if (!point) {
        ++left_out;
        continue;
      }
      kept.push_back({s.marker, {}, {}, point->point, s.by});
      observation.point_covariances.push_back(point->covariance);
      points.marker_is_seen[static_cast<std::size_t>(s.marker)] = 1;
    }
    observation.sightings = std::move(kept);
  }
  std::erase_if(points.observations, [](const ProblemObservation& o) { return o.sightings.empty(); });
  return points;
}

Unknowns moved(const Unknowns& unknowns, const Eigen::VectorXd& step, bool mount_is_estimated) {
  Unknowns next = unknowns;
  for (std::size_t m = 0; m < next.markers_in_tcp.size(); ++m)
    next.markers_in_tcp[m] += step.segment<3>(3 * static_cast<Eigen::Index>(m));
  if (mount_is_estimated) next.mount_from_sensor = unknowns.mount_from_sensor * small_motion<double>(step.tail<6>());
  return next;
}

void add_observation(const Problem& problem, const ProblemObservation& observation, const Unknowns& unknowns,
                     NormalEquations& normal) {
  const Rigid sensor_from_tcp = sensor_from_tcp_at(observation, unknowns.mount_from_sensor);
  const Matrix3& r = sensor_from_tcp.rotation;
  const Eigen::Index mount = 3 * problem.marker_count;
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
  return normal;
}

}  // namespace handsight
