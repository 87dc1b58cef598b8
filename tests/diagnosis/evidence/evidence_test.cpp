// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/exchanged_factors.h"
#include "estimation/fit/fit.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

constexpr double noise = 0.2;

struct Bench {
  SimulatedSession simulated;
  Fit fit;
  Candidates candidates;
  LinearModel model;
};

Bench workbench(std::uint64_t seed, int observations = 20) {
  Bench b;
  SimulationOptions o;
  o.seed = seed;
  o.observations = observations;
  o.noise = noise;
  o.effects = {{"joint_offset", 1, {1e-4}}};
  b.simulated = simulate_session(fixture::stand_session(), o);
  b.fit = fit(b.simulated.session, {});
  b.candidates = all_candidates(b.fit.problem, 4);
  b.model = linear_model(b.candidates.problem, estimate(b.fit), 0, noise);
  return b;
}

/// The columns of one unit among the candidates.
const CandidateUnit& find_unit(const Candidates& c, const std::string& id, int place) {
  for (const CandidateEffect& e : c.effects)
    for (const CandidateUnit& u : e.units)
      if (e.effect->id == id && u.term.place == place) return u;
  throw std::runtime_error("no such unit");
}

/// ln of a zero-mean normal density, by a dense covariance.
double ln_density(const Eigen::VectorXd& y, const Eigen::MatrixXd& covariance) {
  const Eigen::LLT<Eigen::MatrixXd> llt(covariance);
  return -0.5 * y.dot(llt.solve(y)) - llt.matrixLLT().diagonal().array().log().sum();
}

TEST(Evidence, IsTheRatioOfTwoNormalDensities) {
  // Against a dense calculation: the model's own parameters under a prior so wide that its width cancels.
  const Bench b = workbench(3, 12);
  const CandidateUnit& u = find_unit(b.candidates, "encoder_eccentricity", 2);
  const Eigen::MatrixXd base = b.model.external.leftCols(b.model.base);
  const Eigen::MatrixXd columns = b.model.external.middleCols(b.model.base + u.first, u.count);
  for (const Repeatability& repeatability : {Repeatability{}, Repeatability{1e-3, 0}, Repeatability{3e-4, 2e-4}}) {
    // Internal rows are the same for both models where the candidate has none; markers' internal columns are left out
    // of the dense calculation by giving the base only what the external rows see.
    LinearModel outer = b.model;
    outer.internal.setZero();
    const WhitenedModel w = whiten(outer, repeatability, {});
    Eigen::MatrixXd v = Eigen::MatrixXd::Identity(base.rows(), base.rows());
    for (const LinearObservation& o : b.model.observations) {
      auto block = v.block(o.first, o.first, o.count, o.count);
      block += std::pow(repeatability.joints, 2) * o.by_joints * o.by_joints.transpose();
      block += std::pow(repeatability.place, 2) * o.by_body.leftCols<3>() * o.by_body.leftCols<3>().transpose();
    }
    Eigen::VectorXd width(base.cols());
    for (Eigen::Index i = 0; i < width.size(); ++i) width[i] = 1e4 / base.col(i).norm();
    v += base * width.cwiseAbs2().asDiagonal() * base.transpose();
    std::vector<double> expected;
    for (const double s : prior_scales)
      expected.push_back(ln_density(b.model.external_error, v + s * s * columns * columns.transpose()) -
                         ln_density(b.model.external_error, v));
    double mean = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) mean += scale_shares[i] * std::exp(expected[i]);
    EXPECT_NEAR(ln_bayes_factor(score(w, u.first, u.count), w, {}), std::log(mean), 1e-3)
        << repeatability.joints << " " << repeatability.place;
  }
}

TEST(Evidence, OfTheBaseAloneIsThatOfTheWholeModelWhateverThePrior) {
  const Session session = workbench(6, 30).simulated.session;
  FitOptions o;
  o.estimated = {{"joint_offset", 1, {0}}, {"joint_elasticity", 2, {0}}};
  const Fit f = fit(session, o);
  const Candidates c = all_candidates(f.problem, 4);
  LinearModel m = linear_model(c.problem, estimate(f), c.base_effects, noise);
  for (const NoiseKnowledge& knowledge : {NoiseKnowledge{}, NoiseKnowledge{false, 200}})
    for (const Repeatability& repeatability : {Repeatability{}, Repeatability{3e-4, 2e-4}}) {
      const BaseEvidence evidence(m, repeatability, knowledge);
      for (const double scale : {0.3, 1.0, 3.0}) {
        LinearModel other = m;
        other.prior.precision *= scale;
        other.prior.gradient *= scale;
        other.prior.cost *= scale;
        const WhitenedModel whole = whiten(other, repeatability, knowledge);
        EXPECT_NEAR(evidence.ln_with(other.prior), whole.ln_evidence, 1e-8);
        EXPECT_NEAR(ln_evidence_of_base(other, repeatability, knowledge), whole.ln_evidence, 1e-8);
        EXPECT_NEAR(evidence.squares_with(other.prior), whole.residual_squares, 1e-8 * whole.residual_squares);
      }
    }
}

TEST(Evidence, WhitenedIntoThePlaceOfAnotherIsTheSame) {
  const Bench b = workbench(4);
  WhitenedModel w = whiten(b.model, {3e-4, 2e-4}, {});
  whiten(b.model, {1e-4, 0}, {}, w);
  const WhitenedModel alone = whiten(b.model, {1e-4, 0}, {});
  EXPECT_EQ(w.external, alone.external);
  EXPECT_EQ(w.shared, alone.shared);
  EXPECT_EQ(w.external_error, alone.external_error);
  EXPECT_EQ(w.whiteners.size(), alone.whiteners.size());
  EXPECT_EQ(w.ln_evidence, alone.ln_evidence);
  EXPECT_EQ(w.residual_squares, alone.residual_squares);
}

TEST(Evidence, GainsNothingFromWhatTheModelAlreadyHas) {
  // The last joint's offset turns the body about the joint's axis: the markers take that up.
  const Bench b = workbench(4);
  const WhitenedModel w = whiten(b.model, {}, {});
  const CandidateUnit& u = find_unit(b.candidates, "joint_offset", 5);
  EXPECT_LT(score(w, u.first, u.count).information(0, 0), 1e-3);
  EXPECT_NEAR(ln_bayes_factor(score(w, u.first, u.count), w, {}), 0, 1e-2);
}

TEST(Evidence, WithoutAGroupIsThatOfTheOthers) {
  const Bench b = workbench(6, 60);
  const std::vector<ParameterGroup> groups{{0, 4}, {4, 1}, {5, 7}};
  for (const NoiseKnowledge& knowledge : {NoiseKnowledge{}, NoiseKnowledge{false, 500}}) {
    const WhitenedModel w = whiten(b.model, {}, knowledge);
    const Score all = score(w, 0, 12);
    const FactorsWithout factors = ln_bayes_factors_without(all, groups, w, knowledge);
    EXPECT_NEAR(factors.whole, ln_bayes_factor(all, w, knowledge), 1e-9);
    ASSERT_EQ(factors.without.size(), groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      std::vector<Eigen::Index> others;
      for (Eigen::Index i = 0; i < 12; ++i)
        if (i < groups[g].first || i >= groups[g].first + groups[g].count) others.push_back(i);
      EXPECT_NEAR(factors.without[g], ln_bayes_factor(take_part(all, others), w, knowledge), 1e-8) << g;
    }
  }
}

TEST(Evidence, BesideAGroupIsThatOfBoth) {
  const Bench b = workbench(6, 60);
  const std::vector<Eigen::Index> chosen{9, 1, 4};
  const std::vector<ParameterGroup> groups{{0, 1}, {2, 2}, {5, 4}};
  for (const NoiseKnowledge& knowledge : {NoiseKnowledge{}, NoiseKnowledge{false, 500}}) {
    const WhitenedModel w = whiten(b.model, {}, knowledge);
    const Score all = score(w, 0, 12);
    const auto beside = [&](std::span<const Eigen::Index> some) {
      const std::vector<double> factors = ln_bayes_factors_beside(all, some, groups, w, knowledge);
      EXPECT_EQ(factors.size(), groups.size());
      for (std::size_t g = 0; g < groups.size(); ++g) {
        std::vector<Eigen::Index> both(some.begin(), some.end());
        for (Eigen::Index i = 0; i < groups[g].count; ++i) both.push_back(groups[g].first + i);
        // One number alone is asked at every scale; beside others a wide one leaves out what the prior holds of it.
        EXPECT_NEAR(factors[g], ln_bayes_factor(take_part(all, both), w, knowledge), 1e-7) << g;
      }
    };
    beside(chosen);
    beside({});
  }
}

TEST(Evidence, AfterAnExchangeIsThatOfTheOthersAndTheNew) {
  const Bench b = workbench(6, 60);
  const std::vector<Eigen::Index> chosen{9, 1, 4, 7, 8};
  const std::vector<NumberExchange> exchanges{{{0, 1}, {{0, 1}, {2, 2}}}, {{1, 2}, {}}, {{3, 2}, {{5, 2}, {10, 2}}}};
  for (const NoiseKnowledge& knowledge : {NoiseKnowledge{}, NoiseKnowledge{false, 500}}) {
    const WhitenedModel w = whiten(b.model, {}, knowledge);
    const Score all = score(w, 0, 12);
    const std::vector<ExchangedFactors> factors = exchanged_factors(all, chosen, exchanges, w, knowledge);
    ASSERT_EQ(factors.size(), exchanges.size());
    for (std::size_t e = 0; e < exchanges.size(); ++e) {
      const auto [gone, coming] = exchanges[e];
      std::vector<Eigen::Index> fewer = chosen;
      fewer.erase(fewer.begin() + gone.first, fewer.begin() + gone.first + gone.count);
      EXPECT_NEAR(factors[e].without, ln_bayes_factor(take_part(all, fewer), w, knowledge), 1e-8) << e;
      ASSERT_EQ(factors[e].instead.size(), coming.size());
      for (std::size_t k = 0; k < coming.size(); ++k) {
        std::vector<Eigen::Index> both = fewer;
        for (Eigen::Index i = 0; i < coming[k].count; ++i) both.push_back(coming[k].first + i);
        EXPECT_NEAR(factors[e].instead[k], ln_bayes_factor(take_part(all, both), w, knowledge), 1e-7) << e << ' ' << k;
      }
    }
  }
}

TEST(Evidence, FollowsTheSimulatedSize) {
  // The linear estimate is the truth within its sigma, in units of the prior sigma.
  const Bench b = workbench(5, 60);
  const WhitenedModel w = whiten(b.model, {}, {});
  const CandidateUnit& u = find_unit(b.candidates, "joint_offset", 1);
  const LinearEstimate e = linear_estimate(score(w, u.first, u.count), w, {});
  EXPECT_NEAR(e.value[0], 1e-4 / 5e-3, 4.5 * std::sqrt(e.covariance(0, 0)));
}

TEST(Evidence, OfNothingIsSeldomMuch) {
  // The mean of Bayes factors under nothing missing is 1: odds of 20 come less often than once in 20.
  int beyond = 0, looked_at = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulationOptions o;
    o.seed = seed;
    o.observations = 20;
    o.noise = noise;
    const Fit f = fit(simulate_session(fixture::stand_session(), o).session, {});
    const Candidates c = all_candidates(f.problem, 4);
    const LinearModel m = linear_model(c.problem, estimate(f), 0, noise);
    const WhitenedModel w = whiten(m, {}, {});
    for (const CandidateEffect& e : c.effects) {
      ++looked_at;
      beyond += ln_bayes_factor(score(w, e.units.front().first, e.units.front().count), w, {}) > std::log(20.0);
    }
  }
  EXPECT_LT(beyond, looked_at / 20);
}

}  // namespace
}  // namespace handsight
