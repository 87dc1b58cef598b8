// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/fit.h"

#include <gtest/gtest.h>

#include "estimation/report/fit_report.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

/// The truth in the body frame of the true markers.
Rigid true_body(const SimulatedSession& s, const Fit& f) { return body_frame(f.sides, s.markers_in_tcp).tcp_from_body; }

/// How far the estimate is from the truth in units of its own sigma (chi-squared of 6 degrees).
double distance(const SimulatedSession& s, const Fit& f) {
  const Vector6 error = small_motion_between(true_body(s, f), f.tcp_from_body);
  return error.dot(f.covariance.inverse() * error);
}

SimulatedSession simulated(const Session& like, std::uint64_t seed, int observations = 40) {
  SimulationOptions options;
  options.seed = seed;
  options.observations = observations;
  return simulate_session(like, options);
}

constexpr double chi2_6_at_1e_4 = 27.9;  // one run in 10,000 is beyond

TEST(Fit, RecoversTheTruthWithinItsCovarianceByEveryObjective) {
  const SimulatedSession s = simulated(fixture::stand_session(), 3);
  for (const Objective objective : {Objective::image, Objective::camera, Objective::angle_axis})
    for (const bool fix_markers : {false, true}) {
      const Fit f = fit(s.session, {.objective = objective, .fix_markers = fix_markers});
      EXPECT_TRUE(f.converged());
      EXPECT_EQ(f.covariance_kind, CovarianceKind::noise);
      EXPECT_LT(distance(s, f), chi2_6_at_1e_4) << static_cast<int>(objective) << fix_markers;
      EXPECT_GT(f.covariance.diagonal().minCoeff(), 0);
      if (objective == Objective::image && !fix_markers) {  // the others leave more of the noise by their nature
        EXPECT_NEAR(*f.chi2_per_dof, 1, 4 * std::sqrt(2.0 / f.rows));
      }
    }
}

TEST(Fit, WithoutNoiseEveryObjectiveIsExact) {
  SimulationOptions options;
  options.noise = 0;
  options.observations = 12;
  const SimulatedSession s = simulate_session(fixture::stand_session(), options);
  for (const Objective objective : {Objective::image, Objective::camera, Objective::angle_axis}) {
    const Fit f = fit(s.session, {.objective = objective});
    EXPECT_LT(small_motion_between(true_body(s, f), f.tcp_from_body).norm(), 1e-9) << static_cast<int>(objective);
  }
}

TEST(Fit, FindsAMountOfWhichNothingIsKnown) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SimulatedSession s = simulated(fixture::stand_session(), seed);
    s.session.mount.estimate = true;
    s.session.mount.known = false;
    s.session.mount.mount_from_sensor = Rigid{};
    const Fit f = fit(s.session);
    EXPECT_TRUE(f.converged());
    EXPECT_LT(small_motion_between(s.mount_from_sensor, estimate(f).mount_from_sensor).norm(), 0.02) << seed;
    EXPECT_LT(distance(s, f), chi2_6_at_1e_4) << seed;
  }
}

TEST(Fit, FindsAnUnknownTrackerMountFromOneMarker) {
  SimulatedSession s = simulated(fixture::tracker_session(1), 5);
  s.session.mount.estimate = true;
  s.session.mount.known = false;
  s.session.mount.mount_from_sensor = Rigid{};
  const Fit f = fit(s.session);
  EXPECT_LT((estimate(f).markers_in_tcp[0] - s.markers_in_tcp[0]).norm(), 1e-3);
  EXPECT_FALSE(f.rotation_is_observed);
  EXPECT_GT(f.covariance(3, 3), 1);  // rad^2: nothing is known
}

TEST(Fit, UsesMarkersThatOnlyOneCameraSees) {
  SimulatedSession s = simulated(fixture::stand_session(), 7, 12);
  const Fit whole = fit(s.session);
  for (Observation& o : s.session.observations) {
    forget(o.sightings[0], 1);
    forget(o.sightings[1], 0);
  }
  const Fit half = fit(s.session);
  EXPECT_EQ(half.rows, whole.rows - 12 * 4);
  EXPECT_LT(distance(s, half), chi2_6_at_1e_4);
  EXPECT_GT(half.covariance(0, 0), whole.covariance(0, 0));
}

TEST(Fit, MarkersSeenAFewAtATimeShareOneBody) {
  SimulatedSession s = simulated(fixture::stand_session(8), 8, 40);
  for (std::size_t k = 0; k < s.session.observations.size(); ++k) {
    std::vector<Sighting> seen;
    for (int i = 0; i < 3; ++i)
      seen.push_back(s.session.observations[k].sightings[(3 * k + static_cast<std::size_t>(i)) % 8]);
    s.session.observations[k].sightings = seen;
  }
  EXPECT_LT(distance(s, fit(s.session)), chi2_6_at_1e_4);
  EXPECT_LT(distance(s, fit(s.session, {.fix_markers = true})), chi2_6_at_1e_4);
}

TEST(Fit, OrderInMemoryDoesNotMatter) {
  SimulatedSession s = simulated(fixture::stand_session(), 9);
  s.session.mount.estimate = true;
  const Fit one = fit(s.session);
  std::reverse(s.session.observations.begin(), s.session.observations.end());
  std::swap(s.session.observations[3], s.session.observations[17]);
  const Fit other = fit(s.session);
  EXPECT_LT(small_motion_between(one.tcp_from_body, other.tcp_from_body).norm(), 1e-9);
  EXPECT_LT((one.covariance - other.covariance).norm(), 1e-9);
}

TEST(Fit, RobustLossStandsWrongCorners) {
  SimulatedSession s = simulated(fixture::stand_session(), 10);
  for (const std::size_t k : {3, 11, 20, 31}) seen_by(s.session.observations[k].sightings[1], 0)->pixel.x() += 25;
  const double plain = small_motion_between(true_body(s, fit(s.session)), fit(s.session).tcp_from_body).norm();
  for (const Loss loss : {Loss::huber, Loss::cauchy}) {
    const Fit robust = fit(s.session, {.loss = loss});
    EXPECT_LT(small_motion_between(true_body(s, robust), robust.tcp_from_body).norm(), 0.5 * plain);
  }
}

TEST(Fit, ASingleObservationGivesThesis435WithAWarning) {
  SimulatedSession s = simulated(fixture::stand_session(), 11, 1);
  const Fit f = fit(s.session);
  EXPECT_LT(f.residual_rms, 0.3);
  ASSERT_FALSE(f.notes.empty());
  EXPECT_NE(f.notes[0].find("Only one observation"), std::string::npos);
}

TEST(Fit, RefusesWhenThereIsNothingToFit) {
  Session s = fixture::stand_session();
  EXPECT_THROW(fit(s), InputError);
}

TEST(Fit, FindsAnUnknownMountWhereOneOfTwoCamerasSawAll) {
  SimulatedSession one_camera = simulated(fixture::stand_session(), 12, 10);
  one_camera.session.mount.estimate = true;
  one_camera.session.mount.known = false;
  for (Observation& o : one_camera.session.observations)
    for (Sighting& sighting : o.sightings) forget(sighting, 1);
  const Fit f = fit(one_camera.session);
  EXPECT_TRUE(f.converged());
  EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / (f.rows - f.unknowns)));
}

TEST(Noise, IsSeenWhateverTheRobotDoes) {
  SimulatedSession s = simulated(fixture::stand_session(), 13, 200);
  for (std::size_t k = 0; k < s.session.observations.size(); ++k)
    s.session.observations[k].position[1] += 0.02 * std::sin(3.0 * static_cast<double>(k));  // 2 cm at the hand
  s.session.sigma_pixel.reset();
  const Fit f = fit(s.session);
  EXPECT_GT(f.residual_rms, 5 * 0.2);
  ASSERT_TRUE(f.noise_estimate);
  EXPECT_NEAR(f.noise_estimate->sigma, 0.2, 4 * f.noise_estimate->error);
  EXPECT_EQ(f.covariance_kind, CovarianceKind::repeatability);
}

TEST(Noise, AWrongDeclarationIsSaid) {
  SimulatedSession s = simulated(fixture::stand_session(), 14, 100);
  s.session.sigma_pixel = 0.5;
  const Fit f = fit(s.session);
  EXPECT_EQ(*f.noise, 0.5);
  ASSERT_FALSE(f.notes.empty());
  EXPECT_NE(f.notes[0].find("declared noise"), std::string::npos);
}

TEST(Report, HeldOutErrorIsNearTheNoiseAndAboveTheFitted) {
  const SimulatedSession s = simulated(fixture::stand_session(), 15, 60);
  const Fit f = fit(s.session);
  const FitReport r = report(s.session, f);
  EXPECT_EQ(r.used, 60);
  EXPECT_GT(*r.held_out.rms_pixel, *r.fitted.rms_pixel);
  EXPECT_NEAR(*r.held_out.rms_pixel, 0.2, 0.02);
  EXPECT_NEAR(*r.fitted.rms_pixel, f.residual_rms, 1e-12);
}

TEST(Report, NamesTheOutlierAndSaysWhatWasNotUsed) {
  SimulatedSession s = simulated(fixture::stand_session(), 16, 30);
  seen_by(s.session.observations[12].sightings[0], 0)->pixel.y() += 9;
  s.session.observations[4].decision = Decision::excluded;
  s.session.observations[4].reason = "cable in view";
  s.session.observations[5].sightings.clear();
  const FitReport r = report(s.session, fit(s.session));
  for (const ObservationReport& o : r.per_observation) EXPECT_EQ(o.outlier, o.id == 12) << o.id;
  ASSERT_EQ(r.rejected.size(), 2u);
  EXPECT_EQ(r.rejected[0].reason, "excluded: cable in view");
}

TEST(Report, AConstantErrorOf20mmIs20mm) {
  SimulationOptions options;
  options.noise = 0;
  options.observations = 20;
  SimulatedSession s = simulate_session(fixture::tracker_session(), options);
  const Fit f = fit(s.session);
  for (Observation& o : s.session.observations) {
    // The hand stands 20 mm off along the TCP's -x in every pose: the deviation is seen in the report as such.
    const std::size_t k = static_cast<std::size_t>(o.id);
    const Rigid sensor_from_tcp = inverse(s.root_from_sensor[k]) * s.root_from_tcp[k];
    for (Sighting& sighting : o.sightings) *sighting.point += sensor_from_tcp.rotation * Vector3(-0.02, 0, 0);
    const Problem problem = make_problem(s.session, make_chain(s.session));
    const auto deviation = tcp_deviation(problem, problem.observations[k], estimate(f));
    ASSERT_TRUE(deviation);
    EXPECT_LT((deviation->tcp_from_tcp_est.translation - Vector3(-0.02, 0, 0)).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace handsight
