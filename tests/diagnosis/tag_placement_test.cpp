// SPDX-License-Identifier: Apache-2.0
// One tag of a body of five was put on askew: it is named with its number; where all are right nothing is named.
#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "fixtures/askew_tags.h"

namespace handsight {
namespace {

using fixture::askew;
using fixture::tag_cube;
using fixture::target_session;

DiagnosisOptions quick_options() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

constexpr double two_degrees = 2 * std::numbers::pi / 180;

TEST(TagPlacement, IsNamedWithItsTag) {
  for (const auto& [tag, by, turn] : {std::tuple{1, Vector3(2e-3, 0, 0), Vector3(0, 0, 0)},
                                      std::tuple{3, Vector3(0, 0, 0), Vector3(two_degrees, 0, 0)},
                                      std::tuple{0, Vector3(0, -2e-3, 0), Vector3(0, 0, two_degrees)}}) {
    const Diagnosis d = diagnose(askew(tag, by, turn).session, quick_options());
    ASSERT_FALSE(d.candidates.empty());
    EXPECT_EQ(d.verdict, Verdict::missing_effect) << d.reason;
    EXPECT_EQ(d.candidates.front().id, "tag_placement") << d.reason;
    EXPECT_EQ(d.candidates.front().where, (std::vector<std::string>{fmt::format("tag {}", tag)})) << d.reason;
    EXPECT_TRUE(d.candidates.front().plausible);
  }
}

TEST(TagPlacement, IsNotNamedWhereAllTagsAreRight) {
  for (const std::uint64_t seed : {5, 6, 7})
    EXPECT_EQ(diagnose(askew(0, Vector3::Zero(), Vector3::Zero(), seed).session, quick_options()).verdict,
              Verdict::adequate);
}

TEST(TagPlacement, IsNotNamedWhereTheSigmasAllowForIt) {
  Target loose = tag_cube();
  for (TagPlace& place : loose.places) place.sigma = 2e-3, place.sigma_angle = 0.03;
  const SimulatedSession s = askew(1, Vector3(2e-3, 0, 0), Vector3(0, two_degrees, 0), 5, 40, loose);
  const Diagnosis d = diagnose(s.session, quick_options());
  EXPECT_EQ(d.verdict, Verdict::adequate) << d.reason;
}

TEST(TagPlacement, IsTakenFirstAndEnoughToImproveTheModel) {
  const SimulatedSession s = askew(4, Vector3(1e-3, 2e-3, 0), Vector3(0, 0, two_degrees));
  const Improvement m = improve(s.session, {});
  ASSERT_EQ(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "tag_placement");
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
}

TEST(TagPlacement, ASpringOfTheRobotIsNotBlamedOnATag) {
  SimulationOptions o;
  o.observations = 50;
  o.seed = 5;
  o.effects = {{"joint_elasticity", 2, {1.5e-4}}};
  const Diagnosis d = diagnose(simulate_session(target_session(tag_cube()), o).session, quick_options());
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity") << d.reason;
}

}  // namespace
}  // namespace handsight
