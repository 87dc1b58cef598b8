// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/robot_readings.h"

namespace handsight {
namespace {

constexpr double test_mass = 1;  // kg

Eigen::VectorXd one(double x) { return Eigen::VectorXd::Constant(1, x); }

/// The hand with every joint that has play, or is held back by friction, on one of its two sides.
std::optional<Vector3> on_side(ObservationState c, const Terms& terms, double side) {
  c.approach.setConstant(side);
  Sites sites = moved_sites(c, terms);
  for (JointChange& joint : sites.robot.joints) {
    joint.angle += side * joint.gap;
    joint.gap = 0;
  }
  const ObservedEnds observed = observed_ends(c, sites);
  if (!observed.ends.converged) return std::nullopt;
  return observed.ends.root_from_tcp.translation;
}

}  // namespace

ObservationState at_rest(ObservationState c) {
  c.velocity.setZero();
  return c;
}

ReadValue drop(const ObservationState& c, const Terms& terms) {
  Sites sites = moved_sites(c, terms);
  const ObservedEnds empty = observed_ends(c, sites);
  sites.robot.payload_link = c.chain->tcp_link;
  sites.robot.payload_mass += test_mass;
  const ObservedEnds loaded = observed_ends(c, sites);
  if (!empty.ends.converged || !loaded.ends.converged || !(c.chain->gravity.norm() > 0)) return std::nullopt;
  const Vector3 motion = loaded.ends.root_from_tcp.translation - empty.ends.root_from_tcp.translation;
  return one(c.chain->gravity.normalized().dot(motion));
}

ReadValue between_sides(const ObservationState& c, const Terms& terms) {
  const auto up = on_side(c, terms, 1), down = on_side(c, terms, -1);
  if (!up || !down) return std::nullopt;
  return Eigen::VectorXd(*up - *down);
}

ReadValue hand_in_sensor(const ObservationState& c, const Terms& terms, const Rigid& mount) {
  const ObservedEnds o = observed_ends(c, moved_sites(c, terms));
  if (!o.ends.converged) return std::nullopt;
  return Eigen::VectorXd(sensor_from_tcp(o.ends, mount * o.mount_motion).translation);
}

ReadValue from_start_to_end(const ObservationState& c, const Terms& terms, const Rigid& mount) {
  ObservationState first = c, last = c;
  first.elapsed = 0;
  last.elapsed = c.duration;
  const ReadValue start = hand_in_sensor(first, terms, mount), end = hand_in_sensor(last, terms, mount);
  if (!start || !end) return std::nullopt;
  return Eigen::VectorXd(*end - *start);
}

double angle_error(const ObservationState& states, const Terms& terms, int joint, double q) {
  ObservationState c = at_rest(states);
  c.sensor[joint] = q;
  const Sites sites = moved_sites(c, terms);
  return sites.robot.joints.empty() ? 0 : sites.robot.joints[static_cast<std::size_t>(joint)].angle;
}

ReadValue off_epipolar_line(const Rig& nominal, const Rig& rig, const Vector3& x) {
  Eigen::VectorXd distances(rig.count() - 1);
  const auto first = undistort(nominal.at(0).camera, project(rig.at(0).camera, x));
  if (!first || rig.count() < 2) return std::nullopt;
  for (int c = 1; c < rig.count(); ++c) {
    const Vector3 in_camera = rig.at(c).camera_from_first * x;
    const auto other = undistort(nominal.at(c).camera, project(rig.at(c).camera, in_camera));
    if (!other) return std::nullopt;
    const StereoRig pair{nominal.at(0).camera, nominal.at(c).camera, nominal.at(c).camera_from_first};
    distances[c - 1] = epipolar_distance(pair, essential_matrix(pair), *first, *other);
  }
  return distances;
}

ReadValue image_points(const Rig& rig, const Vector3& x) {
  Eigen::VectorXd all(2 * rig.count());
  for (int c = 0; c < rig.count(); ++c)
    all.segment<2>(2 * c) = project(rig.at(c).camera, Vector3(rig.at(c).camera_from_first * x));
  return all;
}

}  // namespace handsight
