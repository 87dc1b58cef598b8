// SPDX-License-Identifier: Apache-2.0
// Every observation against the model: the three bad poses of hundred_poses, each with the right blame.
#include "diagnosis/attribution/inspection.h"

#include <gtest/gtest.h>

#include "diagnosis/ranking/outlier_rejection.h"
#include "diagnosis/simulated_stand.h"
#include "fixtures/arms.h"
#include "session/pose_points.h"
#include "session/session_xml.h"
#include "vision/corners/corner_detector.h"
#include "vision/image/image_file.h"
#include "vision/markers/first_observation.h"

namespace handsight {
namespace {

std::filesystem::path sample(const char* name) {
  return std::filesystem::path(HANDSIGHT_SOURCE_DIR) / "sample_sessions" / name;
}

ImagePair list_images(const Session& session, const Observation& o) {
  return {read_image(folder(session) / o.images[0]), read_image(folder(session) / o.images[1])};
}

/// Labelled by three clicks and taken in one by one.
Session played(const char* name, const std::vector<Vector2>& clicks) {
  Session s = read_session(sample(name));
  const ImagePair first = list_images(s, s.observations[0]);
  const FirstLabels labels =
      label_first(make_stereo(*s.rig), detect_corners(first.left), detect_corners(first.right), clicks);
  EXPECT_EQ(labels.refusal, "");
  for (std::size_t m = 0; m < labels.markers.size(); ++m) {
    Sighting& sighting =
        s.observations[0].sightings.emplace_back(Sighting{.marker = static_cast<int>(m), .by = MarkedBy::hand});
    see(sighting, 0, labels.markers[m].left, pixel_sigma(labels.markers[m].left_covariance));
    see(sighting, 1, labels.markers[m].right, pixel_sigma(labels.markers[m].right_covariance));
  }
  OnlineCalibration online(s);
  for (Observation& o : s.observations) {
    const bool has_images = !o.images[0].empty();
    const ImagePair images = has_images ? list_images(s, o) : ImagePair{};
    keep_step(online.add(o, has_images ? &images : nullptr), o);
  }
  return s;
}

/// A session with its model, without effects.
struct Fitted {
  Fit fit;
  FitReport report;
  Inspection all;
};

Fitted fitted(const Session& session, const SecondLooks& looks = {}) {
  CleanFit clean = fit_without_outliers(session, {});
  Fitted f{.fit = std::move(clean.fit), .report = {}, .all = {}};
  f.report = report(clean.session, f.fit, {});
  f.all = inspect(session, f.fit, f.report, looks);
  mark_left_out(clean.wrong, clean.lone, f.all);
  return f;
}

/// Where a sensor's sigmas are not given the fit finds their ratio; what is shown is measured by it, not by the usual
/// one.
TEST(InspectionTest, PosesAreShownAsTheyWereFitted) {
  Session like = fixture::tracker_session(3);
  like.pose_sensor = PoseSensor{2e-4, 2e-5};  // a lever of 10 m
  show_poses(like, pose_lever(*like.pose_sensor));
  SimulationOptions options;
  options.observations = 20;
  Session s = simulate_session(like, options).session;
  s.pose_sensor = PoseSensor{};
  s.sigma_point.reset();
  show_poses(s, usual_lever);
  const Fitted model = fitted(s);
  EXPECT_GT((estimate(model.fit).markers_in_tcp[1] - estimate(model.fit).markers_in_tcp[0]).norm(), 4);
  for (const InspectionRow& row : model.all.rows) EXPECT_LT(row.rms_m, 2e-3) << row.id;
}

/// What is seen a stretch at a time is seen as it would be all at once: order, approach, sigmas.
TEST(InspectionTest, ALongSessionIsSeenAsAWhole) {
  Session session = simulated({{"backlash", 2, {1e-3}}}, 7, 4100);
  session.sigma_pixel.reset();
  for (Observation& o : session.observations) {
    o.velocity.resize(0);  // the approach follows from the pose before
    const double sigma = o.id < 4050 ? 0.2 : 0.6;
    for (Sighting& s : o.sightings)
      for (CameraPoint& p : s.in_cameras) p.sigma = PixelSigma{sigma, sigma, 0};
  }
  std::swap(session.observations[10], session.observations[4060]);
  FitOptions options;
  options.effects = {{"backlash", 2, {1e-3}}};
  session.observations[20].decision = Decision::excluded;
  const Fit f = fit(session, options);
  const Inspection all = inspect(session, f, report(session, f, options), {});
  session.observations[20].decision = Decision::none;
  const Problem whole = make_problem(session, make_chain(session), list_terms(f));
  ASSERT_EQ(whole.observations.size(), all.rows.size());
  for (const ProblemObservation& o : whole.observations) {
    const InspectionRow& row = all.rows[static_cast<std::size_t>(o.index)];
    InspectionRow alone;
    inspect_observation(whole, o, estimate(f), f.noise, f.problem.marker_is_seen, alone);
    ASSERT_EQ(row.id, session.observations[static_cast<std::size_t>(o.index)].id);
    ASSERT_EQ(row.rms, alone.rms) << row.id;
    ASSERT_EQ(row.rms_m, alone.rms_m) << row.id;
    ASSERT_EQ(row.smallest_visible, alone.smallest_visible) << row.id;
    ASSERT_EQ(row.root_from_tcp.translation, alone.root_from_tcp.translation) << row.id;
  }
  EXPECT_FALSE(all.rows[20].is_used);
  EXPECT_TRUE(all.rows[20].rms);
}

TEST(InspectionTest, TheThreeBadPosesHaveTheRightBlame) {
  const Session s = played("hundred_poses", {{519, 98}, {515, 132}, {576, 113}});
  Fitted model = fitted(s);
  SecondLooks looks;
  std::vector<std::int64_t> rejected;
  for (const Observation& o : s.observations)
    if (o.decision == Decision::rejected) {
      EXPECT_TRUE(wants_second_look(s, o)) << o.id;
      rejected.push_back(o.id);
      if (const auto found = second_look(s, model.fit, o, list_images(s, o))) looks[o.id] = *found;
    }
  EXPECT_EQ(rejected, (std::vector<std::int64_t>{58, 75, 98}));
  model = fitted(s, looks);
  const auto row = [&](std::size_t id) { return model.all.rows[id]; };
  for (const std::size_t id : {58, 75, 98}) {
    EXPECT_TRUE(row(id).at_second_look) << id;
    EXPECT_FALSE(row(id).what_would_mend.empty()) << id;
  }
  EXPECT_EQ(row(58).attribution.cause, ErrorCause::robot) << "a joint reading that is off: " << row(58).what_would_mend;
  EXPECT_EQ(row(75).attribution.cause, ErrorCause::body) << "a marker that moved: " << row(75).what_would_mend;
  EXPECT_EQ(row(98).attribution.cause, ErrorCause::cameras) << "images of two moments: " << row(98).what_would_mend;
  // The arm sags: the others miss too, and that is the robot's fault.
  EXPECT_EQ(row(10).attribution.cause, ErrorCause::robot);
}

TEST(InspectionTest, NothingStandsOutWhereNothingIsHidden) {
  const Session s = played("first_steps", {{421, 338}, {408, 411}, {473, 378}});
  const Fitted model = fitted(s);
  for (const InspectionRow& row : model.all.rows) {
    ASSERT_TRUE(row.ratio.has_value());
    EXPECT_LT(*row.ratio, 2);
    EXPECT_EQ(row.attribution.cause, ErrorCause::none) << row.id;
    EXPECT_TRUE(row.what_would_mend.empty());
  }
}

TEST(InspectionTest, AWrongCornerIsNamedWithWhereItShouldBe) {
  Session s = played("first_steps", {{421, 338}, {408, 411}, {473, 378}});
  Observation& o = s.observations[4];
  const int marker = o.sightings[1].marker;
  seen_by(o.sightings[1], 1)->pixel += Vector2(0, 4);
  o.decision = Decision::excluded;  // so that it cannot bend the fit
  const Fitted model = fitted(s);
  const InspectionRow& row = model.all.rows[4];
  EXPECT_EQ(row.attribution.cause, ErrorCause::cameras);
  EXPECT_GT(row.attribution.cameras, 0.5);
  EXPECT_EQ(row.worst_marker, marker);
  EXPECT_EQ(row.worst_camera, 1);
  EXPECT_EQ(row.what_would_mend, "Marker " + std::to_string(marker) + ", right image, 4.0 px further up.");
}

/// A session with nothing to find but noise, fitted.
Fitted fitted_noise(const Session& like, double noise) {
  SimulationOptions options;
  options.observations = 200;
  options.noise = noise;
  return fitted(simulate_session(like, options).session);
}

TEST(InspectionTest, TheNoiseInMmIsWhatIsLeftInMmWhereOnlyNoiseIsLeft) {
  const Fitted model = fitted_noise(fixture::stand_session(), 0.3);
  const Inspection& all = model.all;
  ASSERT_TRUE(all.noise_m);
  double sum = 0, squares = 0, expected_variance = 0, coordinates = 0;
  for (const InspectionRow& row : all.rows) {
    ASSERT_TRUE(row.noise_m && row.rms_m);
    const double share = *row.rms_m * *row.rms_m / (*row.noise_m * *row.noise_m);
    sum += share;
    squares += share * share;
    expected_variance += 2 / row.noise_coordinates;
    coordinates += row.noise_coordinates;
    EXPECT_GE(row.noise_coordinates, 3) << "three markers: one coordinate each at least";
    EXPECT_LE(row.noise_coordinates, 9) << "and three at most";
  }
  const double n = static_cast<double>(all.rows.size());
  EXPECT_NEAR(*model.report.fitted.rms_m / *all.noise_m, 1, 3 / std::sqrt(2 * coordinates)) << "three sigma";
  EXPECT_NEAR(sum / n, 1, 3 * std::sqrt(expected_variance) / n) << "near and far observations alike";
  EXPECT_NEAR((squares / n - sum * sum / n / n) / (expected_variance / n), 1, 0.3)
      << "and it scatters as a histogram of it must show";
}

TEST(InspectionTest, ATrackersNoiseInMmIsThatOfAPosition) {
  const Fitted model = fitted_noise(fixture::tracker_session(), 2e-4);
  EXPECT_NEAR(*model.all.noise_m, std::sqrt(3.0) * *model.fit.noise, 1e-12);
  EXPECT_NEAR(model.all.rows[0].noise_coordinates, 9, 1e-9);
  EXPECT_NEAR(*model.report.held_out.rms_m / as_reported(*model.fit.noise, false), 1, 0.1)
      << "an error and a noise of the same kind";
}

}  // namespace
}  // namespace handsight
