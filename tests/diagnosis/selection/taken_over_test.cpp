// SPDX-License-Identifier: Apache-2.0
// A large cause that leaves a model and comes back as another name's numbers.
#include "diagnosis/selection/taken_over.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "diagnosis/selection/improvement.h"
#include "estimation/fit/fit.h"
#include "fixtures/field_worlds.h"

namespace handsight {
namespace {

FitOptions estimating(const std::vector<EffectTerm>& terms) {
  FitOptions o;
  o.estimated = terms;
  return o;
}

/// The zero of joint 5 turns the links after it, and so does joint 6, were it built wrong by two degrees.
TEST(TakenOver, AZeroByTheLinkAfterIt) {
  const trials::World w = trials::world("zero", 40, 150004);
  const Chain chain = make_chain(w.session);
  const std::vector<EffectTerm> links = effect_terms("link_geometry", chain), zero{{"joint_offset", 4, {0}}};
  std::vector<EffectTerm> both = zero;
  both.insert(both.end(), links.begin(), links.end());
  const Fit with = fit(w.session, estimating(both)), without = fit(w.session, estimating(links));
  const auto is_taken = [&](const std::vector<EffectTerm>& gone, const Fit& rest) {
    return is_taken_over(gone, w.session, estimating(both), with, rest);
  };
  const std::vector<EffectTerm> found{list_terms(with).front()};
  ASSERT_NEAR(found[0].values[0], w.large[0].values[0], 0.01);
  EXPECT_TRUE(is_taken(found, without));
  // Of usual size, whichever name has it is plausible.
  EXPECT_FALSE(is_taken({{"joint_offset", 4, {0.004}}}, without));
  // What the measurements cannot do without is not taken over.
  EXPECT_FALSE(is_taken(found, fit(w.session, {})));
  EXPECT_FALSE(is_taken(found, with));
}

/// With the links beside it the zero had been left out as no longer needed, or given way to the scale of a joint (of 80
/// poses together with a zero that is a little off, which is needed) or to the one link that was not in the model yet.
TEST(TakenOver, TheZeroStaysInTheModelBesideTheLinks) {
  for (const auto& [poses, seed] : {std::pair{40, 150006U}, std::pair{80, 150005U}, std::pair{40, 130004U}}) {
    const trials::World w = trials::world("zero", poses, seed);
    const Improvement m = improve(w.session, {});
    ASSERT_GT(m.steps.size(), 1U);
    EXPECT_EQ(m.steps[1].added, "joint_offset");
    const std::vector<EffectTerm>& terms = m.last.model_options.estimated;
    const auto has = [&](const std::string& id, int place) {
      return std::any_of(terms.begin(), terms.end(),
                         [&](const EffectTerm& t) { return t.id == id && (place < 0 || t.place == place); });
    };
    EXPECT_TRUE(has("joint_offset", w.large.front().place)) << seed;
    EXPECT_TRUE(has("link_geometry", -1)) << seed;
  }
}

}  // namespace
}  // namespace handsight
