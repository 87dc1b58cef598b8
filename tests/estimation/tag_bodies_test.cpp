// SPDX-License-Identifier: Apache-2.0
// A rigid body of several tags at known places: one pose from what is seen of it, a body as sure as is said, and tags
// that are placed within sigmas.
#include <gtest/gtest.h>

#include <fstream>

#include "detection/target_finding.h"
#include "estimation/fit/fit.h"
#include "estimation/problem/target_pose.h"
#include "estimation/report/fit_report.h"
#include "fixtures/robot_texts.h"
#include "fixtures/targets.h"
#include "session/session_xml.h"
#include "simulation/simulated_files.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using fixture::tag_cube;
using fixture::target_session;
using fixture::with_unknown_mount;

SimulatedSession simulated_tags(const Session& like, std::uint64_t seed, int observations = 30) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  return simulate_session(like, o);
}

double error_of_tag_body(const SimulatedSession& s, const Fit& f) {
  const Vector6 xi = small_motion_between(fixture::true_target_body(s, f.sides), f.tcp_from_body);
  return xi.dot(f.covariance.ldlt().solve(xi));
}

Target loosely_placed(double sigma = 8e-4, double sigma_angle = 0.015) {
  Target cube = tag_cube();
  for (std::size_t k = 1; k < cube.places.size(); ++k)  // the first is the gauge
    cube.places[k].sigma = sigma, cube.places[k].sigma_angle = sigma_angle;
  return cube;
}

TEST(TagBody, ShowsOnlyTheFacesThatLookAtTheCamera) {
  const SimulatedSession s = simulated_tags(target_session(tag_cube()), 3, 20);
  std::set<std::size_t> counts;
  for (const Observation& o : s.session.observations) counts.insert(o.sightings.size());
  EXPECT_GE(*counts.begin(), 4u);
  EXPECT_LE(*counts.rbegin(), 12u) << "three faces of a cube at most";
  EXPECT_GT(*counts.rbegin(), 4u) << "two at once somewhere";
}

TEST(TagBody, HasOnePoseInOneImageWhateverFacesAreSeen) {
  const SimulatedSession s = simulated_tags(target_session(tag_cube()), 3, 40);
  int found = 0, of_faces = 0;
  for (std::size_t k = 0; k < s.session.observations.size(); ++k) {
    const Observation& o = s.session.observations[k];
    const auto pose = target_pose(&*s.session.rig, o.sightings, s.session.shape->markers);
    ASSERT_TRUE(pose) << k;
    const bool is_flat = o.sightings.size() == 4;
    of_faces += is_flat ? 0 : 1;
    if (pose->lead < 2) {
      EXPECT_TRUE(is_flat) << "two faces tell which of two it is";
      continue;
    }
    ++found;
    for (std::size_t m = 0; m < s.markers_in_tcp.size(); ++m) {
      const Vector3 truth = inverse(s.root_from_sensor[k]) * (s.root_from_tcp[k] * s.markers[k][m]);
      EXPECT_LT((pose->pose.sensor_from_body * s.session.shape->markers[m] - truth).norm(), 0.03 * truth.z()) << k;
    }
  }
  EXPECT_GE(of_faces, 10);
  EXPECT_GE(found, of_faces);
}

TEST(TagBody, IsWhereItIsAndAsSureAsIsSaid) {
  for (const Target& target : {tag_cube(), fixture::tag_grid()})
    for (const bool mount_is_known : {true, false}) {
      double squares = 0;
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SimulatedSession s = simulated_tags(target_session(target), seed);
        if (!mount_is_known) s.session = with_unknown_mount(s.session);
        const Fit f = fit(s.session);
        EXPECT_TRUE(f.converged());
        EXPECT_EQ(f.unknowns, mount_is_known ? 6 : 12) << "one body";
        EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows));
        squares += error_of_tag_body(s, f);
      }
      EXPECT_LT(squares, 18 + 4.5 * std::sqrt(36.0)) << is_tag_grid(target) << mount_is_known;
    }
}

TEST(TagBody, TagsThatArePlacedWithinSigmasAreAllowedFor) {
  double squares = 0, held_chi2 = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedSession s = simulated_tags(target_session(loosely_placed()), seed);
    const Fit f = fit(s.session);
    EXPECT_TRUE(f.converged());
    EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows));
    squares += error_of_tag_body(s, f);
    s.session.shape->parts.clear();
    held_chi2 += *fit(s.session).chi2_per_dof / 4;
  }
  EXPECT_LT(squares, 24 + 4.5 * std::sqrt(48.0));
  EXPECT_GT(held_chi2, 1.5) << "taken at its word the body would not fit";
}

TEST(TagBody, SigmasOfNothingAreAPlaceThatIsHeld) {
  SimulatedSession s = simulated_tags(target_session(tag_cube()), 5);
  const Fit held = fit(s.session);
  for (int k = 0; k < 5; ++k) s.session.shape->parts.push_back({4 * k, 4, 1e-9, 1e-9});
  const Fit nearly = fit(s.session);
  EXPECT_LT(small_motion_between(held.tcp_from_body, nearly.tcp_from_body).norm(), 1e-4);
  EXPECT_NEAR(held.residual_rms, nearly.residual_rms, 1e-3);
}

TEST(TagBody, PlacesThatAreFreeAreThoseOfSingleTags) {
  Target free = tag_cube();
  free.sigma.reset();
  Session with = target_session(free), without = target_session(fixture::tags({0, 1, 2, 3, 4}, 0.06));
  EXPECT_EQ(with.shape->piece_count(), 5);
  EXPECT_EQ(with.shape->markers, without.shape->markers);
  EXPECT_EQ(with.shape->sigma, without.shape->sigma);
}

TEST(TagBody, TheTargetsOwnFrameIsToldWhereItIs) {
  const SimulatedSession s = simulated_tags(target_session(tag_cube()), 6);
  const auto found = tcp_from_target(s.session, fit(s.session));
  ASSERT_TRUE(found);
  for (std::size_t m = 0; m < s.markers_in_tcp.size(); ++m)
    EXPECT_LT((*found * s.session.shape->markers[m] - s.markers_in_tcp[m]).norm(), 1e-3);
}

/// Rendered, written, read back, found in the images and fitted: the body is where it was simulated.
TEST(TagBody, IsFoundInTheImagesOfItsFaces) {
  for (const Target& target : {tag_cube(0.12, 0.09), fixture::tag_grid(3, 2, 0.06, 0.02)}) {
    const TemporaryFolder folder;
    Session like = target_session(target);
    std::ofstream(folder.path / "arm.urdf") << fixture::urdf_text(like.robot);
    SimulationOptions o;
    o.observations = 12;
    o.seed = 4;
    o.farthest = 1.1;
    const SimulatedSession truth = simulate_session(like, o);
    write_simulated(truth, o, folder.path / "arm.urdf", {.observations = 12}, folder.path / "session");
    Session s = read_session(folder.path / "session");
    EXPECT_EQ(s.shape->markers, like.shape->markers);
    const TargetSearch search = find_targets(s);
    EXPECT_EQ(search.found, 12) << testing::PrintToString(search.notes);
    std::size_t seen = 0, simulated_seen = 0;
    for (std::size_t k = 0; k < s.observations.size(); ++k) {
      seen += s.observations[k].sightings.size();
      simulated_seen += truth.session.observations[k].sightings.size();
      for (const Sighting& one : s.observations[k].sightings) {
        const Vector3 x = inverse(truth.root_from_sensor[k]) *
                          (truth.root_from_tcp[k] * truth.markers[k][static_cast<std::size_t>(one.marker)]);
        // The right corner of the right tag; how well it lies there is what the fit leaves.
        EXPECT_LT((one.in_cameras[0].pixel - project(s.rig->at(0).camera, x)).norm(), 2) << k << " " << one.marker;
      }
    }
    EXPECT_GE(seen, simulated_seen * 3 / 4) << "most of the tags that look at the camera";
    const Fit f = fit(s);
    EXPECT_LT(f.residual_rms, 0.3);
    EXPECT_LT(small_motion_between(fixture::true_target_body(truth, f.sides), f.tcp_from_body).head<3>().norm(), 1e-3);
  }
}

}  // namespace
}  // namespace handsight
