// SPDX-License-Identifier: Apache-2.0
#include "simulation/simulated_session.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fixtures/arms.h"
#include "fixtures/hand_eye.h"
#include "fixtures/targets.h"
#include "session/session_xml.h"
#include "simulation/random.h"

namespace handsight {
namespace {

double pixel_error(const SimulatedSession& s, std::size_t k, const Sighting& sighting) {
  const Vector3 x = inverse(s.root_from_sensor[k]) *
                    (s.root_from_tcp[k] * s.markers_in_tcp[static_cast<std::size_t>(sighting.marker)]);
  return std::max((seen_by(sighting, 0)->pixel - project(s.session.rig->at(0).camera, x)).norm(),
                  (seen_by(sighting, 1)->pixel -
                   project(s.session.rig->at(1).camera, Vector3(s.session.rig->at(1).camera_from_first * x)))
                      .norm());
}

TEST(Simulate, OneSeedOneSession) {
  SimulationOptions options;
  options.observations = 10;
  options.seed = 5;
  const std::string first = session_text(simulate_session(fixture::stand_session(), options).session);
  EXPECT_EQ(session_text(simulate_session(fixture::stand_session(), options).session), first);
  options.seed = 6;
  EXPECT_NE(session_text(simulate_session(fixture::stand_session(), options).session), first);
}

TEST(Simulate, OneMoreObservationChangesNothingBeforeIt) {
  SimulationOptions options;
  options.observations = 10;
  const SimulatedSession ten = simulate_session(fixture::stand_session(), options);
  options.observations = 11;
  const SimulatedSession eleven = simulate_session(fixture::stand_session(), options);
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_EQ(ten.session.observations[k].position, eleven.session.observations[k].position);
    EXPECT_EQ(seen_by(ten.session.observations[k].sightings[0], 0)->pixel,
              seen_by(eleven.session.observations[k].sightings[0], 0)->pixel);
  }
}

TEST(Simulate, EveryMarkerIsSeenByBothCamerasWithinTheNoise) {
  SimulationOptions options;
  options.observations = 60;
  options.noise = 0.3;
  const SimulatedSession s = simulate_session(fixture::stand_session(), options);
  double squares = 0;
  int count = 0;
  for (std::size_t k = 0; k < s.session.observations.size(); ++k) {
    const Observation& o = s.session.observations[k];
    ASSERT_EQ(o.sightings.size(), 3u);
    for (const Sighting& sighting : o.sightings) {
      ASSERT_TRUE(seen_by(sighting, 0) && seen_by(sighting, 1));
      const Vector3 x = inverse(s.root_from_sensor[k]) *
                        (s.root_from_tcp[k] * s.markers_in_tcp[static_cast<std::size_t>(sighting.marker)]);
      squares += (seen_by(sighting, 0)->pixel - project(s.session.rig->at(0).camera, x)).squaredNorm();
      count += 2;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.3, 0.04);  // 360 coordinates: 3.7 % each sigma
  for (std::size_t k = 1; k < s.session.observations.size(); ++k)
    EXPECT_GT(s.session.observations[k].time, s.session.observations[k - 1].time);
}

TEST(Simulate, AHiddenEffectMovesTheHandAndNotTheReadings) {
  SimulationOptions options;
  options.observations = 10;
  options.noise = 0;
  options.effects = {{"joint_elasticity", 1, {3e-4}}};
  const SimulatedSession s = simulate_session(fixture::stand_session(), options);
  const Chain chain = make_chain(s.session);
  double largest = 0;
  for (std::size_t k = 0; k < 10; ++k) {
    const Rigid nominal = chain_ends(chain, s.session.observations[k].position).root_from_tcp;
    largest = std::max(largest, (nominal.translation - s.root_from_tcp[k].translation).norm());
    EXPECT_LT(pixel_error(s, k, s.session.observations[k].sightings[0]), 1e-9);
  }
  EXPECT_GT(largest, 1e-3);
}

TEST(Simulate, DisturbancesTouchOnlyTheirObservation) {
  SimulationOptions options;
  options.observations = 8;
  options.noise = 0;
  const SimulatedSession clean = simulate_session(fixture::stand_session(), options);
  options.disturbances = {parse_disturbance("2:joint:a3=0.1", clean.session.robot),
                          parse_disturbance("4:marker:1=0.012", clean.session.robot),
                          parse_disturbance("6:right_image:a2=0.05", clean.session.robot)};
  const SimulatedSession s = simulate_session(fixture::stand_session(), options);
  for (std::size_t k = 0; k < 8; ++k) {
    const Observation &before = clean.session.observations[k], &after = s.session.observations[k];
    EXPECT_EQ(before.position != after.position, k == 2);
    EXPECT_EQ((seen_by(before.sightings[1], 0)->pixel - seen_by(after.sightings[1], 0)->pixel).norm() > 1, k == 4);
    EXPECT_EQ((seen_by(before.sightings[0], 1)->pixel - seen_by(after.sightings[0], 1)->pixel).norm() > 1, k == 6);
  }
  EXPECT_NEAR((s.markers[4][1] - s.markers_in_tcp[1]).norm(), 0.012, 1e-12);
}

TEST(Simulate, RefusesWhatCannotBe) {
  const Robot robot = fixture::six_axis_arm();
  for (const std::string text :
       {"x", "1:joint:a9=0.1", "1:wheel:a1=0.1", "1:joint:a1", "z:joint:a1=0.1", "1:marker:one=0.1"})
    EXPECT_THROW(parse_disturbance(text, robot), InputError) << text;
  SimulationOptions options;
  options.observations = 3;
  options.disturbances = {{5, Disturbance::Kind::joint, "a1", 0, 0.1}};
  EXPECT_THROW(simulate_session(fixture::stand_session(), options), InputError);
  Session away = fixture::stand_session();
  away.mount.mount_from_sensor = fixture::look_at({1.5, -0.5, 0.8}, {3, 0, 0.5});  // looks the other way
  options.disturbances.clear();
  EXPECT_THROW(simulate_session(away, options), InputError);
}

TEST(Random, StreamsAreIndependentAndRight) {
  Random random(7);
  double sum = 0, squares = 0, cross = 0;
  Random other = random.child(1);
  const int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double x = random.gaussian(), y = other.gaussian();
    sum += x;
    squares += x * x;
    cross += x * y;
  }
  EXPECT_NEAR(sum / count, 0, 4 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1, 4 * std::sqrt(2.0 / count));
  EXPECT_NEAR(cross / count, 0, 4 / std::sqrt(count));
}

TEST(Simulate, ACurveIsAddedToItsJointAndReadBack) {
  const Session like = fixture::stand_session();
  const Curve curve = parse_curve(" a3 : 0.0015 * sin(3q)", like.robot);
  EXPECT_EQ(curve.joint, find_joint(like.robot, "a3"));
  EXPECT_EQ(curve_formula(curve), "0.0015*sin(3q)");
  EXPECT_EQ(curve_formula(parse_curve("a3: -2e-3*cos(q)", like.robot)), "-0.002*cos(1q)");
  SimulationOptions options;
  options.observations = 8;
  options.noise = 0;
  options.curves = {curve};
  const SimulatedSession s = simulate_session(like, options);
  const Chain chain = make_chain(s.session);
  for (std::size_t k = 0; k < 8; ++k) {
    Eigen::VectorXd position = s.session.observations[k].position;
    position[2] += 0.0015 * std::sin(3 * position[2]);
    const Rigid bent = chain_ends(chain, position).root_from_tcp;
    EXPECT_LT((bent.translation - s.root_from_tcp[k].translation).norm(), 1e-12);
  }
}

TEST(Simulate, ACurveThatIsNotUnderstoodIsRefused) {
  const Robot robot = fixture::stand_session().robot;
  for (const char* text : {"a3", "a3: 0.001", "a3: x*sin(3q)", "a3: 0.001*tan(3q)", "a3: 0.001*sin(3q", "a3: *sin(q)",
                           "a3: 0.001*sin(3 4q)", "wrist: 0.001*sin(3q)"})
    EXPECT_THROW(parse_curve(text, robot), InputError) << text;
}

TEST(Simulate, WrongCornersAreThatShareAndOfThatSize) {
  SimulationOptions options;
  options.observations = 200;
  const SimulatedSession clean = simulate_session(fixture::stand_session(), options);
  options.wrong_corners = 0.1;
  const SimulatedSession s = simulate_session(fixture::stand_session(), options);
  double squares = 0;
  std::size_t changed = 0;
  for (std::size_t k = 0; k < 200; ++k)
    for (std::size_t m = 0; m < 3; ++m) {
      const Sighting &before = clean.session.observations[k].sightings[m],
                     &after = s.session.observations[k].sightings[m];
      changed += (seen_by(before, 0)->pixel != seen_by(after, 0)->pixel) +
                 (seen_by(before, 1)->pixel != seen_by(after, 1)->pixel);
      squares += (seen_by(before, 0)->pixel - seen_by(after, 0)->pixel).squaredNorm() +
                 (seen_by(before, 1)->pixel - seen_by(after, 1)->pixel).squaredNorm();
    }
  EXPECT_EQ(changed, s.wrong_corners.size());
  EXPECT_NEAR(static_cast<double>(changed), 120, 42);  // of 1200 points, 4 sigma
  EXPECT_NEAR(std::sqrt(squares / (2.0 * static_cast<double>(changed))), wrong_corner_size, 1.5);
}

TEST(Simulate, UnseenMarkersAreThatShareAndTheOthersStay) {
  SimulationOptions options;
  options.observations = 200;
  const SimulatedSession all = simulate_session(fixture::stand_session(), options);
  options.unseen = 0.2;
  const SimulatedSession s = simulate_session(fixture::stand_session(), options);
  std::size_t seen = 0;
  for (std::size_t k = 0; k < 200; ++k)
    for (const Sighting& sighting : s.session.observations[k].sightings) {
      ++seen;
      EXPECT_EQ(seen_by(sighting, 0)->pixel,
                seen_by(all.session.observations[k].sightings[static_cast<std::size_t>(sighting.marker)], 0)->pixel);
    }
  EXPECT_NEAR(static_cast<double>(seen), 480, 40);  // of 600 markers, 4 sigma
}

/// A flange's coordinates have no limits: its poses are drawn where the session's were.
TEST(Simulate, AFlangeStaysWhereItWas) {
  fixture::HandEye h = fixture::hand_eye({});
  h.session.mount.mount_from_sensor = h.flange_from_camera;
  SimulationOptions options;
  options.observations = 20;
  const auto expect_near = [&](const SimulatedSession& s) {
    for (int axis = 0; axis < 3; ++axis) {
      double lower = 1e300, upper = -1e300;
      for (const Observation& o : h.session.observations)
        lower = std::min(lower, o.position[axis]), upper = std::max(upper, o.position[axis]);
      for (const Observation& o : s.session.observations) {
        EXPECT_GT(o.position[axis], lower - 0.1) << axis;
        EXPECT_LT(o.position[axis], upper + 0.1) << axis;
      }
    }
  };
  expect_near(simulate_session(h.session, options));
  set_target(h.session, fixture::charuco());
  expect_near(simulate_session(h.session, options));
}

}  // namespace
}  // namespace handsight
