// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/one_marker.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

/// Six poses, everything measured nearer along the camera's z (thesis section 5.1).
SimulatedSession thesis_like(double shift) {
  SimulationOptions options;
  options.noise = 0;
  options.observations = 6;
  options.shift_in_sensor = {0, 0, -shift};
  return simulate_session(fixture::stand_session(), options);
}

TEST(EffectiveMass, LeavesWhatTheAngleToTheReachableDirectionPredicts) {
  // The angle speaks of the first order: at 1 mm the marker's path is straight to 1 %, at 1 cm the circles that it
  // moves on (0.3 m and more) bend it by s^2 / 2 R, up to 2 % of the deviation.
  for (const double shift : {0.001, 0.01}) {
    const SimulatedSession s = thesis_like(shift);
    const OneMarkerResult r = effective_masses(s.session, {.marker_in_tcp = s.markers_in_tcp[0]});
    ASSERT_EQ(r.observations.size(), 6u);
    for (const EffectiveMass& m : r.observations) {
      EXPECT_NEAR(m.before.z(), shift, 1e-9);  // commanded minus measured
      EXPECT_LE(m.after.norm(), m.before.norm());
      EXPECT_NEAR(m.after.norm(), m.predicted_after, (shift < 0.002 ? 0.01 : 0.02) * m.before.norm());
    }
  }
}

TEST(EffectiveMass, FindsAWeightThatHangsOnTheHand) {
  // A force along the deviation that the springs really make: 2 kg pulling down at the marker, seen from a robot whose
  // only spring moves the marker straight down.
  Session like = fixture::stand_session(1);
  for (Joint& joint : like.robot.joints) joint.stiffness = 0;
  like.robot.joints[1].stiffness = 5000;
  for (std::size_t j = 2; j < 6; ++j) like.robot.joints[j].kind = JointKind::fixed;
  like.robot.joints[0].kind = JointKind::fixed;
  like.joints = {"a2"};
  for (Link& link : like.robot.links) link.mass = 0;
  Observation o;
  o.position = Eigen::VectorXd::Constant(1, 0.9);
  const Vector3 marker(0.02, 0, 0.01);
  const Chain chain = make_chain(like);
  const Rigid sensor = like.mount.mount_from_sensor;
  const Vector3 commanded = chain_ends(chain, o.position).root_from_tcp * marker;
  // The marker moves on a circle about a2: perpendicular to its arm, by lever^2 * force / stiffness.
  const Vector3 arm = commanded - Vector3(0.05, 0, 0.4);
  const Vector3 tangent = Vector3(0, 1, 0).cross(arm).normalized();
  const double force = 2 * 9.81;
  const double sag = arm.squaredNorm() * force / 5000;
  const Vector3 measured = inverse(sensor) * Vector3(commanded + sag * tangent);
  o.sightings = {seen_at(0, project(like.rig->at(0).camera, measured),
                         project(like.rig->at(1).camera, Vector3(like.rig->at(1).camera_from_first * measured)))};
  like.observations = {o};
  const OneMarkerResult r = effective_masses(like, {.marker_in_tcp = marker});
  ASSERT_EQ(r.observations.size(), 1u);
  EXPECT_NEAR(std::abs(r.observations[0].mass), 2, 0.03);
  EXPECT_LT(r.observations[0].after.norm(), 1e-3 * sag + 2e-6);
  EXPECT_EQ(r.joints, std::vector<std::string>{"a2"});
  EXPECT_FALSE(r.stiffness_is_assumed);
}

TEST(EffectiveMass, RefusesAMarkerThatDoesNotExist) {
  EXPECT_THROW(effective_masses(thesis_like(0.01).session, {.marker = 3}), InputError);
}

}  // namespace
}  // namespace handsight
