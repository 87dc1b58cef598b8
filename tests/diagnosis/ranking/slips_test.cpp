// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/slips.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/simulated_stand.h"

namespace handsight {
namespace {

std::vector<EffectTerm> slip(double size) { return {{"mount_slip", -1, {size, 0, -size, 0, 0, 0, 31}}}; }

DiagnosisCandidate slip_found(const Diagnosis& d) {
  for (const DiagnosisCandidate& c : d.candidates)
    if (c.id == "mount_slip") return c;
  return {};
}

TEST(Slips, AreTakenWhereTheyHappened) {
  const Session session = simulated(slip(1e-3), 7);
  const Diagnosis d = diagnosed(session, {});
  const DiagnosisCandidate candidate = slip_found(d);
  ASSERT_TRUE(candidate.refitted);
  EXPECT_NEAR(*slip_order(candidate.terms), 31, 1);
  const ModelChange change = add_candidate(session, {}, d, candidate);
  ASSERT_TRUE(change.model) << (change.refused.empty() ? "" : change.refused[0].reason);
  EXPECT_EQ(change.steps[0].added, "mount_slip");
}

TEST(Slips, AreHeldBackOnThinEvidenceAndSaySo) {
  // Somewhere between what no pose shows and a millimetre a slip is as likely as another cause that would be named.
  int held_back = 0;
  for (double size = 2e-5; size < 4e-4; size *= 1.25) {
    const Session session = simulated(slip(size), 7);
    const Diagnosis d = diagnosed(session, {});
    const DiagnosisCandidate candidate = slip_found(d);
    if (candidate.held_back.empty()) continue;
    ++held_back;
    EXPECT_LT(candidate.ln_bayes_factor, d.threshold);
    EXPECT_NE(d.verdict, Verdict::missing_effect) << d.reason;
    EXPECT_NE(candidate.explanation.find("Not named: "), std::string::npos) << candidate.explanation;
    const ModelChange change = add_candidate(session, {}, d, candidate);
    EXPECT_FALSE(change.model);
    ASSERT_EQ(change.refused.size(), 1u);
    EXPECT_EQ(change.refused[0].reason, candidate.held_back);
  }
  EXPECT_GT(held_back, 0);
}

TEST(Slips, HaveOddsAgainstThemAsDriftsHave) {
  EXPECT_EQ(ln_odds_against({"mount_slip", -1, {0, 0, 0, 0, 0, 0, 5}}), ln_odds_against_slip);
  EXPECT_EQ(ln_odds_against({"mount_drift", -1, {0, 0, 0, 0, 0, 0, 0}}), ln_odds_against_drift);
  EXPECT_EQ(ln_odds_against({"joint_offset", 0, {0}}), 0);
}

TEST(Slips, ADriftWithoutANameHasTheOddsOfOneAndComesBehindIt) {
  EXPECT_EQ(ln_odds_of_unnamed_along({.kind = VariableKind::time}), ln_odds_of_unnamed - ln_odds_against_drift);
  EXPECT_EQ(ln_odds_of_unnamed_along({.kind = VariableKind::angle}), ln_odds_of_unnamed);
  const Diagnosis d = diagnosed(simulated({{"mount_drift", -1, {6e-4, -5e-4, 0, 0, 0, 3e-4, 0}}}, 11), {});
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "mount_drift");
  const auto of_time = std::find_if(d.candidates.begin(), d.candidates.end(), [](const DiagnosisCandidate& c) {
    return c.unnamed && c.unnamed->empirical_error.variable->kind == VariableKind::time;
  });
  ASSERT_NE(of_time, d.candidates.end());
  EXPECT_LT(of_time->ln_bayes_factor, d.candidates.front().ln_bayes_factor);
}

TEST(Slips, OneSideOfWhichGainsNothingIsNotConfirmed) {
  // The residuals of a few observations at one end of the session are not those of a jump.
  Session session = simulated({}, 8);
  for (Observation& o : session.observations)
    if (o.id >= 58)
      for (Eigen::Index j = 0; j < o.position.size(); ++j) o.position[j] += 4e-4;
  const CleanFit plain{session, fit(session, {}), {}};
  FitOptions options;
  options.estimated = {{"mount_slip", -1, {0, 0, 0, 0, 0, 0, 30}}};
  const Fit with = fit(session, options);
  EXPECT_FALSE(slip_is_confirmed(session, plain.fit, {}, with, options, 30));
}

}  // namespace
}  // namespace handsight
