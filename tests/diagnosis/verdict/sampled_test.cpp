// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/sampled.h"

#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {
namespace {

TEST(Sample, IsEvenOverTheSessionAndNamesWhatItLeft) {
  Session session = simulated({}, 3, 500);
  session.observations[7].decision = Decision::excluded;
  const auto sample = take_sample(session, 200, 100);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->taken.size(), 100u);
  EXPECT_EQ(sample->left_out.size(), 399u);
  EXPECT_EQ(sample->taken.front(), 0);
  EXPECT_EQ(sample->taken.back(), 499);
  for (std::size_t i = 1; i < sample->taken.size(); ++i) EXPECT_LE(sample->taken[i] - sample->taken[i - 1], 7);
  EXPECT_EQ(sample->session.observations.size(), 100u);
  EXPECT_FALSE(take_sample(session, 499, 100)) << "short enough to be taken whole";
}

TEST(Sample, KeepsTheCircumstancesOfTheWhole) {
  Session session = simulated({}, 4, 120);
  for (Observation& o : session.observations) o.velocity.resize(0);  // the approach follows from the pose before
  const auto sample = take_sample(session, 50, 30);
  const Chain chain = make_chain(session);
  const std::vector<ObservationState> whole = observation_states(session, chain);
  const std::vector<ObservationState> part = observation_states(sample->session, chain);
  ASSERT_EQ(part.size(), 30u);
  for (std::size_t i = 0; i < part.size(); ++i) {
    const ObservationState& same = whole[static_cast<std::size_t>(sample->taken[i])];
    EXPECT_EQ(part[i].order, same.order);
    EXPECT_EQ(part[i].elapsed, same.elapsed);
    EXPECT_EQ(part[i].duration, same.duration);
    EXPECT_EQ(part[i].approach, same.approach);
    EXPECT_EQ(part[i].sensor, same.sensor);
  }
}

TEST(Sample, DecidesForALongSessionAndIsTriedOnTheRest) {
  const Session session = simulated({{"joint_elasticity", 2, {1e-4}}}, 5, 5000);
  DiagnosisOptions quick;
  quick.with_held_out = false;
  const Diagnosis d = diagnose(session, quick);
  EXPECT_EQ(d.verdict, Verdict::missing_effect) << d.reason;
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity");
  ASSERT_TRUE(d.sample);
  EXPECT_EQ(d.sample->taken, 3000);
  EXPECT_EQ(d.sample->all, 5000);
  EXPECT_EQ(d.report.observations, 5000);
  EXPECT_EQ(d.report.used, 3000);
  EXPECT_NEAR(*d.sample->others.rms_pixel / *d.report.held_out.rms_pixel, 1, 0.05);
  EXPECT_NE(d.reason.find("3000 of the 5000"), std::string::npos) << d.reason;
  EXPECT_NE(d.reason.find("no worse than these"), std::string::npos) << d.reason;
}

TEST(Sample, SaysWhereTheRestIsWorse) {
  Session session = simulated({}, 6, 4100);
  const Sample sample = *sample_to_judge(session);
  for (const int i : sample.left_out)
    for (Sighting& s : session.observations[static_cast<std::size_t>(i)].sightings) see(s, 0, Vector2(400, 300));
  DiagnosisOptions quick;
  quick.with_held_out = false;
  EXPECT_NE(diagnose(session, quick).reason.find("which is worse"), std::string::npos);
}

}  // namespace
}  // namespace handsight
