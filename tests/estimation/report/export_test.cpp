// SPDX-License-Identifier: Apache-2.0
// Every model that can be built can be written, read and predicted with.
#include "estimation/report/export.h"

#include <gtest/gtest.h>

#include <random>

#include "estimation/report/prediction.h"
#include "fixtures/arms.h"
#include "session/calibration_xml.h"

namespace handsight {
namespace {

/// A term of any effect at any place of this chain, with plausible numbers and any of its choices.
EffectTerm drawn_term(const Chain& chain, int observations, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  while (true) {
    const Effect& effect = catalogue()[random() % catalogue().size()];
    const std::vector<int> places = effect_places(effect, chain);
    if (places.empty()) continue;
    EffectTerm term{effect.id, places[random() % places.size()], {}};
    for (const EffectParameter& p : effect.parameters)
      term.values.push_back(!p.is_choice        ? 0.3 * p.sigma * normal(random)
                            : p.choices.empty() ? static_cast<double>(random() % static_cast<unsigned>(observations))
                                                : p.choices[random() % p.choices.size()]);
    return term;
  }
}

/// Terms of which some stand twice, and some are both held and estimated.
FitOptions drawn_model(const Chain& chain, int observations, std::mt19937_64& random) {
  FitOptions options;
  options.most_iterations = 3;  // what is found does not matter here
  const std::size_t count = 1 + random() % 4;
  for (std::size_t i = 0; i < count; ++i) {
    EffectTerm term = drawn_term(chain, observations, random);
    if (random() % 3 == 0) options.effects.push_back(term);
    if (random() % 3 == 0) options.estimated.push_back(term);
    for (double& value : term.values) value *= random() % 2 == 0 ? 1 : 0;
    options.estimated.push_back(term);
  }
  return options;
}

std::string list_names(const FitOptions& options) {
  std::string names = "held:";
  for (const EffectTerm& t : options.effects) names += fmt::format(" {}@{}", t.id, t.place);
  names += " estimated:";
  for (const EffectTerm& t : options.estimated) names += fmt::format(" {}@{}", t.id, t.place);
  return names;
}

void expect_same_predictions(const Chain& chain, const std::vector<double>& times, const PredictionModel& here,
                             const PredictionModel& there, std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-1.2, 1.2), time(times.front() - 5, times.back() + 5);
  std::vector<DrivenPose> poses(4);
  for (DrivenPose& pose : poses) {
    pose.position.resize(static_cast<Eigen::Index>(chain.joints.size()));
    for (double& q : pose.position) q = angle(random);
    pose.time = time(random);
  }
  for (const ObservationState& c : states_at(chain, poses, times)) {
    const TcpPrediction a = predict_tcp(c, here), b = predict_tcp(c, there);
    ASSERT_TRUE(a.covariance.allFinite());
    EXPECT_LT((a.root_from_tcp_est.translation - b.root_from_tcp_est.translation).norm(), 1e-12);
    EXPECT_LT((a.root_from_body_est.translation - b.root_from_body_est.translation).norm(), 1e-12);
    EXPECT_LT((a.sigma() - b.sigma()).norm(), 1e-9 * a.sigma().norm());
  }
}

TEST(Export, EveryModelThatCanBeBuiltIsReadBackAndPredictsTheSame) {
  SimulationOptions simulation;
  simulation.observations = 12;
  const Session session = simulate_session(fixture::stand_session(), simulation).session;
  const Chain chain = make_chain(session);
  std::mt19937_64 random(7);
  for (int model = 0; model < 60; ++model) {
    const FitOptions options = drawn_model(chain, simulation.observations, random);
    SCOPED_TRACE(fmt::format("model {}: {}", model, list_names(options)));
    const Fit fitted = fit(session, options);
    const Calibration written = make_calibration(session, fitted, report(session, fitted, options), options, "test");
    const Calibration read = parse_calibration(calibration_text(written), "c.xml");
    EXPECT_EQ(read.times, list_times(session));
    std::size_t numbers = 0;
    for (const CalibrationEffect& e : read.effects) numbers += e.parameters.size();
    const PredictionModel here = prediction_model(fitted), there = prediction_model(read, session.robot);
    EXPECT_EQ(here.effects.size(), there.effects.size());
    EXPECT_EQ(here.covariance.cols(), static_cast<Eigen::Index>(6 + numbers));
    expect_same_predictions(chain, read.times, here, there, random);
  }
}

TEST(Export, TermsOfOneEffectAtOnePlaceStayTwo) {
  SimulationOptions simulation;
  simulation.observations = 15;
  const Session session = simulate_session(fixture::stand_session(), simulation).session;
  FitOptions options;
  options.estimated = {{"body_slip", -1, {0, 0, 0, 0, 0, 0, 5}}, {"body_slip", -1, {0, 0, 0, 0, 0, 0, 10}}};
  const Fit fitted = fit(session, options);
  const Calibration read = parse_calibration(
      calibration_text(make_calibration(session, fitted, report(session, fitted, options), options, "test")), "c.xml");
  ASSERT_EQ(read.effects.size(), 2u);
  EXPECT_EQ(read.effects[0].id, "body_slip");
  EXPECT_EQ(read.effects[1].id, "body_slip");
  const PredictionModel model = prediction_model(read, session.robot);
  ASSERT_EQ(model.effects.size(), 2u);
  EXPECT_EQ(model.effects[0].values.back(), 5);
  EXPECT_EQ(model.effects[1].values.back(), 10);
}

}  // namespace
}  // namespace handsight
