// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/choosing.h"

#include <gtest/gtest.h>

#include <set>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "estimation/report/fit_report.h"

namespace handsight {
namespace {

Session few_observations(int count) { return simulated({{"joint_offset", 1, {0.01}}}, 31, count); }

/// Every pose is left out once, with what repeats it; the fit chosen has not seen it.
TEST(Choosing, EveryPoseIsLeftOutOnceWithItsRepetitions) {
  Session session = few_observations(12);
  constexpr std::int64_t again = 1000;
  session.observations.push_back(session.observations.front());
  session.observations.back().id = again;
  const Fit whole = fit(session, {});
  std::multiset<std::int64_t> missing;
  const auto error = error_with_choosing(session, whole, [&](const Session& part) -> std::optional<Fit> {
    std::set<std::int64_t> there;
    for (const Observation& o : part.observations) there.insert(o.id);
    for (const Observation& o : session.observations)
      if (!there.contains(o.id)) missing.insert(o.id);
    EXPECT_EQ(there.contains(again), there.contains(session.observations.front().id));
    return fit(part, {});
  });
  ASSERT_TRUE(error);
  EXPECT_EQ(missing.size(), session.observations.size());
  // Where nothing is chosen it is the held-out error, but that the folds start from nothing.
  EXPECT_NEAR(*error->rms_pixel, *report(session, whole).held_out.rms_pixel, 0.15 * *error->rms_pixel);
}

TEST(Choosing, NothingIsSaidWhereItIsStopped) {
  const Session session = few_observations(12);
  EXPECT_FALSE(error_with_choosing(session, fit(session, {}), [](const Session&) { return std::optional<Fit>(); }));
}

/// A shift that nothing in the catalogue follows and sixteen poses: what is chosen bends to them, and says so.
TEST(Choosing, FewPosesPromiseLessThanTheirHeldOutError) {
  int larger = 0;
  for (const std::uint64_t seed : {41U, 42U, 43U}) {
    Session session = simulated({{"joint_offset", 1, {0.01}}}, seed, 16);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (Observation& o : session.observations)
      for (double& q : o.position) q += 1e-3 * normal(random);
    const Improvement m = improve(session);
    if (m.steps.size() < 2) continue;
    ASSERT_TRUE(m.held_out_choosing) << seed;
    larger += *m.held_out_choosing->rms_pixel > *m.last.report.held_out.rms_pixel;
  }
  EXPECT_GE(larger, 2);
}

TEST(Choosing, ManyPosesAreNotAsked) {
  const Improvement m = improve(few_observations(60));
  EXPECT_GE(m.steps.size(), 2U);
  EXPECT_FALSE(m.held_out_choosing);
}

}  // namespace
}  // namespace handsight
