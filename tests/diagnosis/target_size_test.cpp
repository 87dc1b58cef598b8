// SPDX-License-Identifier: Apache-2.0
// A target that is not as described, and joints that turn with each other: fitted, named, and nothing named without.
#include <gtest/gtest.h>

#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/stand_in.h"
#include "effects/own_effect.h"
#include "estimation/report/fit_report.h"
#include "fixtures/targets.h"
#include "session/pose_points.h"
#include "session/sample.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

using fixture::eye_in_hand_session;
using fixture::target_session;

DiagnosisOptions quick_sizes() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

SimulatedSession simulated(const Session& like, const std::vector<std::string>& values, std::uint64_t seed = 5,
                           int observations = 40) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  const OwnEffects own = list_own_effects(like, make_chain(like));
  for (const std::string& text : values) add_effect_value(text, like.robot, o.effects, own);
  return simulate_session(like, o);
}

/// The same measurements of a board that is described smaller than it is by this share.
SimulatedSession printed_larger(const Session& like, double by, std::uint64_t seed = 5) {
  SimulatedSession s = simulated(like, {}, seed);
  for (Vector3& x : s.session.shape->markers) x /= 1 + by;
  s.session.target->square /= 1 + by;
  s.session.target->tag /= 1 + by;
  return s;
}

Fit fitted(const Session& session, const std::string& effects) {
  const Chain chain = make_chain(session);
  return fit(session, {.estimated = effect_terms(effects, chain, list_own_effects(session, chain))});
}

double error_of_body(const SimulatedSession& s, const Fit& f) {
  const Vector6 xi = small_motion_between(fixture::true_target_body(s, f.sides), f.tcp_from_body);
  return xi.dot(f.covariance.ldlt().solve(xi));
}

TEST(TargetSize, IsFoundWithTheBodyInItsPlace) {
  for (const Session& like : {target_session(fixture::charuco(), 2), target_session(), eye_in_hand_session()})
    for (const double by : {0.02, -0.05}) {
      const SimulatedSession s = printed_larger(like, by);
      const Fit f = fitted(s.session, "target_scale");
      EXPECT_TRUE(f.converged());
      ASSERT_EQ(f.effects.size(), 1u);
      EXPECT_NEAR(f.effects[0].term.values[0], by, 3 * f.effects[0].sigmas[0]);
      EXPECT_LT(f.effects[0].sigmas[0], 1e-3);
      EXPECT_LT(error_of_body(s, f), 22.5) << "chi-squared of six, p 1e-3";
      EXPECT_EQ(f.covariance_kind, CovarianceKind::noise) << "nothing is left";
    }
}

/// What the description says of the size is no matter where the size is estimated: a fifth, a half and twice of it.
TEST(TargetSize, IsFoundHoweverWrongTheDescription) {
  for (const Session& like : {target_session(fixture::charuco(), 2), eye_in_hand_session()}) {
    const Fit right = fitted(printed_larger(like, 0).session, "target_scale");
    const double size = 1 + right.effects.at(0).term.values[0];
    for (const double by : {4.0, 1.0, -0.5}) {
      const Fit f = fitted(printed_larger(like, by).session, "target_scale");
      EXPECT_TRUE(f.converged()) << by;
      EXPECT_NEAR(1 + f.effects.at(0).term.values[0], size * (1 + by), 1e-5 * (1 + by)) << by;
      EXPECT_LT((f.tcp_from_body.translation - right.tcp_from_body.translation).norm(), 1e-6) << by;
    }
  }
}

TEST(TargetSize, IsNoStandInHoweverLarge) {
  const Improvement m = improve(printed_larger(eye_in_hand_session(), 1.2).session, {});
  ASSERT_GE(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "target_scale");
  EXPECT_TRUE(m.steps[1].stands.empty());
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
  EXPECT_TRUE(stand_ins(m.last.model.fit).empty());
}

TEST(TargetSize, IsNamedFirstHoweverLarge) {
  for (const Session& like : {target_session(fixture::charuco(), 2), target_session(), eye_in_hand_session()})
    for (const double by : {0.005, -0.02, 0.05}) {
      const Diagnosis d = diagnose(printed_larger(like, by).session, quick_sizes());
      ASSERT_FALSE(d.candidates.empty());
      EXPECT_EQ(d.candidates.front().id, "target_scale") << by << ": " << d.reason;
      EXPECT_EQ(d.verdict, Verdict::missing_effect) << by << ": " << d.reason;
      EXPECT_NEAR(d.candidates.front().terms.at(0).values[0], by, 2e-3);
    }
}

TEST(TargetSize, IsNotNamedWhereTheBoardIsRight) {
  for (const Session& like : {target_session(fixture::charuco(), 2), target_session(), eye_in_hand_session()})
    EXPECT_EQ(diagnose(simulated(like, {}, 6).session, quick_sizes()).verdict, Verdict::adequate);
}

TEST(TargetSize, IsTakenFirstAndEnoughToImproveTheModel) {
  const SimulatedSession s = printed_larger(target_session(), 0.02);
  const Improvement m = improve(s.session, {});
  ASSERT_EQ(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "target_scale");
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
  EXPECT_LT(error_of_body(s, m.last.model.fit), 22.5);
}

/// Poses of a target that is 3 % larger than the program that tells them was told.
SimulatedSession told_of_a_smaller_target() {
  Session like = fixture::stand_session();
  like.rig.reset();
  like.pose_sensor = PoseSensor{3e-4, 1e-3};
  show_poses(like, pose_lever(*like.pose_sensor));
  SimulatedSession s = simulated(like, {});
  for (Observation& o : s.session.observations) o.target_pose->translation /= 1.03;
  show_poses(s.session, pose_lever(*s.session.pose_sensor));
  return s;
}

TEST(TargetSize, OfAPoseSensorsTargetIsThatOfItsDistances) {
  const SimulatedSession s = told_of_a_smaller_target();
  const Fit f = fitted(s.session, "target_scale");
  EXPECT_NEAR(f.effects.at(0).term.values[0], 0.03, 3 * f.effects[0].sigmas[0]);
  const Diagnosis d = diagnose(s.session, quick_sizes());
  EXPECT_EQ(d.candidates.at(0).id, "target_scale") << d.reason;
}

/// Poses that took no part in the fit are farther away by the same share as those that did.
TEST(TargetSize, OfAPoseSensorsTargetHoldsForOtherPoses) {
  const SimulatedSession s = told_of_a_smaller_target();
  std::vector<int> even, odd;
  for (int i = 0; i < static_cast<int>(s.session.observations.size()); ++i) (i % 2 == 0 ? even : odd).push_back(i);
  const Session half = take_part(s.session, even);
  const Fit f = fitted(half, "target_scale");
  EXPECT_LT(*error_on(take_part(s.session, odd), f).rms_m, 1.5 * *report(half, f).held_out.rms_m);
}

TEST(TargetBend, IsFoundAndNamed) {
  const SimulatedSession s = simulated(target_session(), {"target_bend:bend_x=0.2", "target_bend:bend_y=-0.1"});
  const Fit f = fitted(s.session, "target_bend");
  for (const std::size_t p : {0u, 1u})
    EXPECT_NEAR(f.effects.at(0).term.values[p], p == 0 ? 0.2 : -0.1, 3.5 * f.effects[0].sigmas[p]);
  const Diagnosis d = diagnose(s.session, quick_sizes());
  EXPECT_EQ(d.candidates.at(0).id, "target_bend") << d.reason;
}

TEST(JointCoupling, IsNamedWithBothJoints) {
  const SimulatedSession s = simulated(target_session(), {"joint_coupling:a3.ratio=0.02", "joint_coupling:a3.from=1"});
  const Diagnosis d = diagnose(s.session, quick_sizes());
  ASSERT_FALSE(d.candidates.empty());
  const DiagnosisCandidate& best = d.candidates.front();
  EXPECT_EQ(best.id, "joint_coupling") << d.reason;
  EXPECT_EQ(best.where, (std::vector<std::string>{"a3", "a2"}));
  EXPECT_NEAR(best.terms.at(0).values[0], 0.02, 1e-3);
}

TEST(TargetSize, OfABoardThatWasPrintedTwoPercentTooLarge) {
  const std::filesystem::path folder =
      std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/print_scale/declared_two_percent_small";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const Improvement m = improve(read_session(folder), {});
  ASSERT_GE(m.steps.size(), 2u);
  EXPECT_EQ(m.steps[1].added, "target_scale");
  EXPECT_EQ(m.last.verdict, Verdict::adequate) << m.last.reason;
  const Fit& f = m.last.model.fit;
  EXPECT_NEAR(f.effects.at(0).term.values[0], 0.0204, 1e-4);
  EXPECT_LT((f.tcp_from_body.translation - Vector3(58.0896e-3, -3.0187e-3, -51.2470e-3)).norm(), 5e-5);
}

TEST(TargetSize, OfARealBoardIsNotTakenForABend) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/real_square_size";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const Diagnosis d = diagnose(read_session(folder), quick_sizes());
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "target_scale") << d.reason;
  EXPECT_NEAR(d.candidates.front().terms.at(0).values[0], 0.09, 0.01) << "squares of 21.8 mm in place of 20";
}

/// Squares of 22 mm, described as 10: no fit without their size has an answer, and none of its points is wrong.
TEST(TargetSize, OfARealBoardDescribedAtHalfItsSize) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/real_square_size";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  Session session = read_session(folder);
  set_target(session, scaled(*session.target, 0.5));
  EXPECT_TRUE(fit_without_outliers(session, {}).wrong.empty());
  const Diagnosis d = diagnose(session, quick_sizes());
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "target_scale") << d.reason;
  EXPECT_NEAR(d.candidates.front().terms.at(0).values[0], 1.18, 0.03);
  EXPECT_GT(d.attribution.body, 0.9) << "of the target, not of the robot";
}

/// A scale of a thousand is no effect: it is a mistake in the description (blunders/size_blunder.cpp).
TEST(TargetSize, IsNoEffectWhereItIsAMistake) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "field/cameras/real_square_size";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  for (const double factor : {1e-3, 0.1}) {
    Session session = read_session(folder);
    set_target(session, scaled(*session.target, factor));
    const Improvement end = improve(session);
    EXPECT_EQ(end.last.verdict, Verdict::unexplained) << end.last.reason;
    for (const FittedEffect& f : end.last.model.fit.effects)
      EXPECT_FALSE(f.term.id == "target_scale" && f.term.values[0] > 3) << f.term.values[0];
  }
}

/// Two axes through one point keep every place on a sphere: shrunk to nothing all places are the same.
TEST(TargetSize, OfAPositionersTargetIsNotNothing) {
  const std::filesystem::path folder = std::filesystem::path(HANDSIGHT_SHARED_DIR) / "real/positioner_even";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  DiagnosisOptions o = quick_sizes();
  o.with_curves = false;
  const Diagnosis d = diagnose(read_session(folder), o);
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_NE(d.candidates.front().id, "target_scale") << d.reason;
}

TEST(TargetSize, MovesTheTargetsOwnFrame) {
  const SimulatedSession s = printed_larger(target_session(), 0.02);
  const auto right =
      tcp_from_target(simulated(target_session(), {}).session, fit(simulated(target_session(), {}).session));
  const auto found = tcp_from_target(s.session, fitted(s.session, "target_scale"));
  ASSERT_TRUE(right && found);
  EXPECT_LT((right->translation - found->translation).norm(), 2e-4) << "the print's corner, 14 cm off the middle";
}

}  // namespace
}  // namespace handsight
