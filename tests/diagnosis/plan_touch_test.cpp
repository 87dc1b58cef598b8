// SPDX-License-Identifier: Apache-2.0
// Which postures on which fixture next: a session of touches is planned as one of cameras is.
#include <gtest/gtest.h>

#include <set>

#include "chain/touching.h"
#include "diagnosis/planning/planning.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/fit_options.h"
#include "estimation/fit/fit_result.h"
#include "fixtures/touch_session.h"

namespace handsight {
namespace {

Session touched(int count, std::uint64_t seed) {
  Session like = fixture::probe_session();
  fixture::add_plates(like);
  fixture::add_sockets(like);
  return fixture::simulated_touches(like, count, seed).session;
}

std::vector<EffectTerm> find_zero(const Session& s, const std::string& joint) {
  return {term_of(*find_effect("joint_offset"), find_joint(s.robot, joint))};
}

/// The tip by a fit, in the frame of the fixture that a planned posture touches.
Vector3 tip_there(const Session& s, const Fit& f, const PlannedPose& pose) {
  const Chain chain = make_chain(s);
  const Chain& part = chain.parts[static_cast<std::size_t>(pose.fixture)];
  const ObservationState c = states_at(part, pose.position);
  const ObservedEnds seen = observed_ends(c, moved_sites(c, f.problem.terms));
  return inverse(seen.ends.root_from_mount * estimate(f).mount(pose.fixture)) *
         (seen.ends.root_from_tcp * estimate(f).markers_in_tcp[0]);
}

TEST(PlanTouch, EveryPostureTouchesItsFixtureAndTeaches) {
  const Session s = touched(40, 7);
  PlanOptions options;
  options.count = 6;
  options.estimated = find_zero(s, "a2");
  const Plan p = plan(s, options);
  ASSERT_EQ(p.poses.size(), 6u);
  FitOptions fitting;
  fitting.estimated = options.estimated;
  const Fit f = fit(s, fitting);
  for (const PlannedPose& pose : p.poses) {
    ASSERT_GE(pose.fixture, 0);
    const FixtureKind* const kind = s.fixtures[static_cast<std::size_t>(pose.fixture)].kind;
    EXPECT_LT(held_by(*kind, tip_there(s, f, pose)).norm(), 1e-6);
    EXPECT_GT(pose.gain, 0.01);
  }
  EXPECT_LT(p.poses.back().sigma.head<3>().norm(), p.sigma_before.head<3>().norm());
}

TEST(PlanTouch, WhatIsPlannedIsWorthMoreThanWhatIsNot) {
  const Session s = touched(25, 9);
  PlanOptions best;
  best.count = 5;
  best.estimated = find_zero(s, "a3");
  double planned = 0;
  for (const PlannedPose& pose : plan(s, best).poses) planned += pose.gain;
  // One pose at random, five times: the pool is one of a single posture a fixture.
  PlanOptions any = best;
  any.pool = 5;
  double drawn = 0;
  for (const PlannedPose& pose : plan(s, any).poses) drawn += pose.gain;
  EXPECT_GT(planned, drawn);
}

TEST(PlanTouch, TwoCausesAreToldApart) {
  const Session s = touched(40, 11);
  PlanOptions options;
  options.count = 4;
  options.between = CompetingEffects{"joint_offset:a2", "joint_offset:a3", find_zero(s, "a2"), find_zero(s, "a3")};
  const Plan p = plan(s, options);
  ASSERT_FALSE(p.poses.empty());
  EXPECT_TRUE(p.ln_bayes_factor_before.has_value());
  EXPECT_TRUE(p.poses.back().ln_bayes_factor.has_value());
  EXPECT_GE(p.poses.back().fixture, 0);
}

}  // namespace
}  // namespace handsight
