// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/session_check.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

/// A session whose measured torques are `of` the moments of gravity.
Session with_torques(double (*of)(double)) {
  SimulationOptions options;
  options.observations = 20;
  Session session = simulate_session(fixture::stand_session(), options).session;
  for (Observation& o : session.observations) {
    const Posture posture = solve_posture(
        session.robot, joint_values(session.robot, make_chain(session).joints, o.position), session.gravity);
    o.torque.resize(o.position.size());
    for (Eigen::Index j = 0; j < o.torque.size(); ++j) o.torque[j] = of(posture.torque[static_cast<std::size_t>(j)]);
  }
  return session;
}

TEST(CheckSession, TorquesOfEitherSignAreGravitys) {
  EXPECT_TRUE(check_session(with_torques([](double gravity) { return gravity; })).warnings.empty());
  EXPECT_TRUE(check_session(with_torques([](double gravity) { return -gravity; })).warnings.empty());
}

TEST(CheckSession, TorquesWithoutASignAreNotGravitys) {
  const auto warnings = check_session(with_torques([](double gravity) { return std::abs(gravity); })).warnings;
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("measured torques"), std::string::npos);
}

/// Where the sensor sits is asked for, and the recorder wrote one pose again and again.
TEST(CheckSession, RefusesAHandThatNeverMoved) {
  Session session = simulate_session(fixture::stand_session(), {.observations = 6, .seed = 5}).session;
  session.mount.estimate = true;
  EXPECT_TRUE(check_session(session).problems.empty());
  for (Observation& o : session.observations) o.position = session.observations.front().position;
  const auto problems = check_session(session).problems;
  ASSERT_EQ(problems.size(), 1);
  EXPECT_NE(problems[0].find("one and the same pose"), std::string::npos);
  session.mount.estimate = false;
  EXPECT_TRUE(check_session(session).problems.empty());
}

/// The same as the window and `convert` say.
TEST(CheckSession, TellsWhatIsDoubtful) {
  Session session = simulate_session(fixture::stand_session(), {.observations = 12, .seed = 5}).session;
  for (Camera* camera : {&session.rig->at(0).camera, &session.rig->at(1).camera})
    std::swap(camera->width, camera->height);
  for (Link& link : session.robot.links) link.mass = 0;
  std::string all;
  for (const Message& warning : check_session(session).warnings) all += warning.english() + '\n';
  EXPECT_NE(all.find("are width and height of the cameras swapped?"), std::string::npos) << all;
  EXPECT_NE(all.find("No link of the robot has a mass"), std::string::npos) << all;
}

}  // namespace
}  // namespace handsight
