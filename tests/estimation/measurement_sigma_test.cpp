// SPDX-License-Identifier: Apache-2.0
// Fits of measurements that are not equally sure.
#include <gtest/gtest.h>

#include <random>

#include "body_error.h"
#include "estimation/report/fit_report.h"
#include "fixtures/arms.h"
#include "fixtures/drawn.h"

namespace handsight {
namespace {

constexpr double sure = 0.2, unsure = 2;  // px

/// Marker 0 is labelled by hand, ten times worse than the others; sigmas are reported as `reported` times what they
/// are.
SimulatedSession mixed(std::uint64_t seed, double reported) {
  SimulationOptions options;
  options.seed = seed;
  options.observations = 40;
  SimulatedSession s = simulate_session(fixture::stand_session(4), options);
  s.session.sigma_pixel.reset();
  s.session.mount.estimate = true;  // else every marker is estimated by itself
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, std::sqrt(unsure * unsure - sure * sure));
  for (Observation& o : s.session.observations)
    for (Sighting& one : o.sightings) {
      const bool by_hand = one.marker == 0;
      for (Vector2* pixel : {&seen_by(one, 0)->pixel, &seen_by(one, 1)->pixel})
        if (by_hand) *pixel += fixture::drawn_2([&] { return normal(random); });
      const double sigma = reported * (by_hand ? unsure : sure);
      if (reported > 0) seen_by(one, 0)->sigma = seen_by(one, 1)->sigma = PixelSigma{sigma, sigma, 0};
    }
  return s;
}

double mount_error(const SimulatedSession& s, const Fit& f) {
  return small_motion_between(s.mount_from_sensor, estimate(f).mount_from_sensor).squaredNorm();
}

TEST(MeasurementSigmas, WeighTheFitAndTheNoiseIsAFactorOnThem) {
  const Fit truly = fit(mixed(1, 1).session), half = fit(mixed(1, 0.5).session);
  ASSERT_TRUE(truly.noise_estimate && half.noise_estimate);
  EXPECT_NEAR(*truly.noise, 0.2, 4 * truly.noise_estimate->error) << "px, of a measurement of the usual sigma";
  EXPECT_NEAR(*half.noise, 0.2, 4 * half.noise_estimate->error) << "told 0.1 px, seen twice that";
  EXPECT_EQ(truly.covariance_kind, CovarianceKind::noise);
  EXPECT_LT((truly.tcp_from_body.translation - half.tcp_from_body.translation).norm(), 1e-9);
  EXPECT_LT((truly.covariance - half.covariance).norm(), 1e-6 * truly.covariance.norm());
}

TEST(MeasurementSigmas, MakeItBetterAndItsCovarianceRight) {
  constexpr int draws = 60;
  double weighed = 0, pooled = 0, squares = 0;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const SimulatedSession s = mixed(seed, 1), without = mixed(seed, 0);
    const Fit f = fit(s.session);
    weighed += mount_error(s, f);
    pooled += mount_error(without, fit(without.session));
    squares += body_error(s, f).dot(f.covariance.inverse() * body_error(s, f)) / draws;
  }
  EXPECT_LT(weighed, 0.9 * pooled);
  EXPECT_NEAR(squares, 6, 4 * std::sqrt(12.0 / draws)) << "chi-squared of six";
}

TEST(MeasurementSigmas, GiveOneMarkerANoise) {
  SimulationOptions options;
  options.observations = 40;
  Session session = simulate_session(fixture::tracker_session(1), options).session;
  session.sigma_point.reset();
  EXPECT_FALSE(fit(session).noise.has_value());
  for (Observation& o : session.observations) o.sightings[0].point_sigma = 2e-4;
  const Fit f = fit(session);
  ASSERT_TRUE(f.noise.has_value());
  EXPECT_EQ(*f.noise, 2e-4);
  EXPECT_EQ(f.covariance_kind, CovarianceKind::noise);
  EXPECT_NEAR(*f.chi2_per_dof, 1, 4 * std::sqrt(2.0 / f.rows));
}

}  // namespace
}  // namespace handsight
