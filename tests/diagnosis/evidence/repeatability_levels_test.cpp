// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/repeatability_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/evidence/variance_components.h"
#include "estimation/fit/fit.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

constexpr double corner_noise = 0.2;

/// A fitted session with nothing missing, linearised.
LinearModel make_model(int observations) {
  SimulationOptions o;
  o.seed = 7;
  o.observations = observations;
  o.noise = corner_noise;
  const SimulatedSession simulated = simulate_session(fixture::stand_session(), o);
  const Fit f = fit(simulated.session, {});
  return linear_model(with_motions(f.problem), estimate(f), 0, corner_noise);
}

/// The errors drawn again: corner_noise and this scatter.
void draw_errors(const Repeatability& repeatability, std::uint64_t seed, LinearModel& model) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto drawn = [&](Eigen::Index n) {
    Eigen::VectorXd x(n);
    for (double& value : x) value = normal(random);
    return x;
  };
  for (const LinearObservation& o : model.observations) {
    // One by one: the operands of an operator are evaluated in the compiler's order.
    const Eigen::VectorXd place = repeatability.place * o.by_body.leftCols<3>() * drawn(3);
    Eigen::VectorXd of_joints = repeatability.joints * drawn(o.by_joints.cols());
    for (std::size_t j = 0; j < repeatability.of_joint.size(); ++j)
      of_joints[static_cast<Eigen::Index>(j)] *= repeatability.of_joint[j];
    const Eigen::VectorXd joints = o.by_joints * of_joints;
    model.external_error.segment(o.first, o.count) = drawn(o.count) + joints + place;
  }
}

TEST(RepeatabilityLevels, LikelyScatterIsTheOneThatWasDrawn) {
  LinearModel model = make_model(300);
  for (const Repeatability& truth : {Repeatability{4e-4, 0}, Repeatability{1e-3, 3e-4}, Repeatability{2e-4, 5e-4}}) {
    double joints = 0, place = 0;
    constexpr int draws = 8;
    for (int i = 0; i < draws; ++i) {
      draw_errors(truth, 100 + static_cast<std::uint64_t>(i), model);
      const Repeatability found = likely_repeatability(model, {}, {}, true);
      joints += found.joints / draws;
      place += found.place / draws;
    }
    EXPECT_NEAR(joints, truth.joints, 0.15 * truth.joints);
    EXPECT_NEAR(place, truth.place, std::max(0.15 * truth.place, 1e-4));
  }
}

/// Of the fixture's six joints, 1 in the mean of squares.
const std::vector<double> uneven{0.2, 0.3, 2.34, 0.5, 0.2, 0.3};

TEST(RepeatabilityLevels, JointsThatScatterDifferentlyAreToldFromEachOther) {
  LinearModel model = make_model(300);
  constexpr int draws = 16;
  std::vector<double> mean(uneven.size(), 0);
  for (std::uint64_t seed = 21; seed < 21 + draws; ++seed) {
    draw_errors({8e-4, 0, uneven}, seed, model);
    const Repeatability found = likely_of_each_joint(model, {1e-3, 0}).value().repeatability;
    ASSERT_EQ(found.of_joint.size(), uneven.size());
    for (std::size_t j = 0; j < mean.size(); ++j) mean[j] += std::pow(found.joints * found.of_joint[j], 2) / draws;
  }
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(mean[j], std::pow(8e-4 * uneven[j], 2), 2e-7) << j;
  // So little of the others moves a marker by less than the noise: they are taken to be as the first ones.
  for (std::size_t j = 3; j < uneven.size(); ++j) EXPECT_LT(mean[j], std::pow(8e-4, 2)) << j;
}

TEST(RepeatabilityLevels, JointsDifferWhereThatIsClearlyLikelierAndAsLittleAsRobotsDo) {
  LinearModel model = make_model(300);
  int unevenly = 0, evenly = 0, far_too_much = 0;
  const auto are_alike = [&] { return repeatability_levels(model, {}).back().of_joint.empty() ? 1 : 0; };
  for (std::uint64_t seed = 40; seed < 50; ++seed) {
    draw_errors({5e-4, 0, uneven}, seed, model);
    unevenly += 1 - are_alike();
    draw_errors({5e-4, 0}, seed, model);
    evenly += are_alike();
    draw_errors({5e-3, 0, uneven}, seed, model);
    far_too_much += are_alike();
  }
  EXPECT_EQ(unevenly, 10);
  EXPECT_EQ(evenly, 10);
  EXPECT_EQ(far_too_much, 10) << "what is missing, and no scatter";
}

TEST(RepeatabilityLevels, TheJointThatRepeatsWorstIsNamed) {
  const std::vector<std::string> joints{"a1", "a2", "a3", "a4", "a5", "a6"};
  EXPECT_EQ(repeatability_text({8e-4, 0, uneven}, joints), "joints that repeat to 0.8 mrad (a3 to 1.9 mrad)");
  EXPECT_EQ(repeatability_text({8e-4, 0}, joints), "joints that repeat to 0.8 mrad");
}

TEST(RepeatabilityLevels, LikelyScatterDoesNotDependOnWhereTheSearchBegins) {
  LinearModel model = make_model(200);
  draw_errors({7e-4, 3e-4}, 3, model);
  const Repeatability a = likely_repeatability(model, {}, {}, true),
                      b = likely_repeatability(model, {3e-3, 0}, {}, true);
  EXPECT_NEAR(a.joints, b.joints, 0.1 * a.joints);
  EXPECT_NEAR(a.place, b.place, 0.1 * a.place);
}

TEST(RepeatabilityLevels, WhereThePlaceAloneScattersTheJointsHaveNone) {
  LinearModel model = make_model(200);
  for (LinearObservation& o : model.observations) o.by_joints.setZero();
  draw_errors({0, 5e-4}, 13, model);
  const Repeatability found = likely_repeatability(model, {}, {}, true);
  EXPECT_NEAR(found.place, 5e-4, 5e-5);
  EXPECT_EQ(found.joints, 0);
}

TEST(RepeatabilityLevels, WhatIsNegligibleIsNone) {
  LinearModel model = make_model(200);
  model.external_error.setZero();
  EXPECT_EQ(likely_repeatability(model, {}, {}, true), Repeatability{});
}

TEST(RepeatabilityLevels, WhereTheNoiseIsUnknownOnlyTheJointsShare) {
  LinearModel model = make_model(300);
  draw_errors({1e-3, 0}, 5, model);
  const Repeatability found = likely_repeatability(model, {}, {false, 1000}, false);
  EXPECT_NEAR(found.joints, 1e-3, 2e-4);
  EXPECT_EQ(found.place, 0);
}

TEST(RepeatabilityLevels, AreTheUsualOnesWhereNothingScatters) {
  LinearModel model = make_model(100);
  draw_errors({}, 9, model);
  const std::vector<Repeatability> levels = repeatability_levels(model, {});
  EXPECT_EQ(levels.front(), Repeatability{});
  EXPECT_EQ(levels.back(), (Repeatability{3e-3, 0}));
}

TEST(RepeatabilityLevels, EndAtTheScatterThatIsThere) {
  LinearModel model = make_model(200);
  draw_errors({1.7e-3, 6e-4}, 11, model);
  const std::vector<Repeatability> levels = repeatability_levels(model, {});
  EXPECT_EQ(levels.front(), Repeatability{});
  EXPECT_NEAR(levels.back().joints, 1.7e-3, 3e-4);
  EXPECT_NEAR(levels.back().place, 6e-4, 2e-4);
  const auto evidence = [&](const Repeatability& s) { return whiten(model, s, {}).ln_evidence; };
  for (const Repeatability& usual : {Repeatability{1e-3, 0}, Repeatability{3e-3, 0}})
    EXPECT_GT(evidence(levels.back()), evidence(usual));
}

TEST(RepeatabilityLevels, AreToldInWords) {
  EXPECT_EQ(repeatability_text({}), "");
  EXPECT_EQ(repeatability_text({0, 4e-6}), "") << "not worth telling";
  EXPECT_EQ(repeatability_text({1.3e-3, 0}), "joints that repeat to 1.3 mrad");
  EXPECT_EQ(repeatability_text({1.3e-3, 9e-4}),
            "joints that repeat to 1.3 mrad and a hand whose place scatters by 0.9 mm");
  EXPECT_EQ(repeatability_text({0, 9e-4}), "a hand whose place scatters by 0.9 mm");
}

}  // namespace
}  // namespace handsight
