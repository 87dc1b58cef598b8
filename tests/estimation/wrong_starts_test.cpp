// SPDX-License-Identifier: Apache-2.0
// Fits whose session declares a mount, a rig and focal lengths that are far off. tests/trials/trial_wrong_starts has
// 200 of each rig.
#include "fixtures/wrong_starts.h"

#include <gtest/gtest.h>

#include "estimation/fit/sure_fit.h"
#include "estimation/start/multi_start.h"

namespace handsight {
namespace {

TEST(WrongStarts, LeadToTheMinimumThatTheTruthLeadsTo) {
  for (const fixture::NamedSession& rig : fixture::wrong_start_rigs())
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      Fit found;
      const fixture::WrongStart w = fixture::wrong_start(rig, seed);
      EXPECT_EQ(fixture::make_outcome(w, &found), fixture::Outcome::reached) << rig.name << ", seed " << seed;
      EXPECT_LT(found.residual_rms, 0.23) << rig.name << ", seed " << seed << ": the noise is 0.2 px";
    }
}

TEST(WrongStarts, AGoodStartIsNotExchanged) {
  SimulationOptions options;
  options.observations = 30;
  Session session = simulate_session(fixture::stand_session(), options).session;
  session.mount.estimate = session.mount.known = true;
  const Problem problem = make_problem(session, make_chain(session));
  EXPECT_FALSE(looks_lost(problem, fit(session).solution));
}

TEST(WrongStarts, AMountThatIsWrongAndHeldEndsNoHigherThanItBegan) {
  SimulationOptions options;
  options.observations = 30;
  Session session = simulate_session(fixture::stand_session(), options).session;
  session.mount.mount_from_sensor =
      session.mount.mount_from_sensor * Rigid{rotation_from_rpy({0, 1.2, 0}), {0.5, 0, 0}};
  const Fit f = fit(session, {.estimated = effect_terms("link_geometry", make_chain(session))});
  EXPECT_LE(f.solution.normal.cost, f.solution.start_cost);
  EXPECT_TRUE(std::isfinite(f.residual_rms));
  if (!f.solution.normal.in_front) {
    EXPECT_FALSE(f.converged());
    EXPECT_NE(f.notes.back().find("behind a camera"), std::string::npos);
  }
}

TEST(WrongStarts, AnImpossibleStartIsGivenBackUnconverged) {
  SimulationOptions options;
  options.observations = 5;
  const Session session = simulate_session(fixture::stand_session(), options).session;
  const Problem problem = make_problem(session, make_chain(session));
  Unknowns start = {std::vector<Vector3>(3, Vector3::Constant(std::nan(""))), session.mount.mount_from_sensor, {}};
  const Solution s = solve(problem, start);
  EXPECT_FALSE(s.converged);
  EXPECT_EQ(s.iterations, 0);
  EXPECT_TRUE(std::isnan(s.unknowns.markers_in_tcp[0].x()));
}

/// A rig that has moved by 40 mm, forty times what is plausible, is found as it is, not pulled back by its prior.
TEST(WidenedPriors, LetARigThatIsFarOffBeFound) {
  SimulationOptions options;
  options.observations = 60;
  Session session = simulate_session(fixture::stand_session(), options).session;
  const Rigid moved = small_motion<double>((Vector6() << 0.04, 0, -0.02, 0.02, -0.03, 0.01).finished());
  const Rigid truth = session.rig->at(1).camera_from_first;
  session.rig->at(1).camera_from_first = moved * truth;
  const Fit f = fit(session, {.estimated = {{"stereo_rig", -1, std::vector<double>(6, 0.0)}}});
  EXPECT_TRUE(f.converged());
  const Rigid found = f.problem.rig->at(1).camera_from_first;
  const Vector6 off = small_motion_between(truth, found);
  for (std::size_t p = 0; p < 6; ++p) {
    const double sigma = f.effects[0].sigmas[p];
    EXPECT_LT(std::abs(off[static_cast<Eigen::Index>(p)]), 4.5 * sigma) << p;
  }
  EXPECT_NEAR(*f.chi2_per_dof, 1, 4 * std::sqrt(2.0 / f.rows));
  EXPECT_GE(widened_by(f.problem, 0), 10);
  EXPECT_NE(f.notes[0].find("stereo_rig: the measurements say more than 5 times what is plausible"), std::string::npos);
}

TEST(WidenedPriors, StayAsTheyAreForWhatIsPlausible) {
  SimulationOptions options;
  options.observations = 60;
  options.effects = {{"stereo_rig", -1, {2e-3, 0, 1e-3, 3e-3, -2e-3, 1e-3}}};
  const Session session = simulate_session(fixture::stand_session(), options).session;
  const Fit f = fit(session, {.estimated = {{"stereo_rig", -1, std::vector<double>(6, 0.0)}}});
  EXPECT_EQ(widened_by(f.problem, 0), 1);
}

}  // namespace
}  // namespace handsight
