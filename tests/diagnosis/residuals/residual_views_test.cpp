// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/residuals/residual_views.h"

#include <gtest/gtest.h>

#include "fixtures/arms.h"

namespace handsight {
namespace {

Session sprung(const std::vector<EffectTerm>& effects, std::uint64_t seed, double noise) {
  Session like = fixture::stand_session();
  like.robot.joints[1].stiffness = like.robot.joints[2].stiffness = 12000;
  SimulationOptions o;
  o.effects = effects;
  o.seed = seed;
  o.observations = 60;
  o.noise = noise;
  o.declare_noise = noise == 0;
  Session session = simulate_session(like, o).session;
  if (noise == 0) session.sigma_pixel = 0.2;
  return session;
}

double rms(const Eigen::VectorXd& x) { return std::sqrt(x.squaredNorm() / static_cast<double>(x.size())); }

Eigen::VectorXd stacked(const std::vector<CornerResidual>& corners) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(2 * corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) x.segment<2>(static_cast<Eigen::Index>(2 * i)) = corners[i].residual;
  return x;
}

/// The same poses and cameras with the markers where they are seen if a model with these effects is true.
Session as_if(const Session& session, const Fit& fit, const std::vector<EffectTerm>& effects) {
  Session changed = session;
  const Problem moved = make_problem(session, make_chain(session), effects);
  for (const ProblemObservation& o : moved.observations) {
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, estimate(fit).mount_from_sensor);
    for (Sighting& s : changed.observations[static_cast<std::size_t>(o.index)].sightings) {
      const Vector3 x = sensor_from_tcp * marker_at(o, estimate(fit), s.marker);
      if (seen_by(s, 0)) see(s, 0, project(session.rig->at(0).camera, x));
      if (seen_by(s, 1))
        see(s, 1, project(session.rig->at(1).camera, Vector3(session.rig->at(1).camera_from_first * x)));
    }
  }
  return changed;
}

TEST(ResidualViews, AnEffectLooksAsIfItWereThere) {
  const std::vector<EffectTerm> hidden = {{"encoder_eccentricity", 1, {4e-4, -2e-4}}};
  const Session session = sprung({}, 5, 0);
  const Fit right = fit(session);
  const ResidualViews without = residual_views(right);
  const ResidualViews with = residual_views(fit(as_if(session, right, hidden)));
  const EffectView view = effect_view(without, hidden);
  const Eigen::VectorXd value = list_numbers(view, hidden);
  ASSERT_EQ(with.series.size(), view.series.size());
  for (std::size_t s = 0; s < view.series.size(); ++s) {
    const Eigen::VectorXd looks = view.series[s] * value;
    EXPECT_LT(rms(looks - with.series[s].values), 0.02 * rms(looks)) << with.series[s].name;
  }
  const Eigen::VectorXd image = view.corners * value;
  EXPECT_GT(rms(image), 0.05);
  EXPECT_LT(rms(image - stacked(with.corners)), 0.02 * rms(image));
}

TEST(ResidualViews, TheBestSizeIsTheTrueOneAndLeavesTheNoise) {
  const std::vector<EffectTerm> hidden = {{"encoder_eccentricity", 1, {2e-3, -1e-3}}};
  const Fit f = fit(sprung(hidden, 6, 0.2), {.smallest_step = 1e-9});  // as a diagnosis fits
  const ResidualViews views = residual_views(f);
  const EffectView view = effect_view(views, {{"encoder_eccentricity", 1, {0, 0}}});
  ASSERT_EQ(view.best.size(), 2);
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(view.best[i], hidden[0].values[static_cast<std::size_t>(i)],
                4 * view.best_sigma[i] + 0.02 * std::abs(view.best[i]));
  EXPECT_NEAR(rms_left(views, view, view.best), 0.2, 0.02);
  EXPECT_NEAR(rms_left(views, view, Eigen::Vector2d::Zero()), std::sqrt(f.solution.normal.data_cost() / views.degrees),
              1e-6);
  EXPECT_LT(rms(stacked(views.corners) - view.corners * view.best), 0.22);
  EXPECT_GT(rms(stacked(views.corners)), 0.4);
}

TEST(ResidualViews, NoiseAloneIsAsLargeAsItsSigmaAndAnotherAtEachDraw) {
  const ResidualViews views = residual_views(fit(sprung({}, 7, 0.2)));
  const auto first = noise_alone(views, 1), again = noise_alone(views, 1), second = noise_alone(views, 2);
  double squares = 0, count = 0;
  for (std::size_t s = 0; s < first.size(); ++s) {
    EXPECT_EQ(first[s], again[s]);
    EXPECT_NE(first[s], second[s]);
    squares += first[s].cwiseQuotient(views.series[s].sigmas).squaredNorm();
    count += static_cast<double>(first[s].size());
  }
  EXPECT_NEAR(std::sqrt(squares / count), 1, 0.1);
}

TEST(ResidualViews, CornersFollowTheUnknowns) {
  const Session session = sprung({{"joint_elasticity", 1, {1e-4}}}, 8, 0.2);
  FitOptions o;
  o.estimated = {{"joint_elasticity", 1, {5e-5}}};
  const Fit f = fit(session, o);
  // Corners at other numbers of the effects, to first order, are those of the problem moved there.
  Unknowns u = estimate(f);
  u.effects[0] *= 1.1;
  Problem there = f.problem;
  set_effects(there, u.effects);
  const Eigen::VectorXd expected = stacked(corner_residuals(there, u));
  const Eigen::VectorXd change = expected - stacked(corner_residuals(f.problem, estimate(f)));
  EXPECT_GT(rms(change), 0.05);
  EXPECT_LT(rms(stacked(corner_residuals(f.problem, u)) - expected), 0.02 * rms(change));
}

TEST(ResidualViews, APartShowsWhatAllOfThemShowInTheSamePlaces) {
  const Fit f = fit(sprung({{"joint_elasticity", 1, {1e-4}}}, 9, 0.2));
  const ResidualViews all = residual_views(f), part = residual_views(f, 21);
  EXPECT_EQ(all.problem.observations.size(), 60u);
  EXPECT_EQ(part.fitted, 60);
  ASSERT_EQ(part.problem.observations.size(), 21u);
  EXPECT_EQ(part.problem.observations.front().index, all.problem.observations.front().index);
  EXPECT_EQ(part.problem.observations.back().index, all.problem.observations.back().index);
  ASSERT_EQ(part.series.size(), all.series.size());
  const double corners_each = static_cast<double>(all.corners.size()) / 60;
  EXPECT_EQ(static_cast<double>(part.corners.size()), 21 * corners_each);
  for (std::size_t i = 0, j = 0; i < part.problem.observations.size(); ++i) {
    while (all.problem.observations[j].index != part.problem.observations[i].index) ++j;
    const auto at = static_cast<Eigen::Index>(i), there = static_cast<Eigen::Index>(j);
    for (std::size_t c = 0; c < static_cast<std::size_t>(corners_each); ++c)
      EXPECT_EQ(part.corners[i * static_cast<std::size_t>(corners_each) + c].residual,
                all.corners[j * static_cast<std::size_t>(corners_each) + c].residual);
    for (std::size_t v = 0; v < all.variables.size(); ++v)
      EXPECT_EQ(part.variables[v].values[at], all.variables[v].values[there]) << all.variables[v].name;
    for (std::size_t s = 0; s < all.series.size(); ++s)
      EXPECT_NEAR(part.series[s].values[at], all.series[s].values[there], 1e-9) << all.series[s].name;
  }
  // An effect looks as large by a part as by all, and leaves as much.
  const std::vector<EffectTerm> spring = {{"joint_elasticity", 1, {1e-4}}};
  const EffectView by_all = effect_view(all, spring), by_part = effect_view(part, spring);
  EXPECT_NEAR(by_part.best[0], by_all.best[0], 4 * by_part.best_sigma[0]);
  EXPECT_NEAR(rms_left(part, by_part, by_part.best), rms_left(all, by_all, by_all.best), 0.03)
      << "0.2 px are the noise";
}

TEST(ResidualViews, APartThatIsNotSmallerIsAll) {
  const Fit f = fit(sprung({}, 9, 0.2));
  const ResidualViews all = residual_views(f), part = residual_views(f, 60);
  EXPECT_EQ(part.problem.observations.size(), 60u);
  EXPECT_EQ(part.degrees, all.degrees);
  EXPECT_EQ(stacked(part.corners), stacked(all.corners));
}

}  // namespace
}  // namespace handsight
