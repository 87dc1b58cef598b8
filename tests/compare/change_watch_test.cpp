// SPDX-License-Identifier: Apache-2.0
#include "compare/change_watch.h"

#include <gmock/gmock.h>

#include "estimation/report/fit_report.h"
#include "fixtures/arms.h"
#include "fixtures/targets.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

struct Calibrated {
  Session session;
  CalibratedRobot robot;
  std::vector<Eigen::VectorXd> poses;  // to recheck in
  SimulationOptions truth;
};

Calibrated calibrated(const Session& like, std::uint64_t seed, int poses = 5, double noise = 0) {
  Calibrated c;
  if (noise > 0) c.truth.noise = noise;
  c.truth.observations = 60;
  c.truth.seed = seed;
  c.session = simulate_session(like, c.truth).session;
  const Fit f = fit(c.session);
  c.robot = calibrated_robot(c.session, f, report(c.session, f), {}, "test");
  std::vector<Eigen::VectorXd> positions;
  for (const Observation& o : c.session.observations) positions.push_back(o.position);
  for (const std::size_t place : telling_poses(c.robot, c.session, positions, poses))
    c.poses.push_back(positions[place]);
  return c;
}

/// The same robot `visits` times in its poses, with these effects. The noise is another each time.
Session rechecked(const Calibrated& c, int visits, const std::vector<EffectTerm>& effects, std::uint64_t noise_seed) {
  std::vector<Observation> given;
  for (int visit = 0; visit < visits; ++visit)
    for (const Eigen::VectorXd& q : c.poses) {
      Observation o;
      o.id = static_cast<std::int64_t>(given.size());
      o.time = 3600.0 * visit + static_cast<double>(given.size());
      o.position = q;
      given.push_back(o);
    }
  SimulationOptions truth = c.truth;
  truth.effects = effects;
  // The body follows from the seed, and so does the noise of the n-th observation: the first ones are left out.
  std::vector<Observation> all(1000 + noise_seed * 1000 % 7001, given.front());
  all.insert(all.end(), given.begin(), given.end());
  Session session = simulate_at(c.session, truth, all).session;
  session.observations.erase(session.observations.begin(),
                             session.observations.end() - static_cast<std::ptrdiff_t>(given.size()));
  return session;
}

/// Watched for so many visits without a change, which raise no alarm, then for one with it.
std::optional<WatchStep> watched(const Calibrated& c, int visits_before, const char* change) {
  std::vector<EffectTerm> effects;
  add_effect_value(change, c.session.robot, effects);
  ChangeWatch watch(c.robot);
  if (visits_before > 0) {
    const Session before = rechecked(c, visits_before, {}, 3);
    for (const Observation& o : before.observations) EXPECT_FALSE(watch.add(before, o)->changed);
  }
  const Session after = rechecked(c, 1, effects, 4);
  std::optional<WatchStep> last;
  for (const Observation& o : after.observations) last = watch.add(after, o);
  return last;
}

TEST(ChangeWatch, WithoutAChangeTheEValueStaysSmallForMonths) {
  int alarms = 0;
  double largest = -1e300;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Calibrated c = calibrated(fixture::tracker_session(4), seed);
    ChangeWatch watch(c.robot, {.window = 10});
    const Session session = rechecked(c, 40, {}, seed);
    for (const Observation& o : session.observations) {
      const auto step = watch.add(session, o);
      ASSERT_TRUE(step);
      largest = std::max(largest, step->ln_e_value);
      if (step->changed) {
        ++alarms;
        break;
      }
    }
  }
  EXPECT_EQ(alarms, 0);
  EXPECT_LT(largest, std::log(1000.0));
  EXPECT_GT(largest, -20);
}

TEST(ChangeWatch, ASlippedHandIsSeenWithinFivePosesAndNamed) {
  const Calibrated c = calibrated(fixture::stand_session(4), 7);
  const std::optional<WatchStep> last = watched(c, 2, "body_slip:x=0.003");
  EXPECT_TRUE(last->changed);
  EXPECT_EQ(last->what, "body_slip") << last->text;
  EXPECT_NEAR(last->terms[0].values[0], 0.003, 4 * last->sigma[0]);
  EXPECT_THAT(last->text, testing::HasSubstr("slipped"));
}

TEST(ChangeWatch, AnOffsetOfAJointIsNamedWithItsSize) {
  const Calibrated c = calibrated(fixture::tracker_session(4), 9);
  const std::optional<WatchStep> last = watched(c, 0, "joint_offset:a2.offset=0.002");
  EXPECT_TRUE(last->changed);
  EXPECT_EQ(last->what, "joint_offset") << last->text;
  EXPECT_EQ(last->where, "a2");
  EXPECT_NEAR(last->terms[0].values[0], 0.002, 4 * last->sigma[0] + 1e-4);
  EXPECT_THAT(last->indistinguishable_from, testing::IsEmpty());
}

/// Of a single marker it is the same whether it slipped or the body that it is.
TEST(ChangeWatch, WhatCannotBeToldApartIsSaidSo) {
  const Calibrated c = calibrated(fixture::tracker_session(1), 9);
  const std::optional<WatchStep> last = watched(c, 0, "body_slip:x=0.003");
  EXPECT_TRUE(last->changed);
  std::vector<std::string> named = last->indistinguishable_from;
  named.push_back(last->what);
  EXPECT_THAT(named, testing::IsSupersetOf({"body_slip", "marker_slip"})) << last->text;
  EXPECT_THAT(last->text.english(), testing::HasSubstr("do not tell apart"));
}

/// The poses are chosen by what the cameras see there, and the weakest change counts most.
TEST(ChangeWatch, AZeroThatIsLostByAFifthOfAMilliradianShowsInFivePosesOfABoard) {
  for (const std::uint64_t seed : {20573, 20602, 20693}) {
    const Calibrated c = calibrated(fixture::target_session(fixture::charuco(), 2), seed, 5, 0.1);
    const std::optional<WatchStep> last = watched(c, 10, "joint_offset:a1.offset=0.0002");
    EXPECT_TRUE(last->changed) << seed << ": " << last->ln_e_value;
    EXPECT_EQ(last->where, "a1") << last->text;
  }
}

TEST(ChangeWatch, WhatShowsNothingIsNoStep) {
  const Calibrated c = calibrated(fixture::tracker_session(4), 9);
  ChangeWatch watch(c.robot);
  Observation empty;
  empty.position = c.poses[0];
  EXPECT_FALSE(watch.add(c.session, empty));
}

}  // namespace
}  // namespace handsight
