// SPDX-License-Identifier: Apache-2.0
// Priors have heavy tails: what the measurements determine is not held back, however large it is.
#include "estimation/fit/prior_widths.h"

#include <gtest/gtest.h>

#include "estimation/fit/fit.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

EffectTerm offset(int joint, double value) {
  EffectTerm term = term_of(*find_effect("joint_offset"), joint);
  term.values = {value};
  return term;
}

Fit fitted(const Session& session, const std::string& effects) {
  FitOptions options;
  options.estimated = effect_terms(effects, make_chain(session));
  return fit(session, options);
}

SimulatedSession with_offsets(const std::vector<EffectTerm>& offsets, bool declared = true) {
  SimulationOptions options;
  options.observations = 25;
  options.seed = 7;
  options.effects = offsets;
  options.declare_noise = declared;
  return simulate_session(fixture::stand_session(4), options);
}

/// Four degrees are fourteen prior sigmas.
TEST(PriorWidths, AnOffsetOfDegreesIsFoundWhole) {
  for (const bool declared : {true, false}) {
    const Fit f = fitted(with_offsets({offset(1, 0.07), offset(2, -0.05)}, declared).session, "joint_offset:a2+a3");
    ASSERT_TRUE(f.converged());
    EXPECT_NEAR(f.effects[0].term.values[0], 0.07, 4 * f.effects[0].sigmas[0]);
    EXPECT_NEAR(f.effects[1].term.values[0], -0.05, 4 * f.effects[1].sigmas[0]);
    for (const EffectColumn& c : f.problem.columns_of_effects) EXPECT_GT(c.width, 1);
  }
}

/// Against the answer of priors that hold nothing.
TEST(PriorWidths, WhatIsDeterminedIsWithinATenthOfASigmaOfTheFreeAnswer) {
  const SimulatedSession s = with_offsets({offset(1, 0.07), offset(2, -0.05), offset(4, 0.002)});
  const Fit held = fitted(s.session, "joint_offset:a2+a3+a5");
  Problem free = held.problem;
  for (EffectColumn& c : free.columns_of_effects) c.width = 1e4;
  const Solution answer = solve(free, estimate(held));
  for (std::size_t i = 0; i < held.effects.size(); ++i)
    EXPECT_NEAR(held.effects[i].term.values[0], answer.unknowns.effects[static_cast<Eigen::Index>(i)],
                0.1 * held.effects[i].sigmas[0])
        << i;
}

TEST(PriorWidths, InACircleEachKeepsItsWidest) {
  Problem problem;
  problem.columns_of_effects.resize(3);
  const auto set = [&](const Widths& widths) {
    for (std::size_t c = 0; c < widths.size(); ++c) problem.columns_of_effects[c].width = widths[c];
  };
  std::vector<Widths> before{{25, 1, 1}};  // not of the circle
  for (const Widths& next : {Widths{1, 5, 1}, Widths{5, 1, 1}}) {
    set(next);
    EXPECT_FALSE(end_circle(before, problem));
    EXPECT_EQ(list_widths(problem), next);
  }
  set({1, 5, 1});
  EXPECT_TRUE(end_circle(before, problem));
  EXPECT_EQ(list_widths(problem), (Widths{5, 5, 1}));
}

/// A fit of a candidate ends with the widths that its values ask for, so that they need not be settled again.
TEST(PriorWidths, AQuickFitHasThoseOfItsValues) {
  const Session s = with_offsets({offset(1, 0.07), offset(2, -0.05), offset(4, 0.002)}).session;
  FitOptions options;
  options.estimated = effect_terms("joint_offset:a2+a3+a5", make_chain(s));
  options.least_gain = 1e-4 * 0.2 * 0.2;
  Fit quick = fit(s, options);
  ASSERT_TRUE(quick.converged());
  EXPECT_FALSE(take_widths_of_values(quick.problem, quick.solution));
  EXPECT_GT(quick.problem.columns_of_effects[0].width, 1);
  EXPECT_GT(quick.problem.columns_of_effects[1].width, 1);
  EXPECT_EQ(quick.problem.columns_of_effects[2].width, 1);
  const Fit exact = fitted(s, "joint_offset:a2+a3+a5");
  for (std::size_t i = 0; i < exact.effects.size(); ++i)
    EXPECT_NEAR(quick.effects[i].term.values[0], exact.effects[i].term.values[0], 0.1 * exact.effects[i].sigmas[0]);
}

TEST(PriorWidths, WhatIsNotThereKeepsItsPlausibleSize) {
  const Fit f = fitted(with_offsets({}).session, "joint_offset");
  for (const EffectColumn& c : f.problem.columns_of_effects) EXPECT_EQ(c.width, 1);
}

/// What the measurements cannot show stays at nothing: a wide prior is not a licence to wander.
TEST(PriorWidths, WhatIsNotSeenStaysNarrow) {
  const Fit f = fitted(with_offsets({offset(1, 0.07)}).session, "joint_offset:a2+a6");
  for (const FittedEffect& e : f.effects)
    if (e.term.place == 5) EXPECT_LT(std::abs(e.term.values[0]), 0.01);
}

/// Without declared noise and without what tells it, priors are weighed against what is left, not against a guess.
TEST(PriorWidths, AGuessedNoiseFollowsWhatIsLeft) {
  SimulationOptions options;
  options.observations = 40;
  options.seed = 3;
  options.noise = 2e-5;
  options.declare_noise = false;
  options.effects = {offset(1, 0.002), offset(3, -0.001)};
  const SimulatedSession s = simulate_session(fixture::tracker_session(1), options);
  const Fit f = fitted(s.session, "joint_offset");
  EXPECT_TRUE(f.problem.noise_is_guessed);
  EXPECT_NEAR(f.problem.noise, 2e-5, 5e-6);
}

}  // namespace
}  // namespace handsight
