// SPDX-License-Identifier: Apache-2.0
// What has changed between touches of one day and of another.
#include <gmock/gmock.h>

#include <map>

#include "base/error.h"
#include "compare/change_watch.h"
#include "compare/comparison.h"
#include "estimation/report/fit_report.h"
#include "fixtures/touch_session.h"

namespace handsight {
namespace {

using testing::HasSubstr;

struct CompareTouches : testing::Test {
  CompareTouches() : like(fixture::probe_session()) {
    fixture::add_plates(like);
    fixture::add_sockets(like);
    june = fixture::simulated_touches(like, 100, 6).session;
  }

  /// The same probe on another day, in other postures.
  Session later(const Session& like_later, const std::vector<EffectTerm>& truth = {}) const {
    SimulationOptions options;
    options.observations = 100;
    options.seed = 7;
    options.effects = truth;
    options.markers_in_tcp = fixture::simulated_touches(like, 1, 6).markers_in_tcp;
    return simulate_session(like_later, options).session;
  }

  Session like, june;
};

TEST_F(CompareTouches, NothingHasChanged) {
  const Comparison c = compare(june, later(like), {}, {});
  EXPECT_EQ(c.verdict, ComparisonVerdict::unchanged) << c.sentence;
  EXPECT_THAT(c.sentence.english(), HasSubstr("fixtures, probe and arm are as they were"));
}

TEST_F(CompareTouches, AJointsZero) {
  std::vector<EffectTerm> truth;
  add_effect_value("joint_offset:a3.offset=0.0005", like.robot, truth);
  const Comparison c = compare(june, later(like, truth), {}, {});
  EXPECT_EQ(c.verdict, ComparisonVerdict::changed) << c.sentence;
  ASSERT_FALSE(c.changes.empty());
  EXPECT_EQ(c.changes.front().id, "joint_offset");
  EXPECT_THAT(c.changes.front().where, testing::ElementsAre("a3"));
  EXPECT_NEAR(c.changes.front().terms.front().values.front(), 5e-4, 5e-5);
  EXPECT_THAT(c.sentence.english(), HasSubstr("fixtures and probe are as they were"));
}

TEST_F(CompareTouches, AFixtureThatWasMoved) {
  Session moved = like;
  moved.other_mounts[2].mount_from_sensor.translation.x() += 4e-4;  // of the four after the first: socket_left
  moved.distances.clear();
  Session before = june;
  before.distances.clear();
  const Comparison c = compare(before, later(moved), {}, {});
  EXPECT_EQ(c.verdict, ComparisonVerdict::changed) << c.sentence;
  ASSERT_FALSE(c.changes.empty());
  EXPECT_EQ(c.changes.front().id, "camera_mount");
  EXPECT_THAT(c.changes.front().where, testing::ElementsAre("socket_left"));
  EXPECT_THAT(c.sentence.english(), HasSubstr("The fixture socket_left"));
}

/// What has no meaning (a plane's shift along itself, how one tip is turned) is no number of the comparison.
TEST_F(CompareTouches, NumbersAreThoseThatTouchesTell) {
  Session moved = like;
  moved.other_mounts[2].mount_from_sensor.translation.x() += 4e-4;  // socket_left
  moved.mount.mount_from_sensor.translation.z() += 3e-4;            // plate_front
  moved.distances.clear();
  Session before = june;
  before.distances.clear();
  const Comparison c = compare(before, later(moved), {}, {});
  std::map<std::string, NumberChange> numbers;
  for (const NumberChange& n : c.numbers) {
    EXPECT_GT(n.sigma, 1e-7) << n.name;
    EXPECT_LT(n.sigma, 1e-3) << n.name;
    numbers[n.name] = n;
  }
  ASSERT_EQ(numbers.size(), 3U + 3 * 3 + 2 * 3);
  const NumberChange &along = numbers.at("socket_left x"), &height = numbers.at("plate_front height");
  EXPECT_NEAR(along.after - along.before, 4e-4, 5 * along.sigma);
  EXPECT_NEAR(height.after - height.before, 3e-4, 5 * height.sigma);
  EXPECT_LT(std::abs(numbers.at("tip x").in_sigmas()), 5);
  EXPECT_LT(std::abs(numbers.at("plate_left rx").in_sigmas()), 5);
}

/// Of where the fixtures stood a calibration knows nothing.
TEST_F(CompareTouches, ACalibrationIsNotComparedWithThem) {
  const Fit found = fit(june, {});
  const CalibratedRobot robot = calibrated_robot(june, found, report(june, found), {}, "test");
  const Session again = later(like);
  const auto is_refused = testing::ThrowsMessage<InputError>(HasSubstr("name the earlier session of touches"));
  EXPECT_THAT([&] { compare(robot, again); }, is_refused);
  ChangeWatch watch(robot);
  EXPECT_THAT([&] { watch.add(again, again.observations.front()); }, is_refused);
}

}  // namespace
}  // namespace handsight
