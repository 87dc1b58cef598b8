// SPDX-License-Identifier: Apache-2.0
#include "compare/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compare/change_evidence.h"
#include "estimation/report/fit_report.h"
#include "fixtures/random_robot.h"
#include "simulation/simulated_session.h"

namespace handsight {
namespace {

/// Two sessions of one robot that has these effects in both, and the change in the second.
std::pair<Session, Session> two_sessions(std::uint64_t seed, const std::vector<std::string>& hidden,
                                         const std::vector<std::string>& change) {
  const Session like = fixture::seen_random_session(seed);
  SimulationOptions o;
  o.observations = 120;
  o.seed = seed;
  o.noise = 0.2;
  o.farthest = 3;
  o.declare_noise = false;
  for (const std::string& text : hidden) add_effect_value(text, like.robot, o.effects);
  std::pair<Session, Session> pair{simulate_session(like, o).session, {}};
  for (const std::string& text : change) add_effect_value(text, like.robot, o.effects);
  pair.second = simulate_session(like, o).session;
  pair.first.observations.resize(60);
  pair.second.observations.erase(pair.second.observations.begin(), pair.second.observations.begin() + 60);
  return pair;
}

std::string moving_joint(std::uint64_t seed, std::size_t number) {
  return fixture::seen_random_session(seed).joints.at(number);
}

/// What the model lacks on both sides alike: a spring and an eccentric encoder.
std::vector<std::string> lacking(std::uint64_t seed) {
  return {"joint_elasticity:" + moving_joint(seed, 1) + ".compliance=1.5e-4",
          "encoder_eccentricity:" + moving_joint(seed, 2) + ".sine=3e-3",
          "encoder_eccentricity:" + moving_joint(seed, 3) + ".cosine=2e-3"};
}

TEST(Comparison, WhatTheModelLacksInBothIsNotToldAsAChange) {
  for (const std::uint64_t seed : {31u, 32u, 33u}) {
    const auto [before, after] = two_sessions(seed, lacking(seed), {});
    const Comparison c = compare(before, after);
    EXPECT_EQ(c.verdict, ComparisonVerdict::unchanged) << seed << ": " << c.sentence;
    EXPECT_FALSE(c.model_fits);
  }
}

TEST(Comparison, AChangeIsNamedBesideWhatTheModelLacks) {
  for (const std::uint64_t seed : {31u, 32u}) {
    const auto [before, after] = two_sessions(seed, lacking(seed), {"camera_mount:rx=0.004", "camera_mount:y=0.002"});
    const Comparison c = compare(before, after);
    EXPECT_EQ(c.verdict, ComparisonVerdict::changed) << seed << ": " << c.sentence;
    ASSERT_FALSE(c.changes.empty());
    EXPECT_EQ(c.changes.front().id, "camera_mount");
    ASSERT_EQ(c.changes.front().sigma.size(), 6);
    const std::vector<double>& values = c.changes.front().terms.front().values;
    // Four sigma: the shared errors are a model of what is lacking, not the truth.
    EXPECT_NEAR(values[3], 0.004, 4 * c.changes.front().sigma[3]);
    EXPECT_NEAR(values[1], 0.002, 4 * c.changes.front().sigma[1]);
  }
}

TEST(Comparison, ARightModelIsNotMadeWider) {
  const auto [before, after] = two_sessions(35, {}, {});
  const Comparison c = compare(before, after);
  EXPECT_EQ(c.verdict, ComparisonVerdict::unchanged) << c.sentence;
  EXPECT_TRUE(c.model_fits);
}

TEST(Comparison, TellsHowFarItIsAndStopsWhereItIsTold) {
  const auto [before, after] = two_sessions(35, {}, {});
  std::vector<double> shares;
  compare(before, after, {}, [&](double share) {
    shares.push_back(share);
    return true;
  });
  EXPECT_GT(shares.size(), 10u);
  EXPECT_GE(*std::max_element(shares.begin(), shares.end()), 0.7);
  for (const std::size_t calls : {std::size_t{1}, shares.size() / 2, shares.size() - 1}) {
    std::size_t asked = 0;
    EXPECT_THROW(compare(before, after, {}, [&](double) { return ++asked < calls; }), InputError) << calls;
    EXPECT_LE(asked, calls + 3) << "it goes on for long";
  }
}

TEST(Comparison, ResidualsAgainstACalibrationShowWhatChanged) {
  const auto [before, after] = two_sessions(35, {}, {"camera_mount:rx=0.004"});
  const FitOptions options;
  const Fit f = fit(before, options);
  const CalibratedRobot robot = calibrated_robot(before, f, report(before, f, options), options, "test");
  const auto rms = [](const std::vector<CalibrationResidual>& all) {
    double squares = 0;
    for (const CalibrationResidual& r : all) squares += r.corner.residual.squaredNorm();
    return std::sqrt(squares / (2.0 * static_cast<double>(all.size())));
  };
  const auto own = compute_residuals(robot, before), changed = compute_residuals(robot, after);
  EXPECT_NEAR(rms(own), f.residual_rms, 0.02 * f.residual_rms) << "the fit itself, evaluated anew";
  EXPECT_GT(rms(changed), 5 * rms(own));
  EXPECT_EQ(changed.back().observation, static_cast<int>(after.observations.size()) - 1);
}

TEST(Comparison, ASessionWithoutAnAnswerIsRefusedByName) {
  auto [before, after] = two_sessions(36, {}, {});
  // The camera's mount turned right round: every marker that it saw would lie behind it.
  after.mount.estimate = before.mount.estimate = false;
  after.mount.mount_from_sensor.rotation *= Vector3(1, -1, -1).asDiagonal();
  ASSERT_FALSE(fit(after).converged());
  try {
    compare(before, after);
    FAIL() << "compared";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("second session finds no answer"), std::string::npos) << e.what();
  }
}

TEST(ChangeEvidence, IsThatOfAKnownNormal) {
  // One number with information 100 and score 50: ln BF = mean over scales s of exp(b^2 s^2 / (2 (1 + s^2 A))) / sqrt(1
  // + s^2 A).
  double sum = 0;
  for (std::size_t i = 0; i < prior_scales.size(); ++i) {
    const double s = prior_scales[i];
    sum += scale_shares[i] * std::exp(0.5 * 2500 * s * s / (1 + 100 * s * s)) / std::sqrt(1 + 100 * s * s);
  }
  const Eigen::MatrixXd information = Eigen::MatrixXd::Constant(1, 1, 100);
  EXPECT_NEAR(change_evidence(information, Eigen::VectorXd::Constant(1, 50)), std::log(sum), 1e-12);
}

}  // namespace
}  // namespace handsight
