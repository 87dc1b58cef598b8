// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/knowledge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "session/session_xml.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

Session seen_in(int observations) {
  const Session like =
      read_session(std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / "one_camera" / "session.xml");
  SimulationOptions options;
  options.observations = observations;
  options.seed = 3;
  return simulate_session(like, options).session;
}

/// A camera whose mount is not known, a board whose place on the hand is not: one look determines neither.
TEST(Knowledge, TheHandHasNoLimitWhileItIsNotDetermined) {
  const Session many = seen_in(12);
  const std::vector<Eigen::VectorXd> poses{many.observations[0].position};
  EXPECT_FALSE(assess_knowledge(seen_in(1), {}, false, poses).hand_limit);
  const Knowledge known = assess_knowledge(many, {}, false, poses);
  ASSERT_TRUE(known.hand_limit);
  EXPECT_GT(*known.hand_limit, 1e-6);
}

DiagnosisCandidate cause(const std::string& id, double ln_bayes_factor) {
  DiagnosisCandidate c;
  c.id = id;
  c.terms = {{id, 1, {0}}};
  c.ln_bayes_factor = ln_bayes_factor;
  c.refitted = true;
  c.explained = 0.9;
  return c;
}

DiagnosisCandidate curve(double ln_bayes_factor, double explained) {
  DiagnosisCandidate c;
  c.unnamed.emplace();
  c.ln_bayes_factor = ln_bayes_factor;
  c.explained = explained;
  return c;
}

double odds_of_best(std::vector<DiagnosisCandidate> candidates) {
  Diagnosis d;
  d.verdict = Verdict::missing_effect;
  d.threshold = 5;
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.ln_bayes_factor > b.ln_bayes_factor; });
  d.candidates = std::move(candidates);
  const SettledCause settled = settled_cause(d);
  EXPECT_EQ(settled.id, "joint_scale");
  return settled.odds;
}

TEST(Knowledge, OddsAreAgainstAllOtherCausesTogether) {
  const DiagnosisCandidate best = cause("joint_scale", 10);
  EXPECT_NEAR(odds_of_best({best}), std::exp(10), 1e-6 * std::exp(10)) << "against none";
  EXPECT_NEAR(odds_of_best({best, cause("joint_offset", 6), cause("joint_elasticity", 6)}), std::exp(4) / 2, 0.1);
  DiagnosisCandidate same = best;
  same.indistinguishable_from = {"joint_offset"};
  EXPECT_GT(odds_of_best({same, cause("joint_offset", 6)}), 1e4) << "what cannot be told apart is no rival";
}

/// Without a way to be told an experiment that was asked for odds alone would go on for ever.
TEST(Knowledge, WhatHasNoNameIsTheCauseWhereItLeads) {
  Diagnosis d;
  d.verdict = Verdict::unexplained;
  d.threshold = 5;
  Variable angle;
  angle.name = "angle of a3";
  DiagnosisCandidate leads = curve(20, 1);
  leads.unnamed->empirical_error.variable = std::make_shared<const Variable>(angle);
  d.candidates = {leads, cause("joint_scale", 12), cause("joint_offset", 12)};
  SettledCause settled = settled_cause(d);
  EXPECT_EQ(settled.id, "");
  ASSERT_TRUE(settled.follows);
  EXPECT_EQ(settled.follows->english(), "angle of a3");
  EXPECT_NEAR(settled.odds, std::exp(8) / 2, 1) << "against all names together";
  d.candidates[0].ln_bayes_factor = 4;
  EXPECT_EQ(settled_cause(d).id, "joint_scale");
  d.candidates = {d.candidates[0]};
  EXPECT_FALSE(settled_cause(d).follows) << "below the threshold nothing is";
}

/// What is hidden may have no name: most hidden curves were told as the effect of the catalogue that came nearest.
TEST(Knowledge, OddsAreAgainstWhatHasNoNameToo) {
  const DiagnosisCandidate best = cause("joint_scale", 10);
  DiagnosisCandidate explains_less = best;
  explains_less.explained = 0.5;
  EXPECT_NEAR(odds_of_best({explains_less, curve(8, 1)}), std::exp(2), 0.1);
  EXPECT_NEAR(odds_of_best({best, curve(8, 0.95)}), std::exp(10), 1e-6 * std::exp(10))
      << "it is the name for the curve";
}

}  // namespace
}  // namespace handsight
