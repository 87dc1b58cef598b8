// SPDX-License-Identifier: Apache-2.0
// A large cause over small deviations at each joint: many numbers of another effect take in both.
#include "diagnosis/verdict/small_beside.h"

#include <gtest/gtest.h>

#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/finding.h"
#include "fixtures/field_worlds.h"

namespace handsight {
namespace {

DiagnosisOptions without_held_out() {
  DiagnosisOptions o;
  o.with_held_out = false;
  return o;
}

/// The zero of one joint is 2 degrees off, and every link is a little wrong: what the zero does the links after it do
/// too, and the rest besides, so that alone they are likelier.
TEST(SmallBeside, AZeroComesBeforeTheLinksThatStandInForIt) {
  for (const std::uint64_t seed : {150003U, 150004U}) {
    const trials::World w = trials::world("zero", 40, seed);
    const Diagnosis d = diagnose(w.session, without_held_out());
    ASSERT_FALSE(d.candidates.empty());
    EXPECT_EQ(d.candidates.front().id, "link_geometry") << seed << ": alone";
    const DiagnosisCandidate* finding = finding_of(d);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->id, "joint_offset") << seed;
    EXPECT_NE(finding->explanation.find("Alone link_geometry is likelier"), std::string::npos) << finding->explanation;
    EXPECT_LT(finding->ln_bayes_factor, d.candidates.front().ln_bayes_factor);
    EXPECT_GT(*finding->ln_of_small, *d.candidates.front().ln_of_small);
  }
}

TEST(SmallBeside, ALinkThatIsWrongStaysFirst) {
  for (const std::uint64_t seed : {150001U, 150002U, 150003U, 150004U}) {
    const trials::World w = trials::world("link", 40, seed);
    const Diagnosis d = diagnose(w.session, without_held_out());
    const DiagnosisCandidate* finding = finding_of(d);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->id, "link_geometry") << seed;
  }
}

/// A cause that is not there gains nothing by others that are large, though they are allowed at every joint; that they
/// are shows to first order, before anything is fitted.
TEST(SmallBeside, WhatIsLargeIsNoSmallDeviation) {
  const trials::World w = trials::world("link", 40, 150001);
  const CleanFit plain{w.session, fit(w.session, {}), {}};
  const NoiseModel by = noise_model(plain.fit);
  int fitted = 0;
  const auto refit = [&](const std::vector<EffectTerm>& terms) {
    ++fitted;
    return refit_with(plain, {}, terms, by);
  };
  const Refit wrong = refit({{"encoder_eccentricity", 1, {0, 0}}});
  const Refit right = refit(w.large);
  fitted = 0;
  EXPECT_EQ(gain_by_small_deviations(wrong, refit), 0);
  EXPECT_EQ(fitted, 0);
  EXPECT_GT(gain_by_small_deviations(right, refit), 0);
  EXPECT_GT(fitted, 0);
}

}  // namespace
}  // namespace handsight
