// SPDX-License-Identifier: Apache-2.0
// Predictions: right on average, with a covariance that says how far they are off; the same from an exported file.
#include "estimation/report/prediction.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <random>

#include "estimation/report/export.h"
#include "fixtures/arms.h"
#include "session/calibration_xml.h"

namespace handsight {
namespace {

const std::vector<std::string> in_the_model = {"joint_offset", "joint_elasticity"};

/// Effects drawn from what is plausible of them, at every joint where they may sit.
std::vector<EffectTerm> drawn_effects(const Chain& chain, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<EffectTerm> terms;
  for (const std::string& id : in_the_model)
    for (EffectTerm term : effect_terms(id, chain)) {
      const Effect& effect = *find_effect(id);
      for (std::size_t p = 0; p < term.values.size(); ++p) term.values[p] = normal(random) * effect.parameters[p].sigma;
      terms.push_back(term);
    }
  return terms;
}

struct Drawn {
  SimulatedSession truth;
  Fit fit;
};

Drawn draw(std::uint64_t seed) {
  const Session like = fixture::stand_session();
  std::mt19937_64 random(seed);
  SimulationOptions options;
  options.seed = seed;
  options.observations = 30;
  options.effects = drawn_effects(make_chain(like), random);
  Drawn d;
  d.truth = simulate_session(like, options);
  FitOptions with;
  for (const std::string& id : in_the_model)
    for (const EffectTerm& term : effect_terms(id, make_chain(like))) with.estimated.push_back(term);
  d.fit = fit(d.truth.session, with);
  return d;
}

Eigen::VectorXd some_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-1.2, 1.2);
  Eigen::VectorXd position(6);
  for (double& q : position) q = angle(random);
  return position;
}

/// Squared error over the predicted covariance, of the TCP that is tied to the body by the estimated TCP->Body.
double normalised_squared_error(const Drawn& d, const Eigen::VectorXd& position) {
  const Chain chain = make_chain(d.truth.session);
  const TcpPrediction p = predict_tcp(chain, position, prediction_model(d.fit));
  PredictionModel real;
  real.effects = d.truth.effects;
  real.covariance = Eigen::MatrixXd::Zero(18, 18);
  const Rigid root_from_tcp = predict_tcp(chain, position, real).root_from_tcp_est;
  const Rigid tcp_from_body = body_frame(d.fit.sides, d.truth.markers_in_tcp).tcp_from_body;
  const Rigid root_from_tcp_est = root_from_tcp * tcp_from_body * inverse(d.fit.tcp_from_body);
  Vector6 error;
  error << p.root_from_tcp_est.translation - root_from_tcp_est.translation,
      vector_from_rotation(p.root_from_tcp_est.rotation * root_from_tcp_est.rotation.transpose());
  return error.dot(p.covariance.ldlt().solve(error));
}

TEST(Prediction, ErrorsAreAsLargeAsItsCovarianceSays) {
  constexpr int draws = 60;
  double sum = 0;
  int within = 0;
  const double limit = boost::math::quantile(boost::math::chi_squared(6), 0.95);
  for (int seed = 0; seed < draws; ++seed) {
    const Drawn d = draw(static_cast<std::uint64_t>(900 + seed));
    ASSERT_EQ(d.fit.covariance_kind, CovarianceKind::noise) << seed;
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const double squared = normalised_squared_error(d, some_pose(random));
    sum += squared;
    within += squared < limit;
  }
  RecordProperty("mean_normalised_squared_error", std::to_string(sum / draws));
  RecordProperty("within_95", within);
  EXPECT_NEAR(sum / draws, 6, 4 * std::sqrt(12.0 / draws));  // chi-squared with 6 degrees, four sigma
  EXPECT_GE(within, 51);                                     // of 60; one binomial run in 500 has fewer
}

TEST(Prediction, KnowsThatErrorsOfTheBodyAndOfEffectsGoTogether) {
  const Drawn d = draw(77);
  const PredictionModel together = prediction_model(d.fit);
  PredictionModel apart = together;
  apart.covariance.topRightCorner(6, 12).setZero();
  apart.covariance.bottomLeftCorner(12, 6).setZero();
  const Chain chain = make_chain(d.truth.session);
  std::mt19937_64 random(3);
  const Eigen::VectorXd position = some_pose(random);
  // An offset of the last joint turns the hand one way and TCP->Body the other: the body stays where it is.
  EXPECT_LT(predict_tcp(chain, position, together).sigma().tail<3>().norm(),
            0.5 * predict_tcp(chain, position, apart).sigma().tail<3>().norm());
}

TEST(Prediction, IsTheSameFromTheExportedFile) {
  Session session = draw(78).truth.session;
  const Chain chain = make_chain(session);
  FitOptions options;  // terms of one effect apart, one held: the file lists them by effect
  options.effects = {{"joint_elasticity", chain.joints[1], {1e-5}}};
  options.estimated = {{"joint_offset", chain.joints[2], {0}},
                       {"joint_elasticity", chain.joints[3], {0}},
                       {"marker_slip", 1, {0, 0, 0, 12}},
                       {"joint_offset", chain.joints[4], {0}}};
  const Fit fitted = fit(session, options);
  const FitReport reported = report(session, fitted, options);
  const Calibration read =
      parse_calibration(calibration_text(make_calibration(session, fitted, reported, options, "test")), "c.xml");
  ASSERT_TRUE(read.model_covariance);
  std::mt19937_64 random(4);
  for (int i = 0; i < 5; ++i) {
    const Eigen::VectorXd position = some_pose(random);
    const TcpPrediction here = predict_tcp(chain, position, prediction_model(fitted));
    const TcpPrediction there = predict_tcp(chain, position, prediction_model(read, session.robot));
    EXPECT_LT((here.root_from_tcp_est.translation - there.root_from_tcp_est.translation).norm(), 1e-12);
    EXPECT_LT((here.sigma() - there.sigma()).norm(), 1e-9 * here.sigma().norm());
  }
}

/// One marker shows where it is and not how the hand is turned: the position is known as well as the marker.
TEST(Prediction, OfOneMarkerIsAsSureOfThePositionAsTheMarkerIs) {
  SimulationOptions options;
  options.observations = 40;
  const Session session = simulate_session(fixture::tracker_session(1), options).session;
  const Fit f = fit(session);
  const PredictionModel model = prediction_model(f);
  EXPECT_FALSE(model.rotation_is_observed);
  std::mt19937_64 random(3);
  const Vector6 sigma = predict_tcp(make_chain(session), some_pose(random), model).sigma();
  EXPECT_LT(sigma.head<3>().maxCoeff(), 1e-3) << "m; 0.2 mm noise, 40 poses";
  EXPECT_GT(sigma.head<3>().minCoeff(), 1e-6);
  const Session three = simulate_session(fixture::tracker_session(3), options).session;
  EXPECT_TRUE(prediction_model(fit(three)).rotation_is_observed);
}

}  // namespace
}  // namespace handsight
