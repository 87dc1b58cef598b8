// SPDX-License-Identifier: Apache-2.0
#include "estimation/online/online.h"

#include <gtest/gtest.h>

#include "estimation/fit/fit.h"
#include "estimation/start/start.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

SimulatedSession sagging(const Session& like, std::uint64_t seed, int observations, double sag = 0) {
  SimulationOptions options;
  options.seed = seed;
  options.observations = observations;
  if (sag > 0) options.effects = {{"joint_elasticity", 1, {sag}}, {"joint_elasticity", 2, {sag}}};
  return simulate_session(like, options);
}

struct Outcome {
  std::vector<OnlineStep> steps;
  Session kept;  // the session with the online decisions
};

Outcome calibrate(const Session& session, OnlineOptions options = {}) {
  Outcome r{{}, session};
  OnlineCalibration online(session, std::move(options));
  for (std::size_t k = 0; k < session.observations.size(); ++k) {
    r.steps.push_back(online.add(session.observations[k], nullptr));
    r.kept.observations[k].decision = r.steps.back().accepted ? Decision::accepted : Decision::rejected;
  }
  return r;
}

/// The largest difference of the batch and the online answer in units of sigma.
double difference_in_sigma(const Outcome& r, const Fit& batch) {
  const OnlineStep& last = r.steps.back();
  const Vector6 difference = small_motion_between(batch.tcp_from_body, last.tcp_from_body);
  return (difference.array() / batch.covariance.diagonal().array().sqrt()).abs().maxCoeff();
}

TEST(Online, EqualsTheBatchFitOfWhatItKept) {
  for (const double sag : {0.0, 3e-4})
    for (const bool estimate_mount : {false, true}) {
      SimulatedSession s = sagging(fixture::stand_session(), 21, 300, sag);
      s.session.mount.estimate = estimate_mount;
      if (estimate_mount) {  // a guess that is 2 cm and 2 degrees off
        Vector6 off;
        off << 0.01, -0.015, 0.01, 0.02, -0.02, 0.02;
        s.session.mount.mount_from_sensor = s.mount_from_sensor * small_motion<double>(off);
      }
      const Outcome r = calibrate(s.session);
      EXPECT_EQ(r.steps.back().kept, 300u);
      // Online counts all pixels alike, and so does a batch fit that is not asked for its last digits: what sags is
      // else weighed as a robot that errs.
      const Fit batch =
          fit(r.kept, {.sides = choose_sides({s.markers_in_tcp[0], s.markers_in_tcp[1], s.markers_in_tcp[2]}),
                       .smallest_step = 1e-11});
      EXPECT_LT(difference_in_sigma(r, batch), 1e-3) << sag << estimate_mount;
    }
}

TEST(Online, AnUnknownMountIsFoundOnTheWay) {
  SimulatedSession s = sagging(fixture::stand_session(), 22, 60);
  s.session.mount.estimate = true;
  s.session.mount.known = false;
  s.session.mount.mount_from_sensor = Rigid{};
  const Outcome r = calibrate(s.session);
  EXPECT_LT(difference_in_sigma(r, fit(r.kept)), 1e-3);
}

TEST(Online, MarkersSeenLaterJoin) {
  SimulatedSession s = sagging(fixture::stand_session(6), 23, 80);
  for (std::size_t k = 0; k < s.session.observations.size(); ++k) {
    auto& sightings = s.session.observations[k].sightings;
    const std::size_t gone = k < 10 ? 3 : (k % 6);
    if (k < 10) {
      sightings.resize(gone);
    } else {
      sightings.erase(sightings.begin() + static_cast<std::ptrdiff_t>(gone));
    }
  }
  const Outcome r = calibrate(s.session);
  EXPECT_EQ(r.steps.back().kept, 80u);
  const Fit batch =
      fit(r.kept, {.sides = choose_sides({s.markers_in_tcp[0], s.markers_in_tcp[1], s.markers_in_tcp[2]})});
  EXPECT_LT(difference_in_sigma(r, batch), 1e-3);
}

TEST(Online, TwoDegreesCountAsNew) {
  SimulatedSession s = sagging(fixture::stand_session(), 24, 5);
  s.session.observations[3].position = s.session.observations[2].position;
  s.session.observations[3].position[4] += 0.02;
  const Outcome r = calibrate(s.session);
  EXPECT_FALSE(r.steps[3].accepted);
  EXPECT_EQ(r.steps[3].reason, "joints moved 1.1 deg since observation 2; 2 deg count as new");
  EXPECT_TRUE(r.steps[4].accepted);
}

TEST(Online, AWrongLabelIsRejectedWithTheMarkerThatIsWrong) {
  SimulatedSession s = sagging(fixture::stand_session(4), 25, 30);
  seen_by(s.session.observations[20].sightings[2], 0)->pixel.x() += 30;
  const Outcome r = calibrate(s.session);
  EXPECT_FALSE(r.steps[20].accepted);
  EXPECT_NE(r.steps[20].reason.find("marker"), std::string::npos) << r.steps[20].reason;
  EXPECT_EQ(r.steps.back().kept, 29u);
}

TEST(Online, NothingBeforeTheFirstLabel) {
  SimulatedSession s = sagging(fixture::stand_session(), 26, 4);
  s.session.observations[0].sightings.clear();
  s.session.observations[1].sightings.resize(2);
  const Outcome r = calibrate(s.session);
  EXPECT_EQ(r.steps[0].reason, "no observation before it is labelled; label one first");
  EXPECT_EQ(r.steps[1].reason, "the first observation needs 3 labelled markers seen as points, and has 2");
  EXPECT_TRUE(r.steps[2].accepted);
  EXPECT_TRUE(r.steps[2].has_estimate);
}

TEST(Online, FirstObservationHasNoDeviation) {
  const SimulatedSession s = sagging(fixture::stand_session(), 27, 2);
  const Outcome r = calibrate(s.session);
  ASSERT_TRUE(r.steps[0].tcp_from_tcp_est);  // thesis: a unit matrix
  EXPECT_LT(small_motion_between(Rigid{}, *r.steps[0].tcp_from_tcp_est).norm(), 1e-6);
  EXPECT_GT(small_motion_between(Rigid{}, *r.steps[1].tcp_from_tcp_est).norm(), 1e-6);
}

TEST(Online, TrackerSessionsToo) {
  const SimulatedSession s = sagging(fixture::tracker_session(), 28, 50);
  const Outcome r = calibrate(s.session);
  EXPECT_EQ(r.steps.back().kept, 50u);
  EXPECT_LT(difference_in_sigma(r, fit(r.kept)), 1e-3);
}

}  // namespace
}  // namespace handsight
