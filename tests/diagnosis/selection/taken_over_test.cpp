// SPDX-License-Identifier: Apache-2.0
// A large cause that leaves a model and comes back as another name's numbers.
#include "diagnosis/selection/taken_over.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "diagnosis/selection/improvement.h"
#include "estimation/fit/fit.h"
#include "fixtures/field_worlds.h"

namespace handsight {
namespace {

Fit fit_with(const Session& session, const std::vector<EffectTerm>& estimated) {
  FitOptions o;
  o.estimated = estimated;
  return fit(session, o);
}

/// The zero of joint 5 turns the links after it, and so does joint 6, were it built wrong by two degrees.
TEST(TakenOver, AZeroByTheLinkAfterIt) {
  const trials::World w = trials::world("zero", 40, 150004);
  const Chain chain = make_chain(w.session);
  const std::vector<EffectTerm> links = effect_terms("link_geometry", chain), zero{{"joint_offset", 4, {0}}};
  std::vector<EffectTerm> both = zero;
  both.insert(both.end(), links.begin(), links.end());
  const Fit with = fit_with(w.session, both), without = fit_with(w.session, links);
  const std::vector<EffectTerm> found{list_terms(with).front()};
  ASSERT_NEAR(found[0].values[0], w.large[0].values[0], 0.01);
  EXPECT_TRUE(is_taken_over(found, with, without));
  // Of usual size, whichever name has it is plausible.
  EXPECT_FALSE(is_taken_over({{"joint_offset", 4, {0.004}}}, with, without));
  // What the measurements cannot do without is not taken over.
  EXPECT_FALSE(is_taken_over(found, with, fit_with(w.session, {})));
  EXPECT_FALSE(is_taken_over(found, with, with));
}

/// With the links beside it the zero had been left out as no longer needed.
TEST(TakenOver, TheZeroStaysInTheModelBesideTheLinks) {
  const trials::World w = trials::world("zero", 40, 150006);
  const Improvement m = improve(w.session, {});
  ASSERT_GT(m.steps.size(), 1U);
  EXPECT_EQ(m.steps[1].added, "joint_offset");
  const std::vector<EffectTerm>& terms = m.last.model_options.estimated;
  const auto has = [&](const std::string& id) {
    return std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& t) { return t.id == id; });
  };
  EXPECT_TRUE(has("joint_offset"));
  EXPECT_TRUE(has("link_geometry"));
}

}  // namespace
}  // namespace handsight
