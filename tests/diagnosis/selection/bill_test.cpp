// SPDX-License-Identifier: Apache-2.0
// The bill: what a cause is worth at the hand is how far the hand moves with it, its sigma is how far that differs from
// one measurement to the next, and what no robot is built like is reported.
#include "diagnosis/selection/bill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/simulated_stand.h"
#include "diagnosis/story/story.h"
#include "diagnosis/verdict/diagnosis.h"
#include "estimation/report/prediction.h"

namespace handsight {
namespace {

const EffectTerm spring = {"joint_elasticity", 1, {1.5e-4}};
const EffectTerm scale = {"joint_scale", 2, {1e-3}};

Fit fitted(const Session& session, std::vector<EffectTerm> terms) {
  for (EffectTerm& t : terms) std::fill(t.values.begin(), t.values.end(), 0.0);
  FitOptions o;
  o.estimated = std::move(terms);
  return fit(session, o);
}

const BillRow& find_row(const std::vector<BillRow>& rows, const std::string& id) {
  for (const BillRow& row : rows)
    if (row.id == id) return row;
  ADD_FAILURE() << "no row of " << id;
  return rows.front();
}

/// How far the body's origin moves with a cause, by predictions with and without it: root mean square about the mean.
/// The sensor stands still here, so that its frame and the root's measure the same.
double moved_by(const Session& session, const Fit& fit, const PredictionModel& with, const std::string& id) {
  PredictionModel without = with;
  std::erase_if(without.effects, [&](const EffectTerm& t) { return t.id == id; });
  const Chain chain = make_chain(session);
  std::vector<Vector3> moved;
  Vector3 mean = Vector3::Zero();
  for (const Observation& o : session.observations) {
    const Vector3 body = fit.tcp_from_body.translation;
    moved.push_back(predict_tcp(chain, o.position, with).root_from_tcp_est * body -
                    predict_tcp(chain, o.position, without).root_from_tcp_est * body);
    mean += moved.back() / static_cast<double>(session.observations.size());
  }
  if (!session.mount.estimate) mean.setZero();  // what is the same in all poses is the cause's, too
  double squares = 0;
  for (const Vector3& m : moved) squares += (m - mean).squaredNorm();
  return std::sqrt(squares / static_cast<double>(moved.size()));
}

/// The prediction that the truth would make.
PredictionModel prediction_of(const std::vector<EffectTerm>& truth, const Fit& fit) {
  PredictionModel model;
  model.effects = truth;
  model.tcp_from_body = fit.tcp_from_body;
  model.covariance = Eigen::MatrixXd::Zero(7, 7);
  return model;
}

TEST(Bill, TellsHowFarTheHandMovesWithEachCause) {
  const Session session = simulated({spring, scale}, 3);
  const Fit f = fitted(session, {spring, scale});
  const std::vector<BillRow> rows = make_bill(f);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_GE(rows[0].hand_m, rows[1].hand_m) << "what is worth most comes first";
  for (const BillRow& row : rows) {
    const double expected = moved_by(session, f, prediction_model(f), row.id);
    ASSERT_GT(expected, 1e-4) << row.id;
    EXPECT_NEAR(row.hand_m, expected, 0.01 * expected) << row.id;
    EXPECT_GT(row.hand_sigma_m, 0) << row.id;
    EXPECT_FALSE(row.stands_in()) << row.id;
    EXPECT_FALSE(row.probability) << "nobody has looked";
  }
  EXPECT_EQ(find_row(rows, "joint_elasticity").where, std::vector<std::string>{session.robot.joints[1].name});
}

/// Against the truth of each of forty measurements, on its own poses.
TEST(Bill, ItsSigmaIsHowFarItIsFromTheTruth) {
  constexpr int trials = 40;
  double squares = 0;
  for (int seed = 1; seed <= trials; ++seed) {
    const Session session = simulated({spring}, static_cast<std::uint64_t>(100 + seed), 20);
    const Fit f = fitted(session, {spring});
    const BillRow row = make_bill(f).front();
    const double truth = moved_by(session, f, prediction_of({spring}, f), "joint_elasticity");
    ASSERT_GT(row.hand_sigma_m, 0);
    squares += std::pow((row.hand_m - truth) / row.hand_sigma_m, 2) / trials;
  }
  // A chi-squared of 40 degrees lies within these in 999 of 1000 series.
  EXPECT_GT(std::sqrt(squares), 0.68);
  EXPECT_LT(std::sqrt(squares), 1.40);
}

/// Cameras that have moved since they were calibrated: where they tell the hand to be differs, though it has not moved.
TEST(Bill, CamerasAreWorthWhatTheyMisplaceTheHand) {
  const EffectTerm rig = {"stereo_rig", -1, {0, 0, 0, 0, 0.002, 0}};
  const Session session = simulated({rig}, 4, 30);
  const BillRow row = make_bill(fitted(session, {rig})).front();
  EXPECT_EQ(row.id, "stereo_rig");
  // Turned against each other by 2 mrad, cameras half a metre and more away are wrong by millimetres of depth.
  EXPECT_GT(row.hand_m, 1e-3);
  EXPECT_LT(row.hand_m, 0.1);
  EXPECT_GT(row.hand_sigma_m, 0);
  EXPECT_LT(row.hand_sigma_m, 0.3 * row.hand_m);
}

TEST(Bill, WhatNoRobotIsBuiltLikeStandsIn) {
  const EffectTerm pushes = {"joint_elasticity", 1, {-1.5e-4}};
  const Fit back = fitted(simulated({pushes}, 6), {pushes});
  const BillRow spring_row = make_bill(back).front();
  EXPECT_TRUE(spring_row.pushes_back && spring_row.stands_in());
  ASSERT_EQ(stand_ins(back).size(), 1U) << "as the story says it";
  Fit heavy = fitted(simulated({spring}, 6), {spring});
  heavy.effects[0].term.values[0] = 10 * largest_built * find_effect("joint_elasticity")->parameters[0].sigma;
  EXPECT_TRUE(make_bill(heavy).front().too_large);
  FitOptions o;
  o.effects = {pushes};
  const BillRow held = make_bill(fit(simulated({pushes}, 6), o)).front();
  EXPECT_TRUE(held.held);
  EXPECT_FALSE(held.stands_in()) << "what the user holds is the user's word";
  EXPECT_EQ(held.hand_sigma_m, 0);
}

/// One spring that pushes back makes the others of the arm no less sure.
TEST(Bill, WhatStandsInAtOnePlaceIsToldThere) {
  const EffectTerm pushes = {"joint_elasticity", 1, {-1.5e-4}}, gives_way = {"joint_elasticity", 2, {2e-4}};
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = {pushes, gives_way};
  const Diagnosis d = diagnose(simulated({pushes, gives_way}, 6), o);
  const InclusionProbabilities c = inclusion_probabilities(d, 0, [] { return true; });
  const BillRow row = make_bill(d.model.fit, &c).front();
  EXPECT_TRUE(row.pushes_back);
  EXPECT_EQ(row.stands_in_at, std::vector<std::string>{d.model.session.robot.joints[1].name});
  EXPECT_GT(row.probability.value_or(0), 0.9);
  EXPECT_THAT(bill_lines({row})[1], testing::HasSubstr("stands in at " + row.stands_in_at.front()));

  o.estimated = {pushes};
  const Diagnosis alone = diagnose(simulated({pushes}, 6), o);
  const InclusionProbabilities of_one = inclusion_probabilities(alone, 0, [] { return true; });
  const BillRow only = make_bill(alone.model.fit, &of_one).front();
  EXPECT_TRUE(only.stands_in_at.empty());
  EXPECT_LE(only.probability.value_or(1), 0.05);
}

/// A joint that stands in two places alone cannot tell a wrong scale from an eccentric encoder: both add two numbers
/// to it. Where it stands everywhere they differ.
TEST(Bill, TellsWhatThePosesCannotTellApart) {
  const EffectTerm wrong_scale = {"joint_scale", 2, {4e-3}};
  const auto told_from = [&](const Session& session) {
    DiagnosisOptions o;
    o.with_held_out = false;
    o.estimated = {{"joint_scale", 2, {0}}};
    const Diagnosis d = diagnose(session, o);
    const InclusionProbabilities c = inclusion_probabilities(d, 0, [] { return true; });
    const std::vector<BillRow> rows = make_bill(d.model.fit, &c);
    EXPECT_TRUE(rows.front().probability && *rows.front().probability > 0.5);
    return rows.front().indistinguishable_from.value_or(std::vector<std::string>{"not looked at"});
  };
  EXPECT_THAT(told_from(simulated({wrong_scale}, 8, 60)), testing::Not(testing::Contains("encoder_eccentricity")));
  Session two = like_stand();
  two.robot.joints[2].lower = 0.5;
  two.robot.joints[2].upper = 0.6;
  EXPECT_THAT(told_from(simulated({wrong_scale}, 8, 60, two)), testing::Contains("encoder_eccentricity"));
}

TEST(Bill, IsAlsoALineARow) {
  const std::vector<BillRow> rows = {{.id = "joint_elasticity",
                                      .where = {"a2", "a3"},
                                      .hand_m = 5.814e-3,
                                      .hand_sigma_m = 2.3e-5,
                                      .probability = 0.9995,
                                      .indistinguishable_from = std::vector<std::string>{}},
                                     {.id = "payload",
                                      .hand_m = 1.2e-3,
                                      .hand_sigma_m = 4e-4,
                                      .too_large = true,
                                      .probability = 0.87,
                                      .indistinguishable_from = std::vector<std::string>{"base_tilt"}}};
  const std::vector<std::string> lines = bill_lines(rows);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[1], testing::HasSubstr("5.814 +- 0.023 mm"));
  EXPECT_THAT(lines[1], testing::StartsWith("joint_elasticity (a2 and a3) "));
  EXPECT_THAT(lines[1], testing::HasSubstr("plausible"));
  EXPECT_THAT(lines[2], testing::HasSubstr("1.20 +- 0.40 mm"));
  EXPECT_THAT(lines[2], testing::HasSubstr("stands in"));
  EXPECT_THAT(lines[2], testing::HasSubstr("not from base_tilt"));
  EXPECT_TRUE(bill_lines({}).empty());
}

}  // namespace
}  // namespace handsight
