// SPDX-License-Identifier: Apache-2.0
// Effects fitted together with the body: derivatives, recovery of simulated values, the part of the priors.
#include <gtest/gtest.h>

#include <random>

#include "effects/target_effects.h"
#include "estimation/fit/objectives.h"
#include "estimation/problem/body_shape.h"
#include "estimation/report/fit_report.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/start/start.h"
#include "fixtures/arms.h"
#include "simulation/random.h"

namespace handsight {
namespace {

/// The last of a choice's alternatives, or this moment.
double choice(const EffectParameter& p, double moment) { return p.choices.empty() ? moment : p.choices.back(); }

std::vector<EffectTerm> every_effect(const Chain& chain, double size, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, size);
  std::vector<EffectTerm> terms;
  for (const Effect& e : catalogue())
    for (const int place : effect_places(e, chain)) {
      EffectTerm term{e.id, place, {}};
      for (const EffectParameter& p : e.parameters)
        term.values.push_back(p.is_choice ? choice(p, 5) : normal(random) * p.sigma);
      terms.push_back(term);
    }
  return terms;
}

/// The gradient of the cost by the columns against its central differences.
void expect_gradient(const Session& session, const std::vector<EffectTerm>& terms) {
  const Chain chain = make_chain(session);
  Problem problem = make_problem(session, chain, {}, terms);
  problem.tcp_from_slip = {rotation_from_rpy({0.3, -0.4, 1.0}), {0.02, 0.01, 0.03}};
  place_observations(problem);
  Unknowns u = *start_values(problem, session.mount);
  u.effects = effect_values(problem);
  const NormalEquations here = normal_equations(problem, u);
  double by_angle = 0;  // px^2/rad
  for (Eigen::Index c = 0; c < problem.effect_count(); ++c)
    if (problem.terms[problem.columns_of_effects[static_cast<std::size_t>(c)].term].id == "joint_offset")
      by_angle = std::max(by_angle, std::abs(here.gradient[problem.effect_column() + c]));
  for (Eigen::Index c = 0; c < problem.columns(); ++c) {
    const Eigen::Index effect = c - problem.effect_column();
    const double scale = effect >= 0 ? problem.columns_of_effects[static_cast<std::size_t>(effect)].sigma : 1e-3;
    const double h = 0.01 * scale;
    auto cost_at = [&](double by) {
      Eigen::VectorXd step = Eigen::VectorXd::Zero(problem.columns());
      step[c] = by;
      const Unknowns next = moved(problem, u, step);
      Problem there = problem;
      set_effects(there, next.effects);
      return normal_equations(there, next).cost;
    };
    const double slope = -(8 * (cost_at(h) - cost_at(-h)) - (cost_at(2 * h) - cost_at(-2 * h))) / (12 * h) / 2;
    // Differences of the cost lose its rounding, and what the equilibrium, found to 1e-11 rad, leaves open in four
    // costs of weights 8, 8, 1 and 1 over 12.
    const double rounding = (1e-13 * here.cost + 1.5 * 1e-10 * by_angle) / h;
    EXPECT_NEAR(here.gradient[c], slope, 1e-7 * std::abs(slope) + rounding)
        << "column " << c << " "
        << (effect >= 0 ? problem.terms[problem.columns_of_effects[static_cast<std::size_t>(effect)].term].id
                        : std::string("marker or mount"));
  }
}

TEST(EffectColumns, AreTheSlopesOfTheCostOverTheWholeCatalogue) {
  SimulationOptions options;
  options.observations = 12;
  std::mt19937_64 random(5);
  for (const bool tracker : {false, true}) {
    Session like = fixture::torso_session();
    if (tracker) like.rig.reset();
    Session session = simulate_session(like, options).session;
    session.mount.estimate = true;
    for (Observation& o : session.observations) {  // velocities for the lag, a marker unseen here and there
      o.velocity = Eigen::VectorXd::Random(4) * 0.3;
      if (o.id % 3 == 0) o.sightings.pop_back();
      if (!tracker && o.id % 4 == 1) forget(o.sightings[0], 0);
    }
    expect_gradient(session, every_effect(make_chain(session), 0.3, random));
  }
}

struct Recovery {
  Fit fit;
  double worst = 0;  // of the parameters, in their sigmas
};

Recovery recover(const Session& like, const std::vector<EffectTerm>& truth, std::uint64_t seed) {
  SimulationOptions options;
  options.seed = seed;
  options.observations = 60;
  options.effects = truth;
  Session session = simulate_session(like, options).session;
  std::vector<EffectTerm> start = truth;
  for (EffectTerm& term : start) {
    const Effect& e = term_effect(term);
    for (std::size_t p = 0; p < term.values.size(); ++p)
      if (!e.parameters[p].is_choice) term.values[p] = 0;
  }
  Recovery r;
  r.fit = fit(session, {.estimated = start});
  EXPECT_TRUE(r.fit.converged()) << truth[0].id;
  for (std::size_t t = 0; t < truth.size(); ++t)
    for (std::size_t p = 0; p < truth[t].values.size(); ++p)
      if (r.fit.effects[t].sigmas[p] > 0)
        r.worst = std::max(r.worst,
                           std::abs(r.fit.effects[t].term.values[p] - truth[t].values[p]) / r.fit.effects[t].sigmas[p]);
  return r;
}

TEST(EffectFit, RecoversEveryEffectOfTheCatalogue) {
  const Session like = fixture::torso_session();
  const Chain chain = make_chain(like);
  for (const Effect& e : catalogue()) {
    if (e.scope == EffectScope::camera) continue;  // of rigs of three cameras and more: rigs_test.cpp
    if (has_no_target(e)) continue;                // target_size_test.cpp
    if (e.id == "joint_coupling") continue;        // of two joints each way: target_size_test.cpp
    std::vector<EffectTerm> truth;
    double sign = 1;
    for (const int place : effect_places(e, chain)) {
      EffectTerm term{e.id, place, {}};
      for (const EffectParameter& p : e.parameters) {
        const bool is_spring = p.unit == "rad/(N m)";  // all give way, and a light arm's show little
        term.values.push_back(p.is_choice ? choice(p, 25) : is_spring ? 3 * p.sigma : sign * p.sigma);
        sign = -sign;
      }
      if (e.scope == EffectScope::marker && place > 0) continue;
      truth.push_back(term);
    }
    const Recovery r = recover(like, truth, 11);
    double surest = 0;  // of what is true, in sigmas: an effect that cannot be seen recovers nothing
    for (const FittedEffect& f : r.fit.effects)
      for (std::size_t p = 0; p < f.sigmas.size(); ++p)
        if (f.sigmas[p] > 0) surest = std::max(surest, std::abs(f.term.values[p]) / f.sigmas[p]);
    EXPECT_GT(surest, 5) << e.id << " does not show in this session";
    EXPECT_LT(r.worst, 4.5) << e.id;
    EXPECT_EQ(r.fit.covariance_kind, CovarianceKind::noise) << e.id << " leaves more than the noise";
  }
}

TEST(EffectFit, AnEffectThatIsNotThereStaysWithinItsSigma) {
  SimulationOptions options;
  options.observations = 40;
  const Session session = simulate_session(fixture::torso_session(), options).session;
  std::vector<EffectTerm> terms;
  for (int j = 0; j < 5; ++j) terms.push_back({"joint_elasticity", j, {0}});
  const Fit f = fit(session, {.estimated = terms});
  for (const FittedEffect& e : f.effects) {
    EXPECT_LT(std::abs(e.term.values[0]), 4 * e.sigmas[0]);
    EXPECT_LT(e.sigmas[0], 1.001 * find_effect("joint_elasticity")->parameters[0].sigma) << "the prior bounds it";
  }
}

TEST(EffectFit, TheHeldOutErrorFallsToTheNoiseOnceTheEffectIsFitted) {
  SimulationOptions options;
  options.observations = 40;
  options.effects = {{"joint_elasticity", 1, {3e-4}}, {"joint_elasticity", 0, {2e-4}}};
  const Session session = simulate_session(fixture::torso_session(), options).session;
  const FitOptions without;
  FitOptions with;
  with.estimated = {{"joint_elasticity", 0, {0}}, {"joint_elasticity", 1, {0}}};
  const Fit before = fit(session, without), after = fit(session, with);
  EXPECT_GT(*report(session, before, without).held_out.rms_pixel, 1.0);
  EXPECT_LT(*report(session, after, with).held_out.rms_pixel, 0.23);
}

TEST(EffectFit, SingleNumbersCanBeHeld) {
  SimulationOptions options;
  options.observations = 40;
  options.effects = {{"encoder_eccentricity", 1, {1.5e-3, -2e-3}}};
  const Session session = simulate_session(fixture::torso_session(), options).session;
  const auto fitted = [&](std::vector<char> held, double cosine) {
    return fit(session, {.estimated = {{"encoder_eccentricity", 1, {0, cosine}, std::move(held)}}});
  };
  const Fit free = fitted({}, 0), at_truth = fitted({0, 1}, -2e-3), at_nothing = fitted({0, 1}, 0);
  ASSERT_EQ(free.problem.effect_count(), 2);
  ASSERT_EQ(at_truth.problem.effect_count(), 1);
  EXPECT_EQ(at_truth.effects[0].term.values[1], -2e-3) << "to the last digit";
  EXPECT_EQ(at_truth.effects[0].sigmas[1], 0);
  EXPECT_NEAR(at_truth.effects[0].term.values[0], 1.5e-3, 4 * at_truth.effects[0].sigmas[0]);
  EXPECT_LE(at_truth.effects[0].sigmas[0], free.effects[0].sigmas[0]) << "what is known makes the rest no less sure";
  EXPECT_GT(at_nothing.residual_rms, 1.05 * free.residual_rms) << "a number held where it is wrong shows";
  // All held one by one is the same as held.
  const Fit all = fit(session, {.estimated = {{"encoder_eccentricity", 1, {1e-3, -1e-3}, {1, 1}}}});
  const Fit whole = fit(session, {.effects = {{"encoder_eccentricity", 1, {1e-3, -1e-3}}}});
  EXPECT_EQ(all.problem.effect_count(), 0);
  EXPECT_NEAR(all.residual_rms, whole.residual_rms, 1e-12);
  EXPECT_LT((all.tcp_from_body.translation - whole.tcp_from_body.translation).norm(), 1e-9);
}

TEST(EffectFit, StopsWhereItsCallbackSaysSo) {
  SimulationOptions options;
  options.observations = 20;
  options.effects = {{"joint_elasticity", 1, {1e-3}}};
  const Session session = simulate_session(fixture::torso_session(), options).session;
  FitOptions with;
  with.estimated = {{"joint_elasticity", 1, {0}}};
  int calls = 0;
  with.on_iteration = [&](int, double, const Unknowns& u) {
    EXPECT_EQ(u.effects.size(), 1);
    return ++calls < 2;
  };
  const Fit f = fit(session, with);
  EXPECT_TRUE(f.solution.stopped);
  EXPECT_EQ(calls, 2);
}

/// What only a prior holds is no unknown of the measurements: tr(H_data H^-1) = n - sum of sigma^2 / plausible^2.
TEST(EffectFit, CountsAsUnknownsWhatTheMeasurementsKnow) {
  SimulationOptions options;
  options.observations = 40;
  const Session session = simulate_session(fixture::torso_session(), options).session;
  const Fit f = fit(session, {.estimated = effect_terms("link_elasticity", make_chain(session))});
  double known_by_priors = 0;
  for (const FittedEffect& e : f.effects)
    for (std::size_t p = 0; p < e.sigmas.size(); ++p)
      known_by_priors += std::pow(e.sigmas[p] / find_effect(e.term.id)->parameters[p].sigma, 2);
  EXPECT_GT(known_by_priors, 2) << "the test needs numbers that hardly show";
  EXPECT_EQ(f.unknowns, static_cast<int>(std::lround(9 + f.problem.effect_count() - known_by_priors)));
  EXPECT_EQ(f.covariance_kind, CovarianceKind::noise);
}

/// The folds of a held body know the shape from their own observations alone.
TEST(EffectFit, AFoldAveragesItsOwnShape) {
  SimulationOptions options;
  options.observations = 40;
  const Session session = simulate_session(fixture::stand_session(4), options).session;
  const FitOptions held{.fix_markers = true};
  const Fit f = fit(session, held);
  Problem part = f.problem;
  part.observations.resize(10);
  const Unknowns u = refit(f, held, part, 0.2);
  const BodyShape shape = *average_shape(part), whole = *average_shape(f.problem);
  const auto side = [](const std::vector<Vector3>& x, std::size_t a, std::size_t b) { return (x[a] - x[b]).norm(); };
  for (const std::size_t b : {1, 2, 3}) {
    EXPECT_NEAR(side(u.markers_in_tcp, 0, b), side(shape.markers, 0, b), 1e-9);
    EXPECT_GT(std::abs(side(whole.markers, 0, b) - side(shape.markers, 0, b)), 1e-7) << "else the test shows nothing";
  }
}

}  // namespace
}  // namespace handsight
