// SPDX-License-Identifier: Apache-2.0
// What has changed between touches of one day and of another.
#include <gmock/gmock.h>

#include "compare/comparison.h"
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

}  // namespace
}  // namespace handsight
