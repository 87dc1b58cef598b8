// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/one_marker.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "chain/chain.h"
#include "chain/sighting.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/fit_result.h"
#include "robot/posture.h"

namespace handsight {
namespace {

constexpr double standard_gravity = 9.81;  // m/s^2: the effective mass in kg is read as a weight

struct ArmJoint {
  int joint = 0;
  double stiffness = 0;
};

struct Arm {
  const Chain& chain;
  std::vector<ArmJoint> joints;
  Rigid mount_from_sensor;
  Vector3 marker_in_tcp;
};

/// Joints that move the TCP and not the mount: in them a pull at the hand shows.
std::vector<ArmJoint> arm_joints(const Chain& chain, double default_stiffness, bool& assumed) {
  std::vector<ArmJoint> arm;
  for (const int j : joints_to(chain.robot, chain.tcp_link)) {
    const Joint& joint = chain.robot.joints[static_cast<std::size_t>(j)];
    if (!joint.moves() || is_distal(chain.robot, j, chain.mount_link)) continue;
    assumed = assumed || !(joint.stiffness > 0);
    arm.push_back({j, joint.stiffness > 0 ? joint.stiffness : default_stiffness});
  }
  return arm;
}

Posture posture_with(const Arm& arm, const Eigen::VectorXd& sensor, const Eigen::VectorXd& bend) {
  RobotChange change;
  change.joints.resize(arm.chain.robot.joints.size());
  for (std::size_t i = 0; i < arm.joints.size(); ++i)
    change.joints[static_cast<std::size_t>(arm.joints[i].joint)].angle = bend[static_cast<Eigen::Index>(i)];
  return solve_posture<double>(arm.chain.robot, sensor, change, arm.chain.gravity, false);
}

Rigid root_from_sensor(const Arm& arm, const Posture& posture) {
  return posture.root_from_link[static_cast<std::size_t>(arm.chain.mount_link)] * arm.mount_from_sensor;
}

/// d marker / d arm joint angles, 3 x n, root frame.
Eigen::Matrix3Xd marker_jacobian(const Arm& arm, const Posture& posture) {
  const Vector3 marker = posture.root_from_link[static_cast<std::size_t>(arm.chain.tcp_link)] * arm.marker_in_tcp;
  Eigen::Matrix3Xd jacobian(3, static_cast<Eigen::Index>(arm.joints.size()));
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const auto j = static_cast<std::size_t>(arm.joints[i].joint);
    const Joint& joint = arm.chain.robot.joints[j];
    const Rigid& frame = posture.root_from_joint[j];
    const Vector3 axis = frame.rotation * joint.axis;
    jacobian.col(static_cast<Eigen::Index>(i)) =
        joint.kind == JointKind::prismatic ? axis : Vector3(axis.cross(marker - frame.translation));
  }
  return jacobian;
}

Eigen::VectorXd compliances(const Arm& arm) {
  Eigen::VectorXd c(static_cast<Eigen::Index>(arm.joints.size()));
  for (std::size_t i = 0; i < arm.joints.size(); ++i) c[static_cast<Eigen::Index>(i)] = 1 / arm.joints[i].stiffness;
  return c;
}

/// Deviation (sensor frame) with the force `mass * g` along `direction` (root frame) bending the arm's springs; the
/// torques are those of the posture as commanded (thesis 4.44, 4.46). The camera stands where it is commanded.
Vector3 deviation(const Arm& arm, const Eigen::VectorXd& sensor, const Posture& commanded,
                  const Eigen::Matrix3Xd& jacobian, const Vector3& direction, const Vector3& measured, double mass) {
  const Eigen::VectorXd torque = jacobian.transpose() * direction * (mass * standard_gravity);
  const Posture bent = posture_with(arm, sensor, compliances(arm).cwiseProduct(torque));
  return inverse(root_from_sensor(arm, commanded)) *
             (bent.root_from_link[static_cast<std::size_t>(arm.chain.tcp_link)] * arm.marker_in_tcp) -
         measured;
}

EffectiveMass pull(const Arm& arm, const Eigen::VectorXd& sensor, const Vector3& measured) {
  EffectiveMass result;
  const Posture commanded =
      posture_with(arm, sensor, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arm.joints.size())));
  const Eigen::Matrix3Xd jacobian = marker_jacobian(arm, commanded);
  const Rigid root_from_camera = root_from_sensor(arm, commanded);
  result.before = deviation(arm, sensor, commanded, jacobian, Vector3::Zero(), measured, 0);
  result.after = result.before;
  if (result.before.norm() < 1e-12) return result;

  const Vector3 direction = root_from_camera.rotation * result.before.normalized();
  const Vector3 reach = jacobian * compliances(arm).asDiagonal() * jacobian.transpose() * direction;  // m/N
  if (reach.norm() < 1e-15) return result;
  const double cosine = std::clamp(direction.dot(reach) / reach.norm(), -1.0, 1.0);
  result.angle = std::acos(cosine);
  result.predicted_after = result.before.norm() * std::sin(result.angle);

  // Newton on the mass from the linear answer; the slope by symmetric difference of the exact forward kinematics.
  auto at = [&](double mass) { return deviation(arm, sensor, commanded, jacobian, direction, measured, mass); };
  const double scale = result.before.norm() / (reach.norm() * standard_gravity);
  double mass = -direction.dot(reach) * result.before.norm() / (reach.squaredNorm() * standard_gravity);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const double step = 1e-4 * scale;
    const Vector3 slope = (at(mass + step) - at(mass - step)) / (2 * step);
    const double change = -slope.dot(at(mass)) / slope.squaredNorm();
    mass += change;
    if (std::abs(change) < 1e-12 * scale) break;
  }
  result.mass = mass;
  result.after = at(mass);
  return result;
}

std::optional<Vector3> measured_marker(const Session& session, const Observation& observation, int marker) {
  for (const Sighting& s : observation.sightings) {
    if (s.marker != marker) continue;
    if (s.point) return s.point;
    const auto point = triangulate_unweighed(*session.rig, s);
    return point ? std::optional(point->point) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

OneMarkerResult effective_masses(const Session& session, const OneMarkerOptions& options) {
  if (options.marker < 0 || options.marker >= session.marker_count)
    throw InputError(message("Marker {} does not exist; the session has markers 0 to {}.", options.marker,
                             session.marker_count - 1));
  const Chain chain = make_chain(session);
  OneMarkerResult result;
  Arm arm{chain, arm_joints(chain, options.default_stiffness, result.stiffness_is_assumed),
          session.mount.mount_from_sensor, Vector3::Zero()};
  if (arm.joints.empty())
    throw InputError(message("{}: no joint moves {} without moving {}; a pull at the hand shows nowhere.",
                             session.file.filename().string(), session.tcp, session.mount.link));
  for (const ArmJoint& j : arm.joints)
    result.joints.push_back(chain.robot.joints[static_cast<std::size_t>(j.joint)].name);
  if (options.marker_in_tcp) {
    arm.marker_in_tcp = *options.marker_in_tcp;
  } else {
    const Fit fitted = fit(session);
    arm.marker_in_tcp = estimate(fitted).markers_in_tcp[static_cast<std::size_t>(options.marker)];
    arm.mount_from_sensor = estimate(fitted).mount_from_sensor;
  }
  for (const Observation& o : session.observations) {
    if (!is_used(o)) continue;
    const auto measured = measured_marker(session, o, options.marker);
    if (!measured) {
      result.left_out.push_back(o.id);
      continue;
    }
    EffectiveMass mass = pull(arm, joint_values(chain.robot, chain.joints, o.position), *measured);
    mass.id = o.id;
    result.observations.push_back(mass);
  }
  if (result.observations.empty())
    throw InputError(message("{}: no used observation shows marker {} as a point; label it in both images first.",
                             session.file.filename().string(), options.marker));
  return result;
}

}  // namespace handsight
