// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/experiment.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "experiment/simulated/simulated_robot.h"
#include "fixtures/arms.h"
#include "fixtures/targets.h"

namespace handsight {
namespace {

using testing::HasSubstr;

/// A start of a few observations as this robot with its truth makes them, in memory.
Session rough_start(const Session& like, const SimulationOptions& truth, int observations) {
  SimulationOptions options = truth;
  options.observations = observations;
  return simulate_session(like, options).session;
}

ExperimentOptions in_memory(const std::string& until) {
  ExperimentOptions options;
  options.save = false;
  add_goals(until, options.until);
  return options;
}

SimulationOptions load_truth(const Session& like, const std::string& effect, std::uint64_t seed = 11) {
  SimulationOptions truth;
  truth.seed = seed;
  if (!effect.empty()) add_effect_value(effect, like.robot, truth.effects);
  return truth;
}

struct Experiments : testing::Test {
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
  }
};

TEST_F(Experiments, AHiddenCauseIsNamedAndItSaysWhyItEnds) {
  const Session like = fixture::stand_session();
  const SimulationOptions truth = load_truth(like, "joint_offset:a3.offset=0.004");
  SimulatedRobot robot(like, {.truth = truth});
  const ExperimentResult result = run_experiment(rough_start(like, truth, 2), robot, in_memory("odds=20|count=45"));
  EXPECT_EQ(result.end, ExperimentEnd::reached) << result.reason;
  ASSERT_TRUE(result.settled);
  EXPECT_EQ(result.settled->id, "joint_offset");
  EXPECT_THAT(result.settled->where, testing::ElementsAre("a3"));
  EXPECT_GE(result.settled->odds, 20);
  EXPECT_THAT(result.reason, HasSubstr("What is missing: Joint offset of a3,"));
  EXPECT_THAT(result.more, HasSubstr("One more hour"));
  EXPECT_LE(result.observations, 40);
}

TEST_F(Experiments, WhatHasNoNameIsSettledToo) {
  const Session like = fixture::stand_session();
  SimulationOptions truth = load_truth(like, "");
  truth.curves.push_back({make_chain(like).joints[2], 4e-3, false, 3.3});
  SimulatedRobot robot(like, {.truth = truth});
  const ExperimentResult result = run_experiment(rough_start(like, truth, 2), robot, in_memory("odds=20|count=60"));
  EXPECT_EQ(result.end, ExperimentEnd::reached) << result.reason;
  ASSERT_TRUE(result.settled);
  EXPECT_EQ(result.settled->id, "");
  ASSERT_TRUE(result.settled->follows);
  EXPECT_GE(result.settled->odds, 20);
  EXPECT_THAT(result.reason, HasSubstr("What is missing follows the "));
  EXPECT_THAT(result.reason, HasSubstr("in a form that is not in the catalogue, by odds of"));
}

/// Two looks of a camera on the hand say badly where the board lies: all ten poses that were chosen by them showed
/// nothing, and the experiment ended.
TEST_F(Experiments, WhereNothingIsSeenItGoesInSmallStepsFromWhereSomethingWas) {
  Session like = fixture::eye_in_hand_session();
  like.mount.estimate = true;
  like.sigma_pixel.reset();
  SimulationOptions truth;
  truth.seed = 8317;
  truth.noise = 0.2;
  SimulatedRobot robot(like, {.truth = truth});
  const ExperimentResult result = run_experiment(rough_start(like, truth, 2), robot, in_memory("odds=20|count=16"));
  EXPECT_EQ(result.end, ExperimentEnd::count) << result.reason;
  EXPECT_GE(result.accepted, 8);
  const auto is_near = [](const ExperimentStep& s) { return s.move.pose.reason == PoseReason::near_seen; };
  const auto first = std::find_if(result.steps.begin(), result.steps.end(), is_near);
  ASSERT_NE(first, result.steps.end());
  EXPECT_GE(first - result.steps.begin(), 2) << "only after two in vain";
  EXPECT_FALSE((first - 1)->accepted);
  EXPECT_FALSE((first - 2)->accepted);
}

TEST_F(Experiments, TheHandIsKnownAsWellAsItWasAskedFor) {
  const Session like = fixture::tracker_session();
  const SimulationOptions truth = load_truth(like, "");
  SimulatedRobot robot(like, {.truth = truth});
  const ExperimentResult result = run_experiment(rough_start(like, truth, 1), robot, in_memory("hand=0.2mm|count=60"));
  EXPECT_EQ(result.end, ExperimentEnd::reached) << result.reason;
  ASSERT_TRUE(result.known.hand_limit);
  EXPECT_LE(*result.known.hand_limit, 2e-4);
  // It is true: the body's place against where it was put.
  const Vector3 middle = (robot.simulated().markers_in_tcp[0] + robot.simulated().markers_in_tcp[1] +
                          robot.simulated().markers_in_tcp[2]) /
                         3;
  EXPECT_LT((result.known.fit->tcp_from_body.translation - middle).norm(), 2e-4);
}

TEST_F(Experiments, ACountEndsItAndNoPoseIsFartherThanTheLimitsLet) {
  const Session like = fixture::seven_axis_session();
  const SimulationOptions truth = load_truth(like, "");
  SimulatedRobot robot(like, {.truth = truth});
  int slow = 0;
  ExperimentOptions options = in_memory("count=12");
  options.on_step = [&](const ExperimentStep&) { ++slow; };
  const ExperimentResult result = run_experiment(rough_start(like, truth, 2), robot, options);
  EXPECT_EQ(result.end, ExperimentEnd::count);
  EXPECT_EQ(result.observations, 12);
  EXPECT_EQ(result.session.observations.size(), 14U);
  EXPECT_GE(slow, 12);
  EXPECT_GE(result.accepted, 10);
  const Chain chain = make_chain(like);
  for (const Observation& o : result.session.observations)
    for (Eigen::Index j = 0; j < o.position.size(); ++j) {
      const Joint& joint = chain.robot.joints[static_cast<std::size_t>(chain.joints[static_cast<std::size_t>(j)])];
      EXPECT_GT(o.position[j], joint.lower);
      EXPECT_LT(o.position[j], joint.upper);
    }
}

/// Records what it is given.
struct Recorder : SimulatedRobot {
  using SimulatedRobot::SimulatedRobot;
  MoveAnswer move(const std::vector<Eigen::VectorXd>& path, double speed) override {
    speeds.push_back(speed);
    ends.push_back(path.back());
    if (static_cast<int>(speeds.size()) == refused_at) return {.why = "the elbow would hit the table"};
    MoveAnswer answer = SimulatedRobot::move(path, speed);
    if (static_cast<int>(speeds.size()) == wrong_at) answer.position[1] += wrong_by;
    return answer;
  }
  void stop() noexcept override { ++stops; }
  std::vector<double> speeds;
  std::vector<Eigen::VectorXd> ends;
  int stops = 0, wrong_at = -1, refused_at = -1;
  double wrong_by = 0;
};

TEST_F(Experiments, TheFirstMoveIsSlow) {
  const Session like = fixture::tracker_session();
  Recorder robot(like, {.truth = load_truth(like, "")});
  run_experiment(rough_start(like, load_truth(like, ""), 2), robot, in_memory("count=4"));
  ASSERT_EQ(robot.speeds.size(), 4U);
  EXPECT_DOUBLE_EQ(robot.speeds[0], 0.02);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_DOUBLE_EQ(robot.speeds[i], 0.2);
}

TEST_F(Experiments, ARobotThatStandsMoreThanADegreeElsewhereIsStopped) {
  const Session like = fixture::tracker_session();
  for (const double by : {0.016, 0.019}) {
    Recorder robot(like, {.truth = load_truth(like, "")});
    robot.wrong_at = 2;
    robot.wrong_by = by;
    const ExperimentResult result =
        run_experiment(rough_start(like, load_truth(like, ""), 2), robot, in_memory("count=4"));
    EXPECT_EQ(result.end, by > M_PI / 180 ? ExperimentEnd::fault : ExperimentEnd::count) << result.reason;
    EXPECT_EQ(robot.stops, by > M_PI / 180 ? 1 : 0);
    EXPECT_EQ(result.session.observations.size(), by > M_PI / 180 ? 3U : 6U);
  }
}

TEST_F(Experiments, APoseThatIsRefusedIsNotAskedForAgainNorAnyBesideIt) {
  const Session like = fixture::tracker_session();
  Recorder robot(like, {.truth = load_truth(like, "")});
  robot.refused_at = 2;
  const ExperimentResult result =
      run_experiment(rough_start(like, load_truth(like, ""), 2), robot, in_memory("count=24"));
  EXPECT_EQ(result.observations, 24);
  ASSERT_EQ(robot.ends.size(), 25U);
  // Those that were chosen with it are on their way already.
  for (std::size_t i = 6; i < robot.ends.size(); ++i)
    EXPECT_GE((robot.ends[i] - robot.ends[1]).cwiseAbs().maxCoeff(), 0.15) << i;
}

TEST_F(Experiments, WithoutAWordNothingMoves) {
  const Session like = fixture::tracker_session();
  Recorder robot(like, {.truth = load_truth(like, "")});
  ExperimentOptions options = in_memory("count=4");
  options.confirm = [](const std::vector<PlannedMove>& moves) {
    EXPECT_FALSE(moves.empty());
    return false;
  };
  const ExperimentResult result = run_experiment(rough_start(like, load_truth(like, ""), 2), robot, options);
  EXPECT_EQ(result.end, ExperimentEnd::not_confirmed);
  EXPECT_TRUE(robot.speeds.empty());
}

TEST_F(Experiments, ADriverOfOtherJointsIsRefused) {
  const Session like = fixture::tracker_session();
  Session other = like;
  other.joints = {"a1", "a2", "a3", "a4", "a5"};
  other.observations[0].position.conservativeResize(5);
  SimulatedRobot robot(other, {.truth = load_truth(like, "")});
  const ExperimentResult result =
      run_experiment(rough_start(like, load_truth(like, ""), 2), robot, in_memory("count=4"));
  EXPECT_EQ(result.end, ExperimentEnd::fault);
  EXPECT_THAT(result.reason, HasSubstr("not those of the session"));
}

}  // namespace
}  // namespace handsight
