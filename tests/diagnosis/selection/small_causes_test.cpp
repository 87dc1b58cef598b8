// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/small_causes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {
namespace {

/// What may be there instead of the only name of a model, where these effects are hidden.
SmallCauses instead_of(const EffectTerm& model, const std::vector<EffectTerm>& hidden, std::uint64_t seed) {
  const Session session = simulated(hidden, seed, 60);
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = {model};
  const ModelSpace all(diagnose(session, o).model.fit, 0, 3);
  const std::vector<SmallCauses> causes = find_small_causes(all, all.present());
  for (std::size_t n = 0; n < causes.size(); ++n)
    if (all.names()[n].id == model.id) return causes[n];
  return {-1, {}};
}

TEST(SmallCauses, DoNotDoWhatALargeOneDoes) {
  for (const std::uint64_t seed : {21U, 22U, 23U}) {
    EXPECT_LT(instead_of({"joint_elasticity", 1, {0}}, {{"joint_elasticity", 1, {1.5e-4}}}, seed).share, 1e-6) << seed;
    EXPECT_LT(instead_of({"joint_scale", 2, {0}}, {{"joint_scale", 2, {2e-3}}}, seed).share, 1e-6) << seed;
  }
}

std::vector<EffectTerm> zeros_a_little_off(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<EffectTerm> zeros;
  for (int j = 1; j < 6; ++j) zeros.push_back({"joint_offset", j, {3e-4 * normal(random)}});
  return zeros;
}

/// A scale of one joint makes the error smaller where zeros of all joints are a little off; it is not there.
TEST(SmallCauses, AreLikelierThanOneNameWhereAllJointsAreALittleOff) {
  for (const std::uint64_t seed : {21U, 22U, 23U}) {
    const SmallCauses instead = instead_of({"joint_scale", 2, {0}}, zeros_a_little_off(seed), seed);
    EXPECT_GT(instead.share, 0.9) << seed;
    EXPECT_EQ(instead.names, std::vector<std::string>{"joint_offset"}) << seed;
  }
}

TEST(SmallCauses, LeaveChoicesStandingThatTheyCannotBe) {
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = {{"joint_scale", 2, {0}}};
  const auto standing = [&](const std::vector<EffectTerm>& hidden, const Chosen& chosen) {
    return ln_standing(find_small_causes(ModelSpace(diagnose(simulated(hidden, 21, 60), o).model.fit, 0, 3), chosen));
  };
  const Chosen present = ModelSpace(diagnose(simulated({}, 21, 60), o).model.fit, 0, 3).present();
  ASSERT_EQ(present.size(), 1U);
  EXPECT_LT(standing(zeros_a_little_off(21), present), std::log(0.1));
  EXPECT_NEAR(standing({{"joint_scale", 2, {2e-3}}}, present), 0, 1e-6);
  EXPECT_EQ(standing(zeros_a_little_off(21), {}), 0);
}

TEST(SmallCauses, AreOnlyAskedAboutNamesOfTheModel) {
  const Session session = simulated({{"joint_elasticity", 1, {1.5e-4}}}, 21, 60);
  const ModelSpace all(diagnose(session, {}).model.fit, 0, 3);
  for (const SmallCauses& causes : find_small_causes(all, all.present())) EXPECT_EQ(causes.share, 0);
}

}  // namespace
}  // namespace handsight
