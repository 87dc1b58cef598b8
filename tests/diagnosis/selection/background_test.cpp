// SPDX-License-Identifier: Apache-2.0
// What is a little off at each joint comes into the model beside the names, and is told as no cause.
#include "diagnosis/selection/background.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/simulated_stand.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/explanation.h"
#include "estimation/report/prediction.h"

namespace handsight {
namespace {

using testing::ElementsAre;

const EffectTerm wrong_zero{"joint_offset", 2, {0.05}};

/// Springs of a part of the usual size at each joint.
std::vector<EffectTerm> soft_everywhere(std::uint64_t seed, double part = 0.2) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<EffectTerm> springs;
  for (int j = 0; j < 6; ++j) springs.push_back({"joint_elasticity", j, {part * 1e-4 * std::abs(normal(random))}});
  return springs;
}

std::vector<EffectTerm> wrong_zero_and(std::vector<EffectTerm> others) {
  others.push_back(wrong_zero);
  return others;
}

Diagnosis model_with_the_zero(const Session& session) {
  DiagnosisOptions o;
  o.with_held_out = false;
  o.estimated = {{"joint_offset", 2, {0}}};
  return diagnose(session, o);
}

/// How far the model's TCP is from where hidden effects put it, over poses that it has not seen; what is the same in
/// all of them may be the mount's (m, rms).
double missed_by(const std::vector<EffectTerm>& model, const std::vector<EffectTerm>& hidden) {
  const Session fresh = simulated(hidden, 99, 100);
  const Chain chain = make_chain(fresh);
  const auto place = [&](const Observation& o, const std::vector<EffectTerm>& effects) {
    PredictionModel m;
    m.effects = effects;
    Eigen::Index numbers = 6;
    for (const EffectTerm& t : effects) numbers += static_cast<Eigen::Index>(t.values.size());
    m.covariance = Eigen::MatrixXd::Zero(numbers, numbers);
    return predict_tcp(chain, o.position, m).root_from_tcp_est.translation;
  };
  Eigen::Matrix3Xd off(3, static_cast<Eigen::Index>(fresh.observations.size()));
  for (Eigen::Index i = 0; i < off.cols(); ++i) {
    const Observation& o = fresh.observations[static_cast<std::size_t>(i)];
    off.col(i) = place(o, model) - place(o, hidden);
  }
  off.colwise() -= off.rowwise().mean().eval();
  return std::sqrt(off.squaredNorm() / static_cast<double>(off.cols()));
}

TEST(Background, BringsTheHandNearer) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const std::vector<EffectTerm> hidden = wrong_zero_and(soft_everywhere(seed));
    const Session session = simulated(hidden, seed, 40);
    const Diagnosis before = model_with_the_zero(session);
    const ModelChange change = add_background(session, {}, before);
    ASSERT_TRUE(change.model) << seed;
    ASSERT_EQ(change.steps.size(), 1U);
    EXPECT_EQ(change.steps[0].added, "");
    EXPECT_THAT(change.steps[0].background, ElementsAre("joint_elasticity")) << seed;
    const std::vector<EffectTerm>& terms = change.model->model_options.estimated;
    EXPECT_FALSE(is_small(terms[begin_of_names(terms, 0)]));
    EXPECT_EQ(terms.size(), begin_of_names(terms, 0) + 1) << "the zero is the only name, and stands last";
    EXPECT_LT(held_out_error(*change.model), held_out_error(before)) << seed;
    EXPECT_LT(missed_by(terms, hidden), 0.7 * missed_by(before.model_options.estimated, hidden)) << seed;
  }
}

TEST(Background, DoesNotComeWhereNothingIsThere) {
  int come = 0;
  for (std::uint64_t seed = 11; seed < 17; ++seed) {
    const Session session = simulated({wrong_zero}, seed, 40);
    come += add_background(session, {}, model_with_the_zero(session)).model.has_value();
  }
  EXPECT_LE(come, 1) << "by chance, with no more than a trace";
}

TEST(Background, IsNotAskedAboutWhereNothingHasAName) {
  const Session session = simulated(soft_everywhere(1), 1, 40);
  EXPECT_FALSE(add_background(session, {}, diagnose(session, {})).model);
}

TEST(Background, ComesOnce) {
  const Session session = simulated(wrong_zero_and(soft_everywhere(1)), 1, 40);
  const ModelChange once = add_background(session, {}, model_with_the_zero(session));
  ASSERT_TRUE(once.model);
  EXPECT_FALSE(add_background(session, {}, *once.model).model);
  Diagnosis few = model_with_the_zero(session);
  few.verdict = Verdict::too_few_observations;
  EXPECT_FALSE(add_background(session, {}, few).model);
}

TEST(Background, IsNoCauseThatImproveTells) {
  const std::vector<EffectTerm> hidden = wrong_zero_and(soft_everywhere(1, 0.15));
  const Session session = simulated(hidden, 1, 40);
  const Improvement m = improve(session);
  ASSERT_GE(m.steps.size(), 3U);
  EXPECT_EQ(m.steps[1].added, "joint_offset");
  EXPECT_THAT(m.steps.back().background, ElementsAre("joint_elasticity"));
  for (const InclusionProbability& n : m.inclusion_probabilities.names)
    EXPECT_FALSE(n.is_in_model && n.id == "joint_elasticity");
  ASSERT_EQ(m.bill.size(), 2U);
  const auto small = std::find_if(m.bill.begin(), m.bill.end(), [](const BillRow& r) { return r.is_small; });
  ASSERT_NE(small, m.bill.end());
  EXPECT_EQ(small->id, "joint_elasticity");
  EXPECT_FALSE(small->probability);
  EXPECT_GT(small->hand_m, 0);
  EXPECT_EQ(m.last.reason.english().find("joint_elasticity"), std::string::npos) << m.last.reason.english();
  const InclusionProbabilities& told = m.inclusion_probabilities;
  Eigen::Index numbers = 6;
  for (const auto* terms : {&m.last.model_options.estimated, &told.model_uncertainty.others})
    for (const EffectTerm& t : *terms) numbers += static_cast<Eigen::Index>(t.values.size());
  EXPECT_EQ(told.model_uncertainty.covariance.rows(), numbers);
  EXPECT_FALSE(improve_on(session, {}, m.last).model) << "the end is an end";
}

TEST(Background, HasThePriorOfItsSize) {
  const Session session = simulated(soft_everywhere(3), 3, 40);
  FitOptions o;
  o.estimated = {{"joint_elasticity", 1, {0}}};
  const auto sigma = [&] { return fit(session, o).problem.columns_of_effects[0].sigma; };
  const double usual = sigma();
  o.estimated[0].size = 0.1;
  EXPECT_DOUBLE_EQ(sigma(), 0.1 * usual);
}

}  // namespace
}  // namespace handsight
