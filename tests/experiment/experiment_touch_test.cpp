// SPDX-License-Identifier: Apache-2.0
// Experiments of touches: the plan says which posture on which fixture, the robot feels for it.
#include <gmock/gmock.h>

#include <set>

#include "cli/cli_runner.h"
#include "experiment/driver/driver_messages.h"
#include "experiment/loop/experiment.h"
#include "experiment/simulated/simulated_robot.h"
#include "experiment/written_session.h"
#include "fixtures/touch_session.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

/// Plates and sockets before a six-axis arm, touched a few times by a robot with this truth.
struct Workshop {
  explicit Workshop(const std::string& effect, int touches = 20) : like(fixture::probe_session()) {
    fixture::add_plates(like);
    fixture::add_sockets(like);
    truth.seed = 4;
    if (!effect.empty()) add_effect_value(effect, like.robot, truth.effects);
    truth.observations = touches;
    const SimulatedSession made = simulate_session(like, truth);
    start = made.session;
    truth.markers_in_tcp = made.markers_in_tcp;
  }
  Session like, start;
  SimulationOptions truth;
};

ExperimentOptions touched_in_memory(const std::string& until) {
  ExperimentOptions options;
  options.save = false;
  add_goals(until, options.until);
  return options;
}

struct TouchExperiments : testing::Test {
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
  }
};

TEST_F(TouchExperiments, AHiddenZeroIsNamedFromTouches) {
  const Workshop workshop("joint_offset:a3.offset=0.003");
  SimulatedRobot robot(workshop.start, {.truth = workshop.truth});
  const ExperimentResult result = run_experiment(workshop.start, robot, touched_in_memory("odds=20|count=60"));
  EXPECT_EQ(result.end, ExperimentEnd::reached) << result.reason;
  ASSERT_TRUE(result.settled);
  EXPECT_EQ(result.settled->id, "joint_offset");
  EXPECT_THAT(result.settled->where, testing::ElementsAre("a3"));
  EXPECT_EQ(result.accepted, result.observations);
}

TEST_F(TouchExperiments, EachTouchBeginsBeforeItsFixtureAndThePlanChoosesAmongThem) {
  const Workshop workshop("");
  SimulatedRobot robot(workshop.start, {.truth = workshop.truth});
  const ExperimentResult result = run_experiment(workshop.start, robot, touched_in_memory("count=20"));
  EXPECT_EQ(result.end, ExperimentEnd::count) << result.reason;
  EXPECT_EQ(result.observations, 20);
  EXPECT_EQ(result.accepted, 20);
  std::set<int> fixtures;
  for (const ExperimentStep& step : result.steps) {
    fixtures.insert(step.move.pose.fixture);
    EXPECT_EQ(step.move.way.back(), step.move.pose.position);
    EXPECT_GT((step.move.pose.touching - step.move.pose.position).norm(), 1e-3) << "it stands before the fixture";
  }
  EXPECT_GE(fixtures.size(), 2U);
  EXPECT_EQ(fixtures.count(-1), 0U);
  // What was touched fits to the noise of a touch.
  const Fit f = fit(result.session);
  EXPECT_LT(f.residual_rms, 3e-5);
}

TEST_F(TouchExperiments, ATouchOfSomethingElseIsRejectedAndAnotherFixtureEndsIt) {
  const Workshop workshop("");
  struct Liar : SimulatedRobot {
    using SimulatedRobot::SimulatedRobot;
    TouchAnswer touch(const TouchRequest& request) override {
      TouchAnswer answer = SimulatedRobot::touch(request);
      if (++touches == 2) answer.position[1] += 0.05;  // rad: centimetres from the fixture
      if (touches == 6) answer.fixture = "the_vice";
      return answer;
    }
    int touches = 0;
  } robot(workshop.start, {.truth = workshop.truth});
  const ExperimentResult result = run_experiment(workshop.start, robot, touched_in_memory("count=20"));
  EXPECT_EQ(result.end, ExperimentEnd::fault);
  EXPECT_THAT(result.reason.english(), HasSubstr("the_vice"));
  EXPECT_EQ(result.observations, 5);
  EXPECT_EQ(result.accepted, 4);
  EXPECT_THAT(result.steps[1].reason.english(), HasSubstr("where the touched fixture must be"));
}

TEST_F(TouchExperiments, BeginsWhereTouchesCanBeFitted) {
  Workshop workshop("", 10);
  fixture::forget_places(workshop.start);
  workshop.start.observations.resize(1);
  SimulatedRobot robot(workshop.start, {.truth = workshop.truth});
  EXPECT_THROW(run_experiment(workshop.start, robot, touched_in_memory("count=20")), InputError);
}

/// The whole way through a driver's process, and everything on disk.
TEST_F(TouchExperiments, ADriversTouchesAreInTheSession) {
  const TemporaryFolder folder;
  const Workshop workshop("");
  const std::filesystem::path session = fixture::written_session(workshop.like, folder.path, 20, 4);
  const std::string driver = HANDSIGHT_BINARY_DIR "/app/cli/handsight-driver-simulated ";
  const auto run = [&](const std::string& options, const std::string& until) {
    return test::run_cli(folder.path, {"experiment", session.string(), "--driver",
                                       driver + test::quoted_argument(session.string()) + options, "--yes", "--until",
                                       until, "--json", "-"});
  };
  const auto result = run("", "count=6");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto json = result.json();
  EXPECT_EQ(json["accepted"], 6);
  EXPECT_TRUE(json["steps"][0].contains("fixture"));
  const Session after = read_session(session);
  ASSERT_EQ(after.observations.size(), 26U);
  EXPECT_EQ(after.fixtures[static_cast<std::size_t>(after.observations[20].part)].id, json["steps"][0]["fixture"]);
  const auto blind = run(" --fault blind@2", "count=30");
  EXPECT_EQ(blind.exit_code, 2);
  EXPECT_THAT(blind.errors, HasSubstr("the probe is off"));
}

TEST(DriverMessages, TouchesAreReadBack) {
  Eigen::VectorXd q(2);
  q << 0.25, -1.0 / 3;
  const DriverRequest asked = driver_request(touch_line(3, {"plate", q}));
  EXPECT_EQ(asked.what, "look");
  ASSERT_TRUE(asked.touch);
  EXPECT_EQ(asked.touch->fixture, "plate");
  EXPECT_EQ(asked.touch->position, q);
  TouchAnswer reported{.ok = true};
  reported.fixture = "plate", reported.marker = 1, reported.value = 1.0 / 3, reported.position = q, reported.time = 2.5;
  const TouchAnswer heard = touch_answer(answer_line(3, reported), 2, 2);
  EXPECT_TRUE(heard.ok);
  EXPECT_EQ(heard.fixture, "plate");
  EXPECT_EQ(heard.marker, 1);
  EXPECT_EQ(heard.value, 1.0 / 3);
  EXPECT_EQ(heard.position, q);
  EXPECT_EQ(heard.time, 2.5);
  for (const char* line : {R"({"id":1,"ok":true})", R"({"id":1,"ok":true,"touched":{}})",
                           R"({"id":1,"ok":true,"touched":{"fixture":"a","marker":2}})",
                           R"({"id":1,"ok":true,"touched":{"fixture":"a","value":"far"}})",
                           R"({"id":1,"ok":true,"touched":{"fixture":"a"},"position":[1]})"})
    EXPECT_THROW(touch_answer(line, 2, 2), DriverFault) << line;
}

}  // namespace
}  // namespace handsight
