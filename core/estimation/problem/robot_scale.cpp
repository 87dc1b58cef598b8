// SPDX-License-Identifier: Apache-2.0
#include "estimation/problem/robot_scale.h"

#include <Eigen/QR>
#include <numbers>
#include <random>

#include "estimation/problem/problem_part.h"
#include "session/fixtures/fixture_kind.h"

namespace handsight {

bool measures_no_length(const Session& session, const Chain& chain) {
  constexpr double least = 1e-2;  // of the robot's length
  if (!session.is_tracker() || !session.distances.empty()) return false;
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Fixture& fixture = session.fixtures[f];
    // From the robot's base to a place that is known is a length too.
    const bool is_known =
        fixture.place_sigma || !find_mount(session, part_of_fixture(session, static_cast<int>(f)).mount).estimate;
    if (fixture.kind->tells_length || is_known) return false;
  }
  double length = 0;
  for (const Joint& joint : chain.robot.joints) length += joint.parent_from_joint.translation.norm();
  std::vector<std::optional<Vector3>> first(static_cast<std::size_t>(session.marker_count));
  for (const Observation& o : session.observations) {
    if (!is_used(o)) continue;
    for (const Sighting& s : o.sightings) {
      if (!s.point) return false;
      std::optional<Vector3>& at = first[static_cast<std::size_t>(s.marker)];
      if (!at) at = *s.point;
      if ((*s.point - *at).norm() > least * length) return false;
    }
  }
  return true;
}

namespace {

constexpr int postures = 48;

/// A value of a joint from all of its range.
double drawn_value(const Joint& joint, std::mt19937_64& random) {
  const double widest = joint.kind == JointKind::prismatic ? 0.3 : std::numbers::pi;
  const double low = std::max(joint.lower, -widest), high = std::min(joint.upper, widest);
  const double share = static_cast<double>(random() >> 11) * 0x1p-53;
  return low < high ? low + share * (high - low) : 0.0;
}

std::shared_ptr<const ProblemSource> in_all_postures(const ProblemSource& source) {
  auto all = std::make_shared<ProblemSource>(source);
  // What its effects read is worked out, as for the observations: once, not for every number at every step.
  const bool torques = !source.states.empty() && source.states.front().torque.size() > 0;
  const bool places = !source.states.empty() && source.states.front().tcp.has_value();
  all->states.clear();
  std::mt19937_64 random(20);
  const Chain& chain = all->chain;
  for (int i = 0; i < postures; ++i) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(chain.joints.size()));
    for (Eigen::Index j = 0; j < values.size(); ++j) {
      const auto joint = static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)]);
      values[j] = drawn_value(chain.robot.joints[joint], random);
    }
    ObservationState c = states_at(chain, values);
    if (torques) c.torque = nominal_torques(chain, c.sensor);
    if (places) c.tcp = nominal_tcp(chain, c.sensor);
    all->states.push_back(std::move(c));
  }
  return all;
}

/// The problem's effects in those postures.
Problem in_postures(const Problem& problem, const std::shared_ptr<const ProblemSource>& source) {
  Problem all = without_observations(problem);
  all.robot_scale.reset();
  all.source = source;
  for (int i = 0; i < postures; ++i) all.observations.emplace_back().index = i;
  place_observations(all);
  return all;
}

/// The point of the TCP's link that moves least, where it stands in each posture against its mean, and how far that is.
struct Stillest {
  Vector3 in_tcp;
  Eigen::VectorXd moved;  // 3 postures, in the mount's link, m
  double size() const { return moved.norm() / std::sqrt(static_cast<double>(postures)); }
};

Stillest stillest_point(const Problem& all) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> by_point(3 * postures, 6);
  Eigen::VectorXd places(3 * postures);
  for (int i = 0; i < postures; ++i) {
    const ProblemObservation& o = all.observations[static_cast<std::size_t>(i)];
    const Rigid mount_from_tcp = inverse(o.root_from_mount) * o.root_from_tcp;
    by_point.block<3, 3>(3 * i, 0) = mount_from_tcp.rotation;
    by_point.block<3, 3>(3 * i, 3) = -Matrix3::Identity();
    places.segment<3>(3 * i) = mount_from_tcp.translation;
  }
  const Vector6 point = by_point.completeOrthogonalDecomposition().solve(-places);
  return {point.head<3>(), places + by_point * point};
}

}  // namespace

RobotScale described_scale(const Problem& problem) {
  RobotScale scale;
  scale.postures = in_all_postures(*problem.source);
  Problem plain = without_observations(problem);
  plain.terms.clear();
  plain.columns_of_effects.clear();
  scale.described = stillest_point(in_postures(plain, scale.postures)).size();
  return scale;
}

void follow_robot_scale(Problem& problem) {
  if (!problem.robot_scale) return;
  RobotScale& scale = *problem.robot_scale;
  scale.change = 0;
  scale.by_effect.setZero(problem.effect_count());
  if (problem.effect_count() == 0 || !(scale.described > 0)) return;
  const Problem all = in_postures(problem, scale.postures);
  const Stillest point = stillest_point(all);
  const double squares = std::max(point.moved.squaredNorm(), 1e-12);
  scale.change = std::log(std::sqrt(squares / postures) / scale.described);
  for (int i = 0; i < postures; ++i) {
    const ProblemObservation& o = all.observations[static_cast<std::size_t>(i)];
    const Matrix3 to_mount = o.root_from_mount.rotation.transpose();
    const Eigen::Matrix3Xd by_effect =
        to_mount * (o.motion.tcp_by_effect.topRows<3>() -
                    cross_matrix(o.root_from_tcp * point.in_tcp) * o.motion.tcp_by_effect.bottomRows<3>());
    scale.by_effect += by_effect.transpose() * point.moved.segment<3>(3 * i) / squares;
  }
}

}  // namespace handsight
