// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/inclusion_probability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <set>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/selection/model_posterior.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"
#include "effects/term_numbers.h"
#include "estimation/report/export.h"
#include "estimation/report/prediction.h"
#include "session/calibration_xml.h"

namespace handsight {
namespace {

const EffectTerm sure = {"joint_elasticity", 1, {1.5e-4}};
const EffectTerm doubtful = {"joint_scale", 2, {1.1e-4}};  // shows, but too little to be named

Diagnosis diagnosed_with(const Session& session, std::vector<EffectTerm> terms) {
  for (EffectTerm& t : terms) std::fill(t.values.begin(), t.values.end(), 0.0);
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = std::move(terms);
  return diagnose(session, o);
}

InclusionProbabilities inclusion_probability_of(const Diagnosis& model, bool goes_on = true) {
  return inclusion_probabilities(model, 0, [=] { return goes_on; });
}

double probability(const InclusionProbabilities& c, const std::string& id) {
  for (const InclusionProbability& n : c.names)
    if (n.id == id) return n.probability;
  return 0;
}

/// ln of the sum of the evidence of all choices among the open units, and of those with each unit.
std::vector<double> by_counting(const ModelSpace& all, const OpenUnits& units) {
  std::vector<double> sums(units.open.size() + 1, 0.0);
  const double reference = all.worth(all.present());
  for (std::size_t bits = 0; bits < (std::size_t{1} << units.open.size()); ++bits) {
    Chosen chosen;
    bool is_valid = true;
    for (std::size_t i = 0; i < units.open.size() && is_valid; ++i) {
      if (!(bits >> i & 1)) continue;
      is_valid = all.can_come(units.open[i], chosen) && all.can_come(units.open[i], units.fixed);
      chosen = with_unit(chosen, units.open[i]);
    }
    if (!is_valid) continue;
    for (const std::size_t u : units.fixed) chosen = with_unit(chosen, u);
    const double weight = std::exp(all.worth(chosen) - reference);
    sums[0] += weight;
    for (std::size_t i = 0; i < units.open.size(); ++i)
      if (bits >> i & 1) sums[i + 1] += weight;
  }
  return sums;
}

TEST(ModelPosterior, TheWalkFindsWhatCountingAllChoicesFinds) {
  const Session session = simulated({sure, doubtful}, 21, 60);
  const Diagnosis model = diagnosed_with(session, {sure});
  const ModelSpace all(model.model.fit, 0, 2);
  const auto goes_on = [] { return true; };
  OpenUnits units = open_units(all, goes_on);
  ASSERT_GT(units.open.size(), 2U);
  // So many as can be counted.
  Chosen few;
  for (const std::size_t u : units.open)
    if (all.units()[u].is_present || few.size() < 11) few.push_back(u);
  units.open = few;
  std::erase_if(units.instead, [&](const auto& i) { return std::find(few.begin(), few.end(), i.first) == few.end(); });
  for (auto& [unit, others] : units.instead)
    std::erase_if(others, [&](std::size_t o) { return std::find(few.begin(), few.end(), o) == few.end(); });
  const Weights weights = model_posterior(all, units, open_score(all, units), goes_on);
  double total = 0;
  for (const auto& [chosen, weight] : weights) total += weight;
  EXPECT_NEAR(total, 1, 1e-9);
  const std::vector<double> sums = by_counting(all, units);
  for (std::size_t i = 0; i < few.size(); ++i) {
    double walked = 0;
    for (const auto& [chosen, weight] : weights)
      if (std::find(chosen.begin(), chosen.end(), few[i]) != chosen.end()) walked += weight;
    // The fixed ones have a scale of their own in the walk, and it ends after some hundred steps.
    EXPECT_NEAR(walked, sums[i + 1] / sums[0], 0.04) << all.names()[all.units()[few[i]].name].id;
  }
}

TEST(InclusionProbabilities, WhatShowsPlainlyIsSureAndTheRestIsNot) {
  const Session session = simulated({sure}, 22, 60);
  const InclusionProbabilities c = inclusion_probability_of(diagnosed_with(session, {sure}));
  ASSERT_FALSE(c.names.empty());
  EXPECT_EQ(c.names.front().id, "joint_elasticity");
  EXPECT_TRUE(c.names.front().is_in_model);
  EXPECT_GT(c.names.front().probability, 0.999);
  for (std::size_t i = 1; i < c.names.size(); ++i) {
    EXPECT_LT(c.names[i].probability, 0.5) << c.names[i].id;
    EXPECT_GE(c.names[i].probability, InclusionProbabilities::least_reported);
  }
  EXPECT_TRUE(c.likely.empty());
}

TEST(InclusionProbabilities, ANameThatIsLackingIsLikelyAtItsPlace) {
  const Session session = simulated({sure, {"joint_scale", 2, {1e-3}}}, 23, 60);
  const InclusionProbabilities c = inclusion_probability_of(diagnosed_with(session, {sure}));
  ASSERT_FALSE(c.likely.empty());
  EXPECT_EQ(c.likely.front().name.id, "joint_scale");
  EXPECT_THAT(c.likely.front().name.where, testing::ElementsAre("a3"));
  const EffectTerm& found = c.likely.front().estimated.back();
  EXPECT_EQ(found.place, 2);
  EXPECT_NEAR(found.values[0], 1e-3, 2e-4);
}

/// The zero of a joint is a turn of the frames that follow: where these are in the model, usual sizes alone decide.
TEST(InclusionProbabilities, WhatOnlySizesTellIsNotSure) {
  const EffectTerm zero = {"joint_offset", 2, {0.04}};
  const auto told = [&](const std::set<int>& places) {
    std::vector<EffectTerm> all{zero};
    for (const int place : places) all.push_back({"link_geometry", place, {1e-3, 5e-4, 1e-3, 2e-3}});
    for (const InclusionProbability& n : inclusion_probability_of(diagnosed_with(simulated(all, 24, 60), all)).names)
      if (n.id == zero.id) return n;
    return InclusionProbability{};
  };
  const InclusionProbability beside = told({3, 4, 5}), alone = told({5});
  EXPECT_NEAR(beside.probability, 0.95, 0.05);
  EXPECT_LE(beside.probability, 0.95);
  EXPECT_THAT(beside.indistinguishable_from, testing::Contains("link_geometry"));
  EXPECT_GT(alone.probability, 0.99);
  EXPECT_THAT(alone.indistinguishable_from, testing::Not(testing::Contains("link_geometry")));
}

TEST(InclusionProbabilities, StoppedItSaysNothing) {
  const Session session = simulated({sure}, 22, 60);
  const InclusionProbabilities c = inclusion_probability_of(diagnosed_with(session, {sure}), false);
  EXPECT_FALSE(c.model_uncertainty.is_any());
}

TEST(InclusionProbabilities, DoubtIsACovarianceAndWidensPredictions) {
  const Session session = simulated({sure, doubtful}, 24, 60);
  const Diagnosis model = diagnosed_with(session, {sure});
  const Fit& fit = model.model.fit;
  const InclusionProbabilities c = inclusion_probability_of(model);
  EXPECT_GT(probability(c, "joint_scale"), InclusionProbabilities::least_reported);
  ASSERT_TRUE(c.model_uncertainty.is_any());
  EXPECT_EQ(c.model_uncertainty.covariance.cols(),
            fit.model_covariance.cols() + first_numbers(c.model_uncertainty.others).back());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(c.model_uncertainty.covariance);
  EXPECT_GE(eigen.eigenvalues().minCoeff(), -1e-9 * eigen.eigenvalues().maxCoeff());
  for (const EffectTerm& t : c.model_uncertainty.others)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!term_effect(t).parameters[p].is_choice) EXPECT_EQ(t.values[p], 0);
  const Chain chain = make_chain(session);
  const PredictionModel plain = prediction_model(fit), doubting = prediction_model(fit, c.model_uncertainty);
  for (int i = 0; i < 60; i += 7) {
    const Eigen::VectorXd& position = session.observations[static_cast<std::size_t>(i)].position;
    const TcpPrediction a = predict_tcp(chain, position, plain), b = predict_tcp(chain, position, doubting);
    EXPECT_EQ(a.root_from_tcp_est.translation, b.root_from_tcp_est.translation);
    EXPECT_GE(b.sigma().head<3>().norm(), a.sigma().head<3>().norm());
  }
}

TEST(InclusionProbabilities, AnExportedCalibrationDoubtsAsMuch) {
  const Session session = simulated({sure, doubtful}, 24, 60);
  const Diagnosis model = diagnosed_with(session, {sure});
  const ModelUncertainty model_uncertainty = inclusion_probability_of(model).model_uncertainty;
  ASSERT_TRUE(model_uncertainty.is_any());
  const std::string text = calibration_text(
      make_calibration(session, model.model.fit, model.report, model.model_options, "test", model_uncertainty));
  const Calibration read = parse_calibration(text, "c.xml");
  EXPECT_TRUE(read.notes.empty());
  ASSERT_TRUE(read.model_uncertainty);
  EXPECT_EQ(read.model_uncertainty->covariance, model_uncertainty.covariance);
  const PredictionModel here = prediction_model(model.model.fit, model_uncertainty),
                        there = prediction_model(read, session.robot);
  const Chain chain = make_chain(session);
  const Eigen::VectorXd& position = session.observations[5].position;
  const Matrix6 a = predict_tcp(chain, position, here).covariance, b = predict_tcp(chain, position, there).covariance;
  EXPECT_LT((a - b).norm(), 1e-9 * a.norm());
}

TEST(InclusionProbabilities, ABrokenDoubtIsRefusedInWords) {
  const Session session = simulated({sure, doubtful}, 24, 60);
  const Diagnosis model = diagnosed_with(session, {sure});
  Calibration c = make_calibration(session, model.model.fit, model.report, model.model_options, "test",
                                   inclusion_probability_of(model).model_uncertainty);
  ASSERT_TRUE(c.model_uncertainty);
  c.model_uncertainty->covariance.conservativeResize(7, 7);
  try {
    parse_calibration(calibration_text(c), "c.xml");
    FAIL() << "a covariance that is too small was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("c.xml"));
    EXPECT_THAT(error.what(), testing::HasSubstr("<doubt>"));
  }
}

TEST(Improve, TellsHowSureItsNamesAre) {
  const Session session = simulated({sure, {"joint_scale", 2, {1e-3}}}, 23, 60);
  const Improvement m = improve(session);
  EXPECT_GT(probability(m.inclusion_probabilities, "joint_elasticity"), 0.99);
  EXPECT_GT(probability(m.inclusion_probabilities, "joint_scale"), 0.99);
  const Improvement nothing = improve(simulated({}, 25, 60));
  EXPECT_EQ(nothing.steps.size(), 1U);
  for (const InclusionProbability& n : nothing.inclusion_probabilities.names) EXPECT_LT(n.probability, 0.8) << n.id;
}

/// The model that is likely, place by place (Barbieri and Berger 2004): a name that is in it may be likely at one more.
TEST(InclusionProbabilities, APlaceMoreOfANameOfTheModelIsLikely) {
  const EffectTerm one_more = {"joint_elasticity", 2, {2e-5}};
  const Session session = simulated({sure, one_more}, 21, 60);
  const Diagnosis model = diagnosed_with(session, {sure});
  InclusionProbabilities c = inclusion_probability_of(model);
  std::erase_if(c.likely, [](const LikelyName& l) { return !l.name.is_in_model; });
  ASSERT_EQ(c.likely.size(), 1U);
  const LikelyName& likely = c.likely.front();
  EXPECT_EQ(likely.name.id, sure.id);
  EXPECT_THAT(likely.name.where, testing::ElementsAre("a3"));
  EXPECT_GE(likely.name.probability, InclusionProbabilities::least_likely);
  ASSERT_EQ(likely.estimated.size(), 2U);
  EXPECT_EQ(likely.estimated.front().place, sure.place);
  EXPECT_EQ(likely.estimated.back().place, one_more.place);
  const ModelChange change = add_likely(session, {}, model, c);
  ASSERT_TRUE(change.model);
  EXPECT_EQ(change.steps.back().added, sure.id);
  EXPECT_LT(held_out_error(*change.model), held_out_error(model));
  for (const LikelyName& l : inclusion_probability_of(*change.model).likely)
    EXPECT_FALSE(l.name.is_in_model) << "what stands does not come again";
}

/// Beside what has names already a name may be likely without the evidence that is asked of a first one.
TEST(Improve, ALikelyNameIsTakenWhereTheHeldOutErrorFalls) {
  const Session session = simulated({sure, doubtful}, 26, 60);
  Diagnosis model = diagnosed_with(session, {sure});
  InclusionProbabilities c = inclusion_probability_of(model);
  ASSERT_FALSE(c.names.empty());
  const auto scale = std::find_if(c.names.begin(), c.names.end(), [](const auto& n) { return n.id == "joint_scale"; });
  ASSERT_NE(scale, c.names.end());
  // As if it were likelier than it is.
  std::vector<EffectTerm> estimated = model.model_options.estimated;
  estimated.push_back({"joint_scale", 2, {0}});
  c.likely = {{*scale, estimated}};
  const ModelChange change = add_likely(session, {}, model, c);
  if (change.model) {
    EXPECT_LT(held_out_error(*change.model), held_out_error(model));
    EXPECT_EQ(change.steps.back().added, "joint_scale");
    EXPECT_EQ(change.steps.back().likely, scale->probability);
  } else {
    ASSERT_EQ(change.refused.size(), 1U);
    EXPECT_EQ(change.refused.front().id, "joint_scale");
  }
  // A model without names takes nothing for being likely.
  std::erase_if(c.names, [](const InclusionProbability& n) { return n.is_in_model; });
  EXPECT_FALSE(add_likely(session, {}, model, c).model);
}

/// What is sure by all measurements is not left out for a held-out error that stays as it was to its third digit.
TEST(Improve, ASureNameNeedNotLowerTheHeldOutError) {
  const Session session = simulated({sure}, 26, 60);
  const Diagnosis model = diagnosed_with(session, {sure});
  InclusionProbabilities c = inclusion_probability_of(model);
  std::vector<EffectTerm> estimated = model.model_options.estimated;
  estimated.push_back({"joint_scale", 2, {0}});
  const InclusionProbability name{"joint_scale", {"q3"}, 0.9, false};
  c.likely = {{name, estimated}};
  const ModelChange likely = add_likely(session, {}, model, c);
  EXPECT_FALSE(likely.model);
  ASSERT_EQ(likely.refused.size(), 1U);
  c.likely.front().name.probability = 0.96;
  const ModelChange surely = add_likely(session, {}, model, c);
  ASSERT_TRUE(surely.model);
  EXPECT_GE(held_out_error(*surely.model), held_out_error(model));
  EXPECT_LE(held_out_error(*surely.model), as_good_as_reported * held_out_error(model));
}

}  // namespace
}  // namespace handsight
