// SPDX-License-Identifier: Apache-2.0
// What a URDF cannot hold is fitted again without it: the file is the best robot of rigid links, and says what it
// misses.
#include "export/rigid/rigid_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "export/exported.h"
#include "export/rigid/held_sites.h"
#include "export/rigid/urdf_file.h"
#include "fixtures/exported_robots.h"

namespace handsight {
namespace {

/// How far a URDF's hand is from where the whole calibration has it, m, rms over these poses.
double missed_by(const CalibratedRobot& robot, const UrdfFile& file, const std::vector<Eigen::VectorXd>& positions) {
  const Robot read = parse_urdf(file.text, "calibrated.urdf", nullptr);
  const CalibratedRobot hand = with_moved_hand(robot);
  double squares = 0;
  for (const Eigen::VectorXd& p : positions) {
    const Rigid wanted = predict_tcp(hand.chain, p, hand.model).root_from_tcp_est;
    const Rigid found = fixture::look_up_link(read, fixture::values_in(read, robot.joint_names, p), file.hand_link);
    squares += (wanted.translation - found.translation).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(positions.size()));
}

std::vector<Eigen::VectorXd> fresh_poses(const CalibratedRobot& robot, std::mt19937_64& random) {
  std::vector<Eigen::VectorXd> poses;
  for (int i = 0; i < 60; ++i) poses.push_back(fixture::random_position(robot.chain, random, 0.9));
  return poses;
}

/// The URDF with what it can hold of the model as it stands: what was written before anything was fitted again.
CalibratedRobot without_rest(CalibratedRobot robot) {
  std::erase_if(robot.model.effects,
                [](const EffectTerm& t) { return t.id != "joint_offset" && t.id != "link_geometry"; });
  for (Joint& j : robot.chain.robot.joints) j.stiffness = 0;
  return robot;
}

TEST(RigidFit, IsBetterThanWhatIsLeftOfTheModelOnMeasuredPosesAndOnFreshOnes) {
  std::mt19937_64 random(3);
  for (const Session& session : {fixture::stand_session(), fixture::seven_axis_session()}) {
    const CalibratedRobot robot =
        fixture::exported_robot(session, fixture::unsayable_terms(make_chain(session)), random, 40);
    const UrdfFile best = urdf_file(robot), rest = urdf_file(without_rest(robot));
    const auto fresh = fresh_poses(robot, random);
    EXPECT_LT(missed_by(robot, best, robot.positions), 0.5 * missed_by(robot, rest, robot.positions));
    EXPECT_LT(missed_by(robot, best, fresh), 0.6 * missed_by(robot, rest, fresh));
  }
}

TEST(RigidFit, TellsWhatTheFileMisses) {
  std::mt19937_64 random(5);
  const Session session = fixture::seven_axis_session();
  const CalibratedRobot robot =
      fixture::exported_robot(session, fixture::unsayable_terms(make_chain(session)), random, 25);
  const UrdfFile file = urdf_file(robot);
  const double missed = missed_by(robot, file, robot.positions);
  EXPECT_GT(missed, 1e-5);
  EXPECT_NEAR(file.fit.left.rms, missed, 1e-9);
  EXPECT_GE(file.fit.left.largest, file.fit.left.rms);
  EXPECT_EQ(file.fit.poses, 25);
  EXPECT_NE(file.text.find(fmt::format("{:.3f} mm rms", 1e3 * missed)), std::string::npos);
  const ExportedFile reported = exported_file(robot, "urdf");
  ASSERT_TRUE(reported.left);
  EXPECT_NEAR(*reported.left, missed, 1e-9);
  EXPECT_EQ(file.text.find("<stiffness"), std::string::npos) << "the springs are in the origins now";
}

/// No origin that is moved a little makes the hand better over the poses that it was fitted to.
TEST(RigidFit, IsTheBest) {
  std::mt19937_64 random(7);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot =
      fixture::exported_robot(session, fixture::unsayable_terms(make_chain(session)), random, 120);
  const RigidFit fit = rigid_fit(robot);
  for (std::size_t j = 0; j < fit.change.joints.size(); ++j)
    for (int n = 0; n < 6; ++n)
      for (const double by : {-1e-4, 1e-4}) {
        RobotChange other = fit.change;
        other.joints[j].frame[n] += by;
        EXPECT_GT(missed_with(robot, other).rms, 0.98 * fit.left.rms) << j << " " << n;
      }
}

TEST(RigidFit, LeavesTheModelsOwnNumbersWhereNothingIsLeftOut) {
  std::mt19937_64 random(9);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot =
      fixture::exported_robot(session, fixture::sayable_terms(make_chain(session), random), random, 20);
  const RigidFit fit = rigid_fit(robot);
  EXPECT_TRUE(fit.left_out.empty());
  EXPECT_LT(fit.left.largest, 1e-12);
  const HeldSites held = held_sites(robot);
  for (std::size_t j = 0; j < fit.change.joints.size(); ++j) {
    EXPECT_EQ(fit.change.joints[j].frame, held.sites.robot.joints[j].frame);
    EXPECT_EQ(fit.change.joints[j].angle, held.sites.robot.joints[j].angle);
  }
}

TEST(RigidFit, OffsetsAloneAreTheBestOffsets) {
  std::mt19937_64 random(11);
  const Session session = fixture::stand_session();
  std::vector<EffectTerm> terms = fixture::unsayable_terms(make_chain(session));
  terms.push_back({"link_geometry", make_chain(session).joints[2], {1e-3, 1e-3, 3e-3, -4e-3}});
  const CalibratedRobot robot = fixture::exported_robot(session, terms, random, 60);
  const RigidFit offsets = rigid_fit(robot, Holds::offsets), origins = rigid_fit(robot);
  EXPECT_LT(origins.left.rms, offsets.left.rms);
  EXPECT_LT(offsets.left.rms, offsets.nominal.rms);
  RobotChange held = offsets.change;
  for (std::size_t j = 0; j < held.joints.size(); ++j) {
    EXPECT_TRUE(held.joints[j].frame.isZero(0));
    for (const double by : {-2e-4, 2e-4}) {
      RobotChange other = held;
      other.joints[j].angle += by;
      EXPECT_GT(missed_with(robot, other).rms, 0.98 * offsets.left.rms) << j;
    }
  }
}

/// A camera on the hand: the hand is the link that carries it.
TEST(RigidFit, OfASensorOnTheHandIsOfTheHand) {
  std::mt19937_64 random(13);
  Session session = fixture::seven_axis_session();
  std::swap(session.tcp, session.mount.link);
  session.mount.estimate = true;
  CalibratedRobot robot = fixture::exported_robot(session, fixture::unsayable_terms(make_chain(session)), random, 40);
  std::erase_if(robot.model.effects, [](const EffectTerm& t) { return t.id == "payload"; });
  robot.of_hand = robot.model;
  robot.of_hand->mount_from_sensor = robot.model.tcp_from_body;
  robot.of_hand->tcp_from_body = *robot.model.mount_from_sensor;
  const UrdfFile file = urdf_file(robot);
  EXPECT_NEAR(file.fit.left.rms, missed_by(robot, file, robot.positions), 1e-9);
  EXPECT_LT(file.fit.left.rms, 0.5 * missed_by(robot, urdf_file(without_rest(robot)), robot.positions));
}

/// Without poses they are drawn within the limits, and the file says so.
TEST(RigidFit, KnowsWhereItIsFittedBlindly) {
  std::mt19937_64 random(15);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot = fixture::exported_robot(session, fixture::unsayable_terms(make_chain(session)), random);
  const RigidFit fit = rigid_fit(robot);
  EXPECT_FALSE(fit.are_measured);
  EXPECT_NE(missed_text(fit).find("drawn within the joints' limits"), std::string::npos);
}

}  // namespace
}  // namespace handsight
