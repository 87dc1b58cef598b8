// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/noise.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <random>

#include "chain/sighting.h"
#include "estimation/fit/fit.h"
#include "estimation/problem/body_pose.h"
#include "fixtures/arms.h"
#include "fixtures/drawn.h"
#include "fixtures/targets.h"

namespace handsight {
namespace {

/// Every pose of a session measured `times` times with this noise, the joints a little off each time; of its first
/// `markers` markers.
Session repeated(const Session& session, const Fit& truth, int poses, int times, int markers, double noise) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  Session out = session;
  out.observations.clear();
  out.sigma_pixel.reset();
  for (int i = 0; i < poses * times; ++i) {
    Observation o = session.observations[static_cast<std::size_t>(i % poses)];
    o.id = i + 1;
    o.time = i;
    for (double& q : o.position) q += 1e-3 * normal(random);
    out.observations.push_back(o);
  }
  const Problem problem = make_problem(out, make_chain(out));
  for (const ProblemObservation& p : problem.observations) {
    std::vector<Sighting>& sightings = out.observations[static_cast<std::size_t>(p.index)].sightings;
    std::erase_if(sightings, [&](const Sighting& s) { return s.marker >= markers; });
    for (Sighting& s : sightings) {
      const Vector3 x = sensor_from_tcp_at(p, estimate(truth).mount_from_sensor) *
                        estimate(truth).markers_in_tcp[static_cast<std::size_t>(s.marker)];
      const auto off = [&] { return Vector2(noise * fixture::drawn_2([&] { return normal(random); })); };
      if (seen_by(s, 0)) see(s, 0, project(out.rig->at(0).camera, x) + off());
      if (seen_by(s, 1))
        see(s, 1, project(out.rig->at(1).camera, Vector3(out.rig->at(1).camera_from_first * x)) + off());
    }
  }
  return out;
}

Session one_marker(int times, double noise) {
  SimulationOptions o;
  o.observations = 20;
  o.seed = 3;
  const Session session = simulate_session(fixture::stand_session(), o).session;
  return repeated(session, fit(session), 20, times, 1, noise);
}

TEST(NoiseFromRepeats, IsTheNoiseOfASessionThatShowsItInNoOtherWay) {
  const Fit f = fit(one_marker(6, 0.3));
  ASSERT_TRUE(f.noise_estimate.has_value());
  EXPECT_TRUE(f.noise_estimate->from_repeats);
  EXPECT_EQ(f.noise_estimate->degrees, 20 * 5 * 4);
  EXPECT_NEAR(*f.noise, 0.3, 4 * f.noise_estimate->error);
  EXPECT_NEAR(f.noise_estimate->error, 0.3 / std::sqrt(800.0), 0.002);
}

TEST(NoiseFromRepeats, DoesNotSeeWhatFollowsThePose) {
  Session session = one_marker(6, 0.3);
  for (Observation& o : session.observations) o.position[1] += 0.01 * std::sin(3 * o.position[2]);  // an unknown error
  const Fit f = fit(session);
  EXPECT_GT(f.residual_rms, 1);
  ASSERT_TRUE(f.noise.has_value());
  EXPECT_NEAR(*f.noise, 0.3, 0.03);
}

TEST(NoiseFromRepeats, SaysNothingWithoutRepeatedPoses) {
  const Fit f = fit(one_marker(1, 0.3));
  EXPECT_FALSE(f.noise_estimate.has_value());
  EXPECT_FALSE(f.noise.has_value());
}

TEST(NoiseFromRepeats, GivesWayToWhatTheSessionDeclares) {
  Session session = one_marker(6, 0.3);
  session.sigma_pixel = 0.25;
  const Fit f = fit(session);
  EXPECT_EQ(*f.noise, 0.25);
}

/// A ball that is put into one of several sockets: each is a marker, seen alone.
TEST(RobotFreeNoise, IsNotToldByMarkersThatAreSeenOneAtATime) {
  SimulationOptions options;
  options.observations = 40;
  Session session = simulate_session(fixture::tracker_session(4), options).session;
  for (std::size_t k = 0; k < session.observations.size(); ++k)
    std::erase_if(session.observations[k].sightings,
                  [&](const Sighting& s) { return s.marker != static_cast<int>(k % 4); });
  session.sigma_point.reset();
  const Fit f = fit(session);
  EXPECT_TRUE(f.converged());
  EXPECT_FALSE(f.noise_estimate.has_value());
}

/// A tracker's virtual points stand against each other to the last digit, while the robot does not repeat.
TEST(RobotFreeNoise, IsNotThatOfPointsThatAreRigidByConstruction) {
  SimulationOptions options;
  options.observations = 60;
  options.noise = 1e-8;
  Session session = simulate_session(fixture::tracker_session(3), options).session;
  session.sigma_point.reset();
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal(0, 1e-3);
  for (Observation& o : session.observations)
    for (double& q : o.position) q += normal(random);
  const Fit f = fit(session);
  EXPECT_GT(f.residual_rms, 1e-4);
  EXPECT_FALSE(f.noise_estimate.has_value());
  EXPECT_FALSE(f.noise.has_value());
  EXPECT_EQ(f.covariance_kind, CovarianceKind::repeatability);
  ASSERT_FALSE(f.notes.empty());
  EXPECT_NE(f.notes[0].find("rigid by construction"), std::string::npos);
}

/// A file of five decimals: what the points seem to scatter by is how they were written.
Session written_to_10_um(double noise) {
  SimulationOptions options;
  options.observations = 60;
  options.noise = noise;
  Session session = simulate_session(fixture::tracker_session(4), options).session;
  session.sigma_point.reset();
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal(0, 1e-3);
  for (Observation& o : session.observations) {
    for (double& q : o.position) q += normal(random);
    for (Sighting& s : o.sightings) s.point = 1e-5 * (1e5 * *s.point).array().round().matrix();
  }
  return session;
}

TEST(RobotFreeNoise, IsNotThatOfWritingPointsDown) {
  const Fit computed = fit(written_to_10_um(1e-8));
  EXPECT_FALSE(computed.noise.has_value());
  ASSERT_FALSE(computed.notes.empty());
  EXPECT_NE(computed.notes[0].find("rigid by construction"), std::string::npos);
  const Fit measured = fit(written_to_10_um(2e-5));
  ASSERT_TRUE(measured.noise.has_value());
  EXPECT_NEAR(*measured.noise, 2e-5, 2e-6);
}

/// One regression of all rows by the poses of all observations, the markers and the rig.
struct WholeRegression {
  double sigma = 0;
  Eigen::Index degrees = 0;
};

WholeRegression regress(const Problem& problem, const Unknowns& u) {
  const Rig* rig = problem.rig_or_null();
  const auto poses = static_cast<Eigen::Index>(6 * problem.observations.size());
  const Eigen::Index markers = 3 * problem.marker_count, cameras = rig ? rig_number_count(rig->count()) : 0;
  Eigen::Index count = 0;
  for (const ProblemObservation& o : problem.observations)
    for (const Sighting& s : o.sightings) count += row_count(s);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count, poses + markers + cameras);
  Eigen::VectorXd error(count);
  Eigen::Index row = 0, pose = 0;
  for (const ProblemObservation& o : problem.observations) {
    const Rigid at = sensor_from_tcp_at(o, u);
    const Rigid sensor_from_tcp = refined_body_pose(rig, o.sightings, u.markers_in_tcp, at, 1e-3).value_or(at);
    for (const Sighting& s : o.sightings) {
      const Vector3 x = sensor_from_tcp * u.markers_in_tcp[static_cast<std::size_t>(s.marker)];
      const SightingResidual r = sighting_residual(rig, s, x);
      rows.block(row, pose, r.rows, 3) = r.by_point;
      rows.block(row, pose + 3, r.rows, 3) = -r.by_point * cross_matrix(x);
      rows.block(row, poses + 3 * s.marker, r.rows, 3) = r.by_point * sensor_from_tcp.rotation;
      if (rig) rows.block(row, poses + markers, r.rows, cameras) = camera_columns(*rig, s, x);
      error.segment(row, r.rows) = r.error;
      row += r.rows;
    }
    pose += 6;
  }
  for (Eigen::Index c = 0; c < rows.cols(); ++c)
    if (const double norm = rows.col(c).norm(); norm > 0) rows.col(c) /= norm;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(1e-9);
  qr.compute(rows);
  Eigen::VectorXd left = qr.householderQ().adjoint() * error;
  const Eigen::Index degrees = count - qr.rank();
  return {left.tail(degrees).norm() / std::sqrt(static_cast<double>(degrees)), degrees};
}

TEST(RobotFreeNoise, IsThatOfOneRegressionOfAllRows) {
  SimulationOptions options;
  options.observations = 25;
  for (Session session : {fixture::stand_session(4), fixture::stand_session(6), fixture::tracker_session(3),
                          fixture::tracker_session(5), fixture::target_session(), fixture::eye_in_hand_session()}) {
    session = simulate_session(session, options).session;
    session.sigma_pixel.reset();
    session.sigma_point.reset();
    // Not every marker is always seen, and not by every camera.
    for (std::size_t k = 0; k < session.observations.size(); k += 3) {
      std::vector<Sighting>& sightings = session.observations[k].sightings;
      if (session.rig && session.rig->count() == 2) forget(sightings.front(), 1);
      if (sightings.size() > 3) sightings.pop_back();
    }
    const Fit f = fit(session);
    const auto noise = estimate_noise(f.problem, estimate(f));
    ASSERT_TRUE(noise.has_value());
    const WholeRegression whole = regress(f.problem, estimate(f));
    EXPECT_EQ(noise->degrees, whole.degrees);
    EXPECT_NEAR(noise->sigma, whole.sigma, 1e-9 * whole.sigma);
  }
}

TEST(ChiSquaredTail, HasAnAnswerForEverySum) {
  EXPECT_NEAR(chi_squared_tail(3.841459, 1), 0.05, 1e-7);
  EXPECT_NEAR(chi_squared_tail(100, 100), 0.481192, 1e-6);
  for (const double degrees : {1., 100., 4321., 1e5, 1e7})
    for (const double share : {0., 1e-30, 1e-12, 1e-5, 0.01, 0.45}) {
      const double p = chi_squared_tail(share * degrees, degrees);
      EXPECT_GE(p, 0.45) << share << " of " << degrees;
      EXPECT_LE(p, 1);
    }
  for (const double degrees : {1., 100., 4321., 1e5, 1e7}) EXPECT_EQ(chi_squared_tail(1e30, degrees), 0);
  EXPECT_LT(chi_squared_tail(2e6, 1e6), 1e-5) << "of sums over long sessions too";
}

/// What an engineer tries first: a simulation without noise.
TEST(Noise, IsTheFinestOfSensorsWhereASessionWasComputedWithoutAny) {
  SimulationOptions options;
  options.observations = 40;
  options.noise = 0;
  for (Session session : {simulate_session(fixture::tracker_session(4), options).session,
                          simulate_session(fixture::stand_session(), options).session}) {
    session.sigma_point.reset();
    session.sigma_pixel.reset();
    const Fit f = fit(session);
    ASSERT_TRUE(f.noise.has_value());
    EXPECT_EQ(*f.noise, session.is_tracker() ? 2e-6 : 2e-3);
    EXPECT_LT(f.residual_rms, 1e-9);
    EXPECT_EQ(f.covariance_kind, CovarianceKind::noise);
    ASSERT_FALSE(f.notes.empty());
    EXPECT_NE(f.notes[0].find("computed without noise"), std::string::npos);
  }
}

}  // namespace
}  // namespace handsight
