// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/attribution/error_attribution.h"

#include <gtest/gtest.h>

#include <random>

#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/finding.h"
#include "estimation/fit/fit.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

Session measured(double noise, const Session& like = fixture::stand_session()) {
  SimulationOptions o;
  o.observations = 40;
  o.seed = 11;
  o.noise = noise;
  Session session = simulate_session(like, o).session;
  session.sigma_pixel = 0.2;
  return session;
}

const ObservationAttribution& of(const std::vector<ObservationAttribution>& list, std::int64_t id) {
  return *std::find_if(list.begin(), list.end(), [&](const ObservationAttribution& b) { return b.id == id; });
}

Sighting& seen_by_both(Observation& o) {
  return *std::find_if(o.sightings.begin(), o.sightings.end(),
                       [](const Sighting& s) { return seen_by(s, 0) && seen_by(s, 1); });
}

TEST(ErrorAttribution, NobodyIsToBlameForNoise) {
  const Session session = measured(0.2);
  for (const ObservationAttribution& b : attribute_observations(session, fit(session))) {
    EXPECT_EQ(b.attribution.cause, ErrorCause::none) << b.id;
    EXPECT_EQ(b.change.kind, SingleChange::Kind::none);
    ASSERT_TRUE(b.smallest_visible.has_value());
    EXPECT_GT(*b.smallest_visible, 1);  // 5.5 sigma of a corner that nothing else takes up
  }
}

TEST(ErrorAttribution, AWrongCornerIsTheCamerasAndSaysWhereItBelongs) {
  Session session = measured(0.2);
  const Fit right = fit(session);
  Sighting& s = seen_by_both(session.observations[7]);
  const int marker = s.marker;
  seen_by(s, 1)->pixel += Vector2(1, 9);
  const ObservationAttribution b = of(attribute_observations(session, right), session.observations[7].id);
  EXPECT_EQ(b.attribution.cause, ErrorCause::cameras);
  EXPECT_GT(b.attribution.cameras, b.attribution.robot);
  EXPECT_EQ(b.change.kind, SingleChange::Kind::corner);
  EXPECT_EQ(b.change.marker, marker);
  EXPECT_EQ(b.change.camera, 1);
  EXPECT_LT((b.change.shift + Vector2(1, 9)).norm(), 1.5);
  const std::string text = change_text(b.change, right.problem.rig_or_null());
  EXPECT_NE(text.find("right image"), std::string::npos) << text;
  EXPECT_NE(text.find("px further up"), std::string::npos) << text;
}

TEST(ErrorAttribution, AMarkerThatMovedIsTheBodysAndSaysByHowMuch) {
  Session session = measured(0.2, fixture::seven_axis_session());  // four markers: three are left to agree
  const Fit right = fit(session);
  const ProblemObservation& o = right.problem.observations[9];
  Sighting& s = seen_by_both(session.observations[static_cast<std::size_t>(o.index)]);
  const std::vector<Vector3>& markers = estimate(right).markers_in_tcp;
  const std::size_t other = s.marker == 0 ? 1 : 0;  // toward it, so that no turn of the body can take it up
  const Vector3 offset = 0.008 * (markers[other] - markers[static_cast<std::size_t>(s.marker)]).normalized();
  const Vector3 x = sensor_from_tcp_at(o, estimate(right).mount_from_sensor) *
                    (estimate(right).markers_in_tcp[static_cast<std::size_t>(s.marker)] + offset);
  see(s, 0, project(session.rig->at(0).camera, x));
  see(s, 1, project(session.rig->at(1).camera, Vector3(session.rig->at(1).camera_from_first * x)));
  const ObservationAttribution b =
      of(attribute_observations(session, right), session.observations[static_cast<std::size_t>(o.index)].id);
  EXPECT_EQ(b.attribution.cause, ErrorCause::body);
  EXPECT_EQ(b.change.kind, SingleChange::Kind::marker);
  EXPECT_GT(b.change.size, 0.003);
  EXPECT_LT(b.change.size, 0.02);
}

TEST(ErrorAttribution, ASlippedJointIsTheRobots) {
  Session session = measured(0.2);
  const Fit right = fit(session);
  session.observations[5].position[1] += 0.02;
  const ObservationAttribution b = of(attribute_observations(session, right), session.observations[5].id);
  EXPECT_EQ(b.attribution.cause, ErrorCause::robot);
  EXPECT_GT(b.attribution.robot, 0.9);
  EXPECT_EQ(b.change.kind, SingleChange::Kind::pose);
  EXPECT_NEAR(b.change.angle, 0.02, 0.004);
}

TEST(ErrorAttribution, OfAWholeSessionIsTheRobotsWhereAnEffectIsMissing) {
  SimulationOptions o;
  o.observations = 60;
  o.effects = {{"encoder_eccentricity", 1, {2e-3, 1e-3}}};
  o.noise = 0.2;
  const Session session = simulate_session(fixture::stand_session(), o).session;
  std::vector<ResidualParts> parts;
  for (const ObservationAttribution& b : attribute_observations(session, fit(session))) parts.push_back(b.parts);
  const ErrorAttribution whole = attribute_error(parts, 0.2);
  EXPECT_EQ(whole.cause, ErrorCause::robot);
  EXPECT_GT(whole.robot, 0.8);
  EXPECT_NEAR(whole.robot + whole.body + whole.cameras, 1, 1e-12);
}

/// A wrong lens bends both images of a marker alike: residuals alone blame the robot, what is found does not.
TEST(ErrorAttribution, OfASessionFollowsWhatTheDiagnosisFound) {
  SimulationOptions o;
  o.observations = 60;
  o.effects = {{"lens_distortion", -1, {0.03, 0, 0, 0, 0.03, 0, 0, 0}}};
  o.noise = 0.2;
  const Session session = simulate_session(fixture::stand_session(), o).session;
  std::vector<ResidualParts> parts;
  for (const ObservationAttribution& b : attribute_observations(session, fit(session))) parts.push_back(b.parts);
  EXPECT_EQ(attribute_error(parts, 0.2).cause, ErrorCause::robot) << "as far as residuals alone say";
  const Diagnosis d = diagnose(session);
  ASSERT_EQ(d.candidates.front().id, "lens_distortion");
  EXPECT_EQ(d.attribution.cause, ErrorCause::cameras);
  EXPECT_GT(d.attribution.cameras, 0.8);
  EXPECT_NEAR(d.attribution.robot + d.attribution.body + d.attribution.cameras, 1, 1e-12);
}

TEST(SmallestVisible, IsTheErrorThatTheTestSeesFourTimesInFive) {
  const Session session = measured(0);
  const Fit f = fit(session);
  const ProblemObservation& o = f.problem.observations[3];
  const double visible = *smallest_visible(f.problem, o, estimate(f), 0.2);
  double least = 1e300;  // squares in units of the noise that such an error shows, of the corner that shows it least
  for (std::size_t i = 0; i < o.sightings.size(); ++i)
    for (const bool left : {true, false})
      for (int k = 0; k < 90; ++k) {
        ProblemObservation off = o;
        const Vector2 error = 0.01 * Vector2(std::cos(k * EIGEN_PI / 90), std::sin(k * EIGEN_PI / 90));
        CameraPoint* const corner = seen_by(off.sightings[i], left ? 0 : 1);
        if (!corner) continue;
        corner->pixel += error;
        const ResidualParts p = residual_parts(f.problem, off, estimate(f));
        least = std::min(least, (p.cameras + p.body) * std::pow(visible / (0.01 * 0.2), 2));
      }
  // Squares of two normal numbers about that mean pass the limit of one false alarm in 100,000 four times in five.
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const double limit = -2 * std::log(1e-5);
  int seen = 0;
  constexpr int draws = 200000;
  for (int i = 0; i < draws; ++i) {
    const double x = normal(random) + std::sqrt(least), y = normal(random);
    seen += x * x + y * y > limit ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(seen) / draws, 0.8, 0.01);
}

TEST(SmallestVisible, IsUnknownWhereABodyCouldTakeUpEverything) {
  const Session session = measured(0.2);
  const Fit f = fit(session);
  ProblemObservation one = f.problem.observations[3];
  one.sightings.resize(1);
  EXPECT_FALSE(smallest_visible(f.problem, one, estimate(f), 0.2).has_value());
}

}  // namespace
}  // namespace handsight
