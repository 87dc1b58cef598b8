// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/trust_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "estimation/solvers/covariance_factor.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/solvers/unit_factor.h"
#include "estimation/start/start.h"
#include "fixtures/arms.h"
#include "fixtures/drawn.h"

namespace handsight {
namespace {

struct Case {
  std::string name;
  Session session;
  std::vector<EffectTerm> estimated = {};
  SolveOptions options = {};
};

SimulatedSession simulated(const Session& like, std::vector<EffectTerm> effects = {}, double wrong_corners = 0) {
  SimulationOptions options;
  options.observations = 30;
  options.effects = std::move(effects);
  options.wrong_corners = wrong_corners;
  return simulate_session(like, options);
}

std::vector<Case> cases() {
  const std::vector<EffectTerm> springs{{"joint_elasticity", 1, {4e-4}}, {"joint_elasticity", 2, {3e-4}}};
  const std::vector<EffectTerm> no_springs{{"joint_elasticity", 1, {0}}, {"joint_elasticity", 2, {0}}};
  const std::vector<EffectTerm> rig{{"stereo_rig", -1, {2e-3, 0, 1e-3, 3e-3, -2e-3, 1e-3}}};
  const std::vector<EffectTerm> no_rig{{"stereo_rig", -1, {0, 0, 0, 0, 0, 0}}};
  std::vector<Case> all;
  all.push_back({"plain", simulated(fixture::stand_session()).session});
  all.push_back({"mount", simulated(fixture::stand_session()).session});
  all.back().session.mount.estimate = true;
  all.push_back({"springs", simulated(fixture::stand_session(), springs).session, no_springs});
  all.push_back({"springs and mount", simulated(fixture::seven_axis_session(), springs).session, no_springs});
  all.back().session.mount.estimate = true;
  all.push_back({"rig", simulated(fixture::stand_session(), rig).session, no_rig});
  all.push_back({"rig and mount", simulated(fixture::stand_session(), rig).session, no_rig});
  all.back().session.mount.estimate = true;
  all.push_back({"tracker", simulated(fixture::tracker_session(), springs).session, no_springs});
  all.push_back({"held body", simulated(fixture::stand_session(), springs).session, no_springs, {.fixed_body = true}});
  all.push_back({"slip",
                 simulated(fixture::stand_session(4), {{"marker_slip", 1, {2e-3, 1e-3, -1e-3, 15}}}).session,
                 {{"marker_slip", 1, {0, 0, 0, 15}}}});
  for (const Loss loss : {Loss::huber, Loss::cauchy})
    all.push_back({loss == Loss::huber ? "huber" : "cauchy",
                   simulated(fixture::stand_session(), springs, 0.05).session,
                   no_springs,
                   {.loss = loss, .noise = 0.2}});
  return all;
}

TEST(TrustRegion, AgreesWithTheNormalEquations) {
  for (Case& c : cases()) {
    Problem problem = make_problem(c.session, make_chain(c.session), {}, c.estimated);
    if (problem.effect_count() > 0) problem.noise = c.session.rig ? 0.2 : 2e-4;
    const Unknowns start = *start_values(problem, c.session.mount);
    c.options.most_iterations = 300;
    const Solution ours = solve(problem, start, c.options);
    const Solution ceres = solve_by_trust_region(problem, start, c.options);
    EXPECT_TRUE(ours.converged) << c.name;
    EXPECT_TRUE(ceres.converged) << c.name;
    // Of Cauchy's loss Ceres leaves a step of 1.4e-9 m, ours one of 6e-11.
    const double most = c.name == "cauchy" ? 2e-9 : 1e-9;
    for (std::size_t m = 0; m < start.markers_in_tcp.size(); ++m)
      EXPECT_LT((ours.unknowns.markers_in_tcp[m] - ceres.unknowns.markers_in_tcp[m]).norm(), most) << c.name;
    EXPECT_LT(small_motion_between(ours.unknowns.mount_from_sensor, ceres.unknowns.mount_from_sensor).norm(), 1e-9)
        << c.name;
    for (Eigen::Index i = 0; i < problem.effect_count(); ++i)
      EXPECT_NEAR(ours.unknowns.effects[i], ceres.unknowns.effects[i],
                  1e-9 + 1e-6 * problem.columns_of_effects[static_cast<std::size_t>(i)].sigma)
          << c.name;
    // The equilibrium of springs is found to 1e-11 rad, to which the single residuals are not blind.
    EXPECT_NEAR(ours.normal.cost, ceres.normal.cost, 1e-8 * ours.normal.cost) << c.name;
    EXPECT_NEAR(ours.start_cost, ceres.start_cost, 1e-9 * ours.start_cost) << c.name;
    EXPECT_EQ(ours.unobservable, ceres.unobservable) << c.name;
  }
}

TEST(TrustRegion, ComesBackFromWhereAllMarkersAreBehindTheCameras) {
  for (const bool by_ceres : {false, true}) {
    Session session = simulated(fixture::stand_session()).session;
    session.mount.estimate = true;
    Problem problem = make_problem(session, make_chain(session));
    const Unknowns truth = solve(problem, *start_values(problem, session.mount)).unknowns;
    Unknowns start = truth;
    // Half of the arm's reach farther on, looking 100 degrees aside.
    start.mount_from_sensor = truth.mount_from_sensor * Rigid{rotation_from_rpy({0, 1.75, 0}), {0.3, 0.2, 0.1}};
    ASSERT_FALSE(normal_equations(problem, start).in_front);
    const SolveOptions options{.most_iterations = 300};
    const Solution s = by_ceres ? solve_by_trust_region(problem, start, options) : solve(problem, start, options);
    EXPECT_TRUE(s.converged) << by_ceres;
    EXPECT_LT(small_motion_between(s.unknowns.mount_from_sensor, truth.mount_from_sensor).norm(), 1e-6) << by_ceres;
  }
}

TEST(Solve, NeverTakesAStepThatRaisesTheCost) {
  Session session = simulated(fixture::stand_session()).session;
  session.mount.estimate = true;
  const Problem problem = make_problem(session, make_chain(session));
  Unknowns start = *start_values(problem, session.mount);
  for (int turn = 0; turn < 12; ++turn) {
    Unknowns wrong = start;
    wrong.mount_from_sensor =
        start.mount_from_sensor * Rigid{rotation_from_rpy({0.5 * turn, 1.1 * turn, 0.3}), {0.2, -0.1, 0.05 * turn}};
    double last = normal_equations(problem, wrong).cost;
    const double at_start = last;
    SolveOptions options;
    options.on_iteration = [&](int, double cost, const Unknowns&) {
      EXPECT_LE(cost, last * (1 + 1e-12)) << turn;
      last = cost;
      return true;
    };
    const Solution s = solve(problem, wrong, options);
    EXPECT_EQ(s.start_cost, at_start);
    EXPECT_LE(s.normal.cost, at_start);
    EXPECT_TRUE(s.normal.in_front || !s.converged) << "behind a camera is no answer";
  }
}

/// The middle of the sandwich is how much the rows differ: where it is what noise of sigma makes of them, the sandwich
/// is the plain covariance; where half of the observations are twice as noisy, it is what a simulation of that finds.
TEST(SandwichCovariance, IsThatOfWhatTheRowsReallyScatter) {
  SimulationOptions o;
  o.observations = 30;
  o.noise = 1e-9;
  const SimulatedSession exact = simulate_session(fixture::tracker_session(3), o);
  const Problem problem = make_problem(exact.session, make_chain(exact.session));
  const Unknowns truth = solve(problem, *start_values(problem, exact.session.mount)).unknowns;
  const Solution at_truth = solve(problem, truth);
  const double sigma = 3e-4;
  EXPECT_LT((covariance_from(sandwich_factor(unit_factor(at_truth), sigma * sigma * at_truth.normal.information)) -
             sigma * sigma * unit_covariance(at_truth))
                .norm(),
            1e-9 * sigma * sigma * unit_covariance(at_truth).norm());

  const auto scale_of = [](const ProblemObservation& observation) { return observation.index % 2 ? 2.0 : 1.0; };
  Eigen::MatrixXd middle = Eigen::MatrixXd::Zero(problem.columns(), problem.columns());
  for (const ProblemObservation& observation : problem.observations) {
    NormalEquations one(problem.columns());
    add_observation(problem, observation, truth, one);
    complete(one);
    middle += std::pow(sigma * scale_of(observation), 2) * one.information;
  }
  const Eigen::MatrixXd predicted = covariance_from(sandwich_factor(unit_factor(at_truth), middle));
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  constexpr int draws = 2000;
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(9);
  for (int draw = 0; draw < draws; ++draw) {
    Problem noisy = problem;
    for (ProblemObservation& observation : noisy.observations)
      for (Sighting& s : observation.sightings)
        *s.point += sigma * scale_of(observation) * fixture::drawn_3([&] { return normal(random); });
    const Solution answer = solve(noisy, truth);
    for (int m = 0; m < 3; ++m)
      variance.segment<3>(3 * m) += (answer.unknowns.markers_in_tcp[static_cast<std::size_t>(m)] -
                                     truth.markers_in_tcp[static_cast<std::size_t>(m)])
                                        .cwiseAbs2() /
                                    draws;
  }
  for (int i = 0; i < 9; ++i)  // a variance of 2000 draws is known to 3 %
    EXPECT_NEAR(variance[i] / predicted(i, i), 1, 0.13) << i;
}

}  // namespace
}  // namespace handsight
