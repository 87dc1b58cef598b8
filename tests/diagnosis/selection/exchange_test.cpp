// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/exchange.h"

#include <gtest/gtest.h>

#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"

namespace handsight {
namespace {

Diagnosis exchanged_from(const Session& session, const std::vector<EffectTerm>& terms) {
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = terms;
  return diagnose(session, o);
}

std::optional<Exchange> for_the_first(const Diagnosis& model, bool goes_on = true) {
  return better_name(model, 0, 1, [=] { return goes_on; });
}

TEST(BetterName, TakesThePlaceOfOneThatStandsInForIt) {
  // Over its range of angles an eccentric encoder draws nearly the line of a scale.
  const Session session = simulated({{"joint_scale", 1, {3e-3}}}, 3);
  const Diagnosis wrong = exchanged_from(session, {{"encoder_eccentricity", 1, {0, 0}}});
  const auto exchange = for_the_first(wrong);
  ASSERT_TRUE(exchange);
  EXPECT_EQ(exchange->id, "joint_scale");
  ASSERT_EQ(exchange->terms.size(), 1u);
  EXPECT_EQ(exchange->terms[0].place, 1);
  EXPECT_NEAR(exchange->terms[0].values[0], 3e-3, 3e-4);
  ASSERT_EQ(exchange->options.estimated.size(), 1u) << "the old name is gone";
  EXPECT_EQ(exchange->options.estimated[0].id, "joint_scale");
}

TEST(BetterName, LeavesTheRightOneWhereItIs) {
  const std::vector<EffectTerm> right = {{"encoder_eccentricity", 1, {1.5e-3, -1e-3}}};
  EXPECT_FALSE(for_the_first(exchanged_from(simulated(right, 4), {{"encoder_eccentricity", 1, {0, 0}}})));
}

TEST(BetterName, SaysNothingOnceItIsStopped) {
  const Session session = simulated({{"joint_scale", 1, {3e-3}}}, 3);
  EXPECT_FALSE(for_the_first(exchanged_from(session, {{"encoder_eccentricity", 1, {0, 0}}}), false));
}

}  // namespace
}  // namespace handsight
