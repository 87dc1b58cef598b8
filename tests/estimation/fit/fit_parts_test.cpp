// SPDX-License-Identifier: Apache-2.0
// Several sessions of one robot fitted as one.
#include "estimation/fit/fit_parts.h"

#include <gtest/gtest.h>

#include "effects/own_effect.h"
#include "effects/part_effects.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/member_noise.h"
#include "estimation/fit/part_fit.h"
#include "estimation/report/export.h"
#include "estimation/report/part_report.h"
#include "estimation/solvers/normal_equations.h"
#include "fixtures/two_arms.h"

namespace handsight {
namespace {

using fixture::find_offset;

SimulationOptions simulation(std::uint64_t seed, int observations = 40) {
  SimulationOptions o;
  o.seed = seed;
  o.observations = observations;
  o.nearest = 0.2;
  o.farthest = 4;
  o.most_turned = 1.4;
  return o;
}

std::vector<EffectTerm> estimated(const Session& s, const std::string& text) {
  const Chain chain = make_chain(s);
  return effect_terms(text, chain, list_own_effects(s, chain));
}

double away(const Rigid& a, const Rigid& b) { return small_motion_between(a, b).norm(); }

/// Two hands before a tracker that stands where it stood; `effects` are the robot's.
std::vector<JoinedMember> two_hands(std::uint64_t seed, const std::vector<EffectTerm>& effects) {
  SimulationOptions left = simulation(seed), right = simulation(seed + 1000);
  left.effects = right.effects = effects;
  std::vector<JoinedMember> members{fixture::simulated_member(fixture::hand_session('l'), left, "left"),
                                    fixture::simulated_member(fixture::hand_session('r'), right, "right")};
  for (JoinedMember& m : members) m.rig = "tracker";
  return members;
}

TEST(FitParts, SessionsThatShareNothingAreFittedAsEachAlone) {
  std::vector<JoinedMember> members = two_hands(3, {});
  for (JoinedMember& m : members) m.rig.clear();
  const Session s = joined(members, "hands");
  const Fit together = fit(s);
  const std::vector<FitPart> parts = list_parts(s, together);
  for (std::size_t p = 0; p < 2; ++p) {
    const Fit alone = fit(members[p].session);
    EXPECT_LT(away(parts[p].tcp_from_body, alone.tcp_from_body), 1e-9);
    EXPECT_LT(away(parts[p].mount_from_sensor, estimate(alone).mount_from_sensor), 1e-9);
    EXPECT_LT((parts[p].covariance - alone.covariance).norm(), 1e-6 * alone.covariance.norm());
  }
}

TEST(FitParts, ASharedMountIsKnownBetterAndRight) {
  const std::vector<JoinedMember> members = two_hands(5, {});
  const Session s = joined(members, "hands");
  const Fit together = fit(s);
  const std::vector<FitPart> parts = list_parts(s, together);
  EXPECT_EQ(parts[0].mount_from_sensor.translation, parts[1].mount_from_sensor.translation);
  const Fit alone = fit(members[0].session);
  const Matrix6 of_alone =
      alone.parameter_covariance.block<6, 6>(alone.problem.mount_column(), alone.problem.mount_column());
  EXPECT_LT(parts[0].mount_covariance->trace(), 0.8 * of_alone.trace());
  // Ground truth: where the simulated tracker stood.
  const Rigid truly = fixture::hand_session('l').mount.mount_from_sensor;
  const Vector6 off = small_motion_between(Rigid{}, inverse(truly) * parts[0].mount_from_sensor);  // true exp(v)
  const double chi_squared = off.dot(parts[0].mount_covariance->ldlt().solve(off));
  EXPECT_LT(chi_squared, 27.9) << "p = 1e-4 of six degrees of freedom";
}

TEST(FitParts, WhatBelongsToTheRobotIsOneNumberForAll) {
  const Session like = fixture::hand_session('l');
  const std::vector<JoinedMember> members =
      two_hands(7, {find_offset(like, "torso_2", 4e-3), find_offset(like, "l3", -3e-3)});
  const Session s = joined(members, "hands");
  FitOptions options;
  options.estimated = estimated(s, "joint_offset:torso_2+l3");
  const Fit together = fit(s, options);
  ASSERT_EQ(together.effects.size(), 2U);
  EXPECT_NEAR(together.effects[0].term.values[0], 4e-3, 4 * together.effects[0].sigmas[0]);
  EXPECT_NEAR(together.effects[1].term.values[0], -3e-3, 4 * together.effects[1].sigmas[0]);
  FitOptions of_one;
  of_one.estimated = estimated(members[0].session, "joint_offset:torso_2+l3");
  EXPECT_LT(together.effects[0].sigmas[0], fit(members[0].session, of_one).effects[0].sigmas[0]);
}

TEST(FitParts, CamerasAndTrackersCountByTheirOwnNoise) {
  const Session like = fixture::hand_session('l');
  SimulationOptions o = simulation(11);
  o.effects = {find_offset(like, "torso_2", 4e-3)};
  o.noise = 1e-4;
  JoinedMember tracker = fixture::simulated_member(fixture::hand_session('l'), o, "tracker");
  o.noise = 0.3;
  o.farthest = 1.6;
  o.most_turned = 1.2;
  Session stand = fixture::head_session('r');
  JoinedMember cameras = fixture::simulated_member(stand, o, "cameras");
  std::vector<JoinedMember> members{tracker, cameras};
  const Session s = joined(members, "cell");
  EXPECT_FALSE(s.is_tracker());
  FitOptions options;
  options.estimated = estimated(s, "joint_offset:torso_2");
  const Fit together = fit(s, options);
  EXPECT_NEAR(together.effects[0].term.values[0], 4e-3, 4 * together.effects[0].sigmas[0]);
  ASSERT_TRUE(together.chi2_per_dof);
  EXPECT_NEAR(*together.chi2_per_dof, 1, 0.15);
  const std::vector<PartReport> parts = part_reports(s, together, report(s, together, options));
  EXPECT_FALSE(parts[0].fitted.rms_pixel);
  EXPECT_NEAR(*parts[0].fitted.rms_m, std::sqrt(3.0) * 1e-4, 2e-5);
  EXPECT_NEAR(*parts[1].fitted.rms_pixel, 0.3, 0.03);
}

TEST(FitParts, NoiseThatIsNotDeclaredIsLearned) {
  SimulationOptions o = simulation(13);
  o.declare_noise = false;
  o.noise = 1e-4;
  std::vector<JoinedMember> members{fixture::simulated_member(fixture::hand_session('l'), o, "fine")};
  o.noise = 5e-4;
  members.push_back(fixture::simulated_member(fixture::hand_session('r'), o, "coarse"));
  learn_noise(members);
  const Session s = joined(members, "hands");
  EXPECT_NEAR(s.parts[1].residual_unit, 5, 1);
}

TEST(FitParts, APartByItselfSaysWhatAllSay) {
  const Session like = fixture::hand_session('l');
  const Session s = joined(two_hands(17, {find_offset(like, "torso_2", 4e-3), find_offset(like, "r3", 2e-3)}), "hands");
  FitOptions options;
  options.estimated = estimated(s, "joint_offset:torso_2+r3");
  const Fit together = fit(s, options);
  const std::vector<FitPart> parts = list_parts(s, together);
  for (int p = 0; p < 2; ++p) {
    const PartFit own = fit_of_part(s, together, p);
    const FitPart& of_all = parts[static_cast<std::size_t>(p)];
    EXPECT_LT(away(own.fit.tcp_from_body, of_all.tcp_from_body), 1e-12);
    EXPECT_LT((own.fit.covariance - of_all.covariance).norm(), 1e-9 * of_all.covariance.norm());
    EXPECT_EQ(own.fit.effects.front().term.values, together.effects.front().term.values);
    EXPECT_NEAR(own.fit.effects.front().sigmas[0], together.effects.front().sigmas[0], 1e-12);
    // Its residuals are those that it has in the joined fit.
    const double own_cost = normal_equations(own.fit.problem, estimate(own.fit)).data_cost();
    double of_part = 0;
    for (const ProblemObservation& o : together.problem.observations)
      if (s.observations[static_cast<std::size_t>(o.index)].part == p)
        of_part += compute_residuals(together.problem, o, estimate(together)).squares;
    EXPECT_NEAR(own_cost, of_part, 1e-9 * of_part);
  }
}

TEST(FitParts, ASlipIsOfItsOwnSession) {
  SimulationOptions june = simulation(19), august = simulation(20);
  EffectTerm slip = term_of(*find_effect("body_slip"), -1);
  slip.values = {1e-3, 0, -2e-3, 0, 0.01, 0, 20};
  august.effects = {slip};
  std::vector<JoinedMember> members{fixture::simulated_member(fixture::hand_session('l'), june, "june"),
                                    fixture::simulated_member(fixture::hand_session('l'), august, "august")};
  const Session s = joined(members, "days");
  FitOptions options;
  options.estimated = estimated(s, "body_slip:august");
  ASSERT_EQ(options.estimated.size(), 1U);
  options.estimated[0].values[6] = s.parts[1].first_order + 20;
  const Fit together = fit(s, options);
  EXPECT_NEAR(together.effects[0].term.values[2], -2e-3, 4 * together.effects[0].sigmas[2]);
  const PartFit own = fit_of_part(s, together, 1);
  ASSERT_EQ(own.fit.effects.size(), 1U);
  EXPECT_EQ(own.fit.effects[0].term.id, "body_slip");
  EXPECT_EQ(own.fit.effects[0].term.values[6], 20);
  EXPECT_TRUE(fit_of_part(s, together, 0).fit.effects.empty());
}

TEST(FitParts, ASessionsOwnJointZeroIsItsOwn) {
  const Session like = fixture::hand_session('l');
  std::vector<JoinedMember> members = fixture::two_days(like, simulation(21), {}, {find_offset(like, "l3", 2e-3)});
  members[1].own = {"joint_offset:l3"};
  const Session s = joined(members, "days");
  const Chain chain = make_chain(s);
  FitOptions options;
  options.estimated = own_terms(chain, list_own_effects(s, chain));
  ASSERT_EQ(options.estimated.size(), 1U);
  const Fit together = fit(s, options);
  EXPECT_NEAR(together.effects[0].term.values[0], 2e-3, 4 * together.effects[0].sigmas[0]);
  EXPECT_NEAR(*together.chi2_per_dof, 1, 0.2);
  const PartFit own = fit_of_part(s, together, 1);
  ASSERT_EQ(own.fit.effects.size(), 1U);
  EXPECT_EQ(own.fit.effects[0].term.id, "joint_offset");
}

TEST(FitParts, TheErrorOnASessionThatWasLeftOutShowsWhatBelongsToTheFixture) {
  const Session like = fixture::hand_session('l');
  const Session s = joined(two_hands(23, {find_offset(like, "torso_2", 5e-3)}), "hands");
  FitOptions with;
  with.estimated = estimated(s, "joint_offset:torso_2");
  const Fit plain = fit(s), reported = fit(s, with);
  FitReport of_plain = report(s, plain), of_reported = report(s, reported, with);
  hold_out_sessions(s, plain, {}, of_plain);
  hold_out_sessions(s, reported, with, of_reported);
  ASSERT_TRUE(of_plain.held_out_session.rms_m && of_reported.held_out_session.rms_m);
  EXPECT_LT(*of_reported.held_out_session.rms_m, *of_plain.held_out_session.rms_m);
  EXPECT_EQ(of_reported.held_out_sessions.size(), 2U);
}

TEST(FitParts, OneCalibrationHoldsAllHands) {
  const Session s = joined(two_hands(29, {}), "hands");
  const Fit together = fit(s);
  const Calibration c = make_calibration(s, together, report(s, together), {}, "test");
  ASSERT_EQ(c.sessions.size(), 2U);
  EXPECT_EQ(c.sessions[1].tcp, "right_hand");
  EXPECT_LT(away(find_session(c, "right").tcp_from_body.motion, list_parts(s, together)[1].tcp_from_body), 1e-12);
}

}  // namespace
}  // namespace handsight
