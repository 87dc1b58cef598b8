// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/curves/empirical_errors.h"

#include <gtest/gtest.h>

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/ranking/ranking.h"
#include "diagnosis/simulated_stand.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"

namespace handsight {
namespace {

EffectTerm hidden(const std::string& scope, const std::string& site, const std::string& formula, int joint,
                  double size) {
  EffectDefinition d;
  d.id = "hidden";
  d.scope = scope;
  d.parameters.push_back({"size", scope == "joint" ? "rad" : "m", 1e-3});
  d.moves.push_back({site, "size*(" + formula + ")", 0});
  const auto effect = own_effect(d, like_stand().robot);
  EffectTerm term = term_of(*effect, joint, effect);
  term.values[0] = size;
  return term;
}

EmpiricalError best_of(const Session& session) {
  const Fit f = fit(session, {});
  Candidates none = all_candidates(f.problem);
  const LinearModel model = linear_model(none.problem, estimate(f), none.base_effects, 0.2);
  const std::vector<Variable> variables = list_variables(none.problem, estimate(f));
  const WhitenedModel w = whiten(model, {}, {});
  std::vector<EmpiricalError> all = localise(w, {}, none.problem, variables);
  return *std::max_element(all.begin(), all.end(),
                           [](const auto& a, const auto& b) { return a.ln_bayes_factor < b.ln_bayes_factor; });
}

TEST(Localise, FindsVariableAndSiteOfAShiftOfTheHand) {
  const Session session = simulated({hidden("session", "hand_y", "sin(2.7*q_a4 + 0.4)", -1, 6e-4)}, 21, 80);
  const EmpiricalError found = best_of(session);
  EXPECT_EQ(found.variable->kind, VariableKind::angle);
  EXPECT_EQ(found.variable->joint, 3);
  EXPECT_EQ(found.best.site, EmpiricalErrorSite::tcp);
  EXPECT_GT(found.best.ln_bayes_factor, 20);
}

TEST(Localise, FindsTheJointThatItselfErrs) {
  const Session session = simulated({hidden("joint", "angle", "cos(3*q)", 1, 1e-3)}, 22, 80);
  const EmpiricalError found = best_of(session);
  EXPECT_EQ(found.variable->joint, 1);
  EXPECT_EQ(found.best.site, EmpiricalErrorSite::joint);
  EXPECT_EQ(found.best.joint, 1);
}

TEST(Localise, FindsNothingInNoise) { EXPECT_LT(best_of(simulated({}, 23, 80)).ln_bayes_factor, 3); }

}  // namespace
}  // namespace handsight
