// SPDX-License-Identifier: Apache-2.0
// Corrected joint angles bring the modelled hand where it was meant to be; limits hold; files correct as the core does.
#include "correct/correction.h"

#include <gtest/gtest.h>

#include "export/exported.h"
#include "fixtures/robots_with_everything.h"

namespace handsight {
namespace {

Vector6 off(const Chain& chain, const Eigen::VectorXd& commanded, const PredictionModel& model, const Rigid& wanted) {
  const Rigid hand = predict_tcp(chain, commanded, model).root_from_tcp_est;
  Vector6 way;
  way << hand.translation - wanted.translation, vector_from_rotation(hand.rotation * wanted.rotation.transpose());
  return way;
}

/// No stretched arm and no wrist in line, where a small way of the hand is a long way of the joints.
Eigen::VectorXd bent_pose(const Chain& chain, std::mt19937_64& random) {
  return fixture::random_position(chain, random, 0.3).array() + 0.6;
}

TEST(Correction, BringsTheHandWhereTheNominalModelPutsIt) {
  std::mt19937_64 random(3);
  for (const Session& session : {fixture::stand_session(), fixture::seven_axis_session(3)}) {
    const CalibratedRobot robot =
        fixture::robot_with(session, fixture::everything_wrong(make_chain(session), random), random);
    for (int i = 0; i < 10; ++i) {
      const Eigen::VectorXd pose = bent_pose(robot.chain, random);
      const ObservationState commanded = states_at(robot.chain, pose);
      const Rigid wanted = predict_tcp(robot.chain, pose, robot.model).root_from_tcp;
      const Correction c = corrected(commanded, robot.model);
      EXPECT_GT(c.error_before_m, 1e-4);
      EXPECT_NEAR(c.error_before_m, off(robot.chain, pose, robot.model, wanted).head<3>().norm(), 1e-12);
      ASSERT_TRUE(c.reached) << session.robot.name << " " << i;
      EXPECT_LT(off(robot.chain, c.position, robot.model, wanted).norm(), 1e-8);
      EXPECT_LT(c.iterations, 12) << "Newton, not a crawl";
      EXPECT_LT((c.position - pose).norm(), 0.3);
    }
  }
}

TEST(Correction, ArrivesOrComesNearerFromAnywhere) {
  std::mt19937_64 random(33);
  const Session session = fixture::stand_session();
  const CalibratedRobot robot =
      fixture::robot_with(session, fixture::everything_wrong(make_chain(session), random), random);
  int reached = 0;
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd pose = fixture::random_position(robot.chain, random);
    const Correction c = corrected(states_at(robot.chain, pose), robot.model);
    EXPECT_LE(c.error_after_m, c.error_before_m + 0.3 * c.error_before_rad);
    reached += c.reached;
  }
  EXPECT_GE(reached, 95) << "of 100; a wrist in line may have no way";
}

TEST(Correction, FindsATargetAndTakesTheShortestWayOfManyJoints) {
  std::mt19937_64 random(4);
  const Session session = fixture::seven_axis_session(3);
  const CalibratedRobot robot = fixture::robot_with(session, {{"joint_offset", 2, {0.01}}}, random);
  const Eigen::VectorXd here = Eigen::VectorXd::Constant(7, 0.4), there = Eigen::VectorXd::Constant(7, 0.7);
  const Rigid target = predict_tcp(robot.chain, there, robot.model).root_from_tcp_est;
  const Correction c = corrected(states_at(robot.chain, here), robot.model, target);
  ASSERT_TRUE(c.reached);
  EXPECT_LT(small_motion_between(target, predict_tcp(robot.chain, c.position, robot.model).root_from_tcp_est).norm(),
            1e-8);
  EXPECT_LE((c.position - here).norm(), (there - here).norm() * 1.05) << "no longer way than the one that is known";
}

TEST(Correction, RespectsLimitsAndSaysWhatCannotBeReached) {
  std::mt19937_64 random(5);
  Session session = fixture::stand_session();
  session.robot.joints[1].upper = 0.5;
  const CalibratedRobot robot = fixture::robot_with(session, {{"joint_offset", 1, {-0.02}}}, random);
  Eigen::VectorXd pose = Eigen::VectorXd::Constant(6, 0.3);
  pose[1] = 0.499;  // to correct it the joint would have to go beyond its limit, and six joints have no other way
  const Correction stopped = corrected(states_at(robot.chain, pose), robot.model);
  EXPECT_FALSE(stopped.reached);
  EXPECT_EQ(stopped.position[1], 0.5);
  EXPECT_EQ(stopped.at_limit, std::vector<int>{1});
  EXPECT_LT(stopped.error_after_m, stopped.error_before_m);
  Rigid far;
  far.translation = {5, 0, 0};
  const Correction out = corrected(states_at(robot.chain, pose), robot.model, far);
  EXPECT_FALSE(out.reached);
  EXPECT_TRUE(out.position.allFinite());
  for (int i = 0; i < 6; ++i) {
    EXPECT_LE(out.position[i], robot.chain.robot.joints[static_cast<std::size_t>(i)].upper);
    EXPECT_GE(out.position[i], robot.chain.robot.joints[static_cast<std::size_t>(i)].lower);
  }
}

TEST(Correction, FewerThanSixJointsComeAsNearAsTheyCan) {
  std::mt19937_64 random(6);
  const Session session = fixture::torso_with_all_kinds();
  const CalibratedRobot robot = fixture::robot_with(session, {{"joint_offset", 1, {0.01}}}, random);
  const Correction c = corrected(states_at(robot.chain, Eigen::VectorXd::Constant(4, 0.3)), robot.model);
  EXPECT_TRUE(c.reached) << "an offset of a joint of its own can be taken back";
  Rigid target = predict_tcp(robot.chain, Eigen::VectorXd::Constant(4, 0.3), robot.model).root_from_tcp;
  target.translation += Vector3(0.01, 0.02, 0.03);
  const Correction near = corrected(states_at(robot.chain, Eigen::VectorXd::Constant(4, 0.3)), robot.model, target);
  EXPECT_FALSE(near.reached);
  EXPECT_LT(near.error_after_m, near.error_before_m);
}

TEST(Correction, FilesCommandWhatTheCoreCommands) {
  std::mt19937_64 random(7);
  for (const Session& session : {fixture::stand_session(), fixture::seven_axis_session(3)}) {
    const CalibratedRobot robot =
        fixture::robot_with(session, fixture::everything_wrong(make_chain(session), random), random);
    std::vector<Eigen::VectorXd> poses;
    for (int i = 0; i < 5; ++i) poses.push_back(bent_pose(robot.chain, random));
    const TemporaryFolder folder;
    std::ofstream(folder.path / "hand.cpp") << exported_file(robot, "cpp").text;
    std::ofstream(folder.path / "hand.py") << exported_file(robot, "python").text;
    ASSERT_EQ(fixture::compiled(folder.path / "hand.cpp", folder.path / "hand"), "");
    for (const std::string& command : {"'" + (folder.path / "hand").string() + "' correct",
                                       "python3 '" + (folder.path / "hand.py").string() + "' correct"}) {
      const std::vector<fixture::Answer> found = fixture::answers(folder.path, command, poses);
      ASSERT_EQ(found.size(), poses.size()) << command << fixture::text_of_file(folder.path / "errors.txt");
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const Correction c = corrected(states_at(robot.chain, poses[i]), robot.model);
        EXPECT_EQ(found[i].word, c.reached ? "good" : "bad");
        const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(found[i].numbers.data(),
                                                                    static_cast<Eigen::Index>(found[i].numbers.size()));
        const Rigid wanted = predict_tcp(robot.chain, poses[i], robot.model).root_from_tcp;
        EXPECT_LT(off(robot.chain, q, robot.model, wanted).norm(), 1e-8) << command;
        EXPECT_LT((q - c.position).cwiseAbs().maxCoeff(), 1e-3) << command;  // of seven joints one is free
      }
    }
  }
}

TEST(CorrectionGain, IsWhatTheModelSays) {
  std::mt19937_64 random(8);
  const Session session = fixture::stand_session();
  CalibratedRobot robot = fixture::robot_with(session, {{"joint_offset", 1, {0.01}}}, random);
  robot.model.covariance = Eigen::MatrixXd::Zero(7, 7);
  robot.model.covariance.topLeftCorner<3, 3>() = 1e-8 * Matrix3::Identity();  // 0.1 mm an axis
  std::vector<Eigen::VectorXd> measured;
  for (int i = 0; i < 20; ++i) measured.push_back(fixture::random_position(robot.chain, random));
  const CorrectionGain gain = correction_gain(robot.chain, robot.model, measured, 300, 1);
  ASSERT_EQ(gain.before.size(), 300u);
  EXPECT_EQ(gain.not_reached, 0);
  EXPECT_GT(gain.median_before, 1e-3);                              // 0.01 rad at half a metre
  EXPECT_NEAR(gain.median_after, 1e-4 * std::sqrt(2.366), 0.1e-4);  // median of chi-squared with 3 degrees
  EXPECT_TRUE(correction_gain(robot.chain, robot.model, {}, 300, 1).before.empty());
}

}  // namespace
}  // namespace handsight
