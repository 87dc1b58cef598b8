// SPDX-License-Identifier: Apache-2.0
// One reading that slipped is said to be one, and nothing is added to the model for it.
#include "diagnosis/outliers/lone_observations.h"

#include <gmock/gmock.h>

#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<LoneObservation> lone_of(const Session& session) { return lone_observations(session, fit(session), {}); }

TEST(LoneObservations, AReadingThatSlippedIsNamedAndNothingIsAddedForIt) {
  Session session = simulated({}, 21, 20);
  session.observations[8].position[1] += 0.4;
  const Improvement m = improve(session, {});
  ASSERT_THAT(m.last.model.lone, SizeIs(1));
  EXPECT_EQ(m.last.model.lone[0].id, session.observations[8].id);
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
  EXPECT_THAT(m.steps, SizeIs(1)) << "nothing was added";
  EXPECT_LT(*m.last.report.held_out.rms_pixel, 0.3);
  EXPECT_THAT(m.last.reason, HasSubstr("Look for a wrong reading"));
  EXPECT_EQ(m.last.model.fit.problem.observations.size(), 19u);
}

TEST(LoneObservations, BesideWhatIsMissingBothAreFound) {
  Session session = simulated({{"joint_elasticity", 1, {6e-5}}}, 22);
  session.observations[30].position[1] -= 0.5;
  const Diagnosis d = diagnose(session, {});
  ASSERT_THAT(d.model.lone, SizeIs(1));
  EXPECT_EQ(d.model.lone[0].index, 30);
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity");
}

TEST(LoneObservations, TwoOfVeryDifferentSizes) {
  Session session = simulated({}, 23);
  session.observations[12].position[0] += 0.8;
  session.observations[40].position[2] += 0.03;
  EXPECT_THAT(lone_of(session), SizeIs(2));
}

TEST(LoneObservations, WhatAnEffectDoesIsNoLoneObservation) {
  const std::vector<EffectTerm> hidden[] = {{},
                                            {{"joint_elasticity", 1, {2e-4}}},
                                            {{"backlash", 2, {4e-3}}},
                                            {{"friction_hysteresis", 3, {4e-3}}},
                                            {{"joint_offset", 2, {3e-2}}},
                                            {{"encoder_eccentricity", 4, {2e-2, 1e-2}}},
                                            {{"link_geometry", 2, {5e-3, 0, 2e-2, 0}}}};
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const std::vector<EffectTerm>& effects : hidden)
      for (const int observations : {14, 60})
        EXPECT_THAT(lone_of(simulated(effects, 100 + seed, observations)), IsEmpty())
            << (effects.empty() ? "nothing" : effects.front().id) << ", seed " << seed << ", " << observations;
}

TEST(LoneObservations, ASlipNearTheEndStaysASlip) {
  const Session session = simulated({{"body_slip", -1, {8e-3, -6e-3, 9e-3, 0.02, 0.03, -0.02, 57}}}, 24);
  EXPECT_THAT(lone_of(session), IsEmpty());
}

TEST(LoneObservations, OfATrackerInMillimetres) {
  Session session = simulated({}, 25, 30, fixture::tracker_session(4));
  session.observations[3].position[2] += 0.3;
  const CleanFit model = fit_without_outliers(session, {});
  ASSERT_THAT(model.lone, SizeIs(1));
  EXPECT_EQ(model.session.observations[3].decision, Decision::excluded);
  EXPECT_THAT(model.fit.notes.back(), HasSubstr("Observation 3 is left out: by what the others say it is off by"));
  EXPECT_THAT(model.fit.notes.back(), HasSubstr(" mm"));
}

}  // namespace
}  // namespace handsight
