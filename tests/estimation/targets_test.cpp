// SPDX-License-Identifier: Apache-2.0
// Sessions whose targets name their own points: known shapes in fits, starts without a guess, online without labels.
#include "fixtures/targets.h"

#include <gtest/gtest.h>

#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "estimation/fit/fit.h"
#include "estimation/online/online.h"
#include "estimation/problem/target_pose.h"
#include "estimation/report/export.h"
#include "estimation/report/fit_report.h"
#include "estimation/start/target_symmetry.h"
#include "session/calibration_xml.h"

namespace handsight {
namespace {

using fixture::target_session;
using fixture::with_unknown_mount;

SimulatedSession simulated_board(const Session& like, std::uint64_t seed, const std::vector<EffectTerm>& effects = {},
                                 int observations = 30) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  o.effects = effects;
  return simulate_session(like, o);
}

double error_of_board(const SimulatedSession& s, const Fit& f) {
  const Vector6 xi = small_motion_between(fixture::true_target_body(s, f.sides), f.tcp_from_body);
  return xi.dot(f.covariance.ldlt().solve(xi));
}

TEST(TargetPose, IsFoundInOneImageWithoutAGuess) {
  const SimulatedSession s = simulated_board(target_session(), 3, {}, 20);
  int found = 0;
  for (std::size_t k = 0; k < 20; ++k) {
    const Observation& o = s.session.observations[k];
    const auto pose = target_pose(&*s.session.rig, o.sightings, s.session.shape->markers);
    ASSERT_TRUE(pose);
    if (pose->lead < 2) continue;  // the image does not tell which of two
    ++found;
    for (std::size_t m = 0; m < s.markers_in_tcp.size(); ++m) {
      const Vector3 truth = inverse(s.root_from_sensor[k]) * (s.root_from_tcp[k] * s.markers[k][m]);
      EXPECT_LT((pose->pose.sensor_from_body * s.session.shape->markers[m] - truth).norm(), 0.02 * truth.z());
    }
  }
  EXPECT_GE(found, 15);
}

TEST(TargetPose, NeedsFourPointsThatAreNotOnALine) {
  const SimulatedSession s = simulated_board(target_session(), 3, {}, 1);
  std::vector<Sighting> few(s.session.observations[0].sightings.begin(),
                            s.session.observations[0].sightings.begin() + 3);
  EXPECT_FALSE(target_pose(&*s.session.rig, few, s.session.shape->markers));
  std::vector<Sighting> row;
  for (const Sighting& p : s.session.observations[0].sightings)
    if (p.marker < 6) row.push_back(p);
  EXPECT_FALSE(target_pose(&*s.session.rig, row, s.session.shape->markers)) << "the points of a row";
}

TEST(Targets, TheBodyIsWhereItIsAndAsSureAsIsSaid) {
  for (const Target& target : {fixture::charuco(), fixture::aprilgrid(), fixture::tags()})
    for (const bool mount_is_known : {true, false}) {
      double squares = 0;
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SimulatedSession s = simulated_board(target_session(target), seed);
        if (!mount_is_known) s.session = with_unknown_mount(s.session);
        const Fit f = fit(s.session);
        EXPECT_TRUE(f.converged());
        EXPECT_EQ(f.covariance_kind, CovarianceKind::noise);
        EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows)) << display_name(target.kind);
        squares += error_of_board(s, f);
      }
      EXPECT_LT(squares, 18 + 4.5 * std::sqrt(36.0)) << display_name(target.kind) << mount_is_known;
    }
}

TEST(Targets, ABoardThatIsHeldHasSixUnknowns) {
  const SimulatedSession s = simulated_board(target_session(), 4);
  EXPECT_EQ(fit(s.session).unknowns, 6);
  SimulatedSession free = s;
  free.session.shape->sigma.reset();
  EXPECT_EQ(fit(free.session).unknowns, 3 * 24);
  SimulatedSession tags = simulated_board(target_session(fixture::tags()), 4);
  EXPECT_EQ(fit(tags.session).unknowns, 3 * 6) << "each tag is a body of its own";
}

TEST(Targets, APrintThatIsOnlyAboutRightIsAllowedFor) {
  Target target = fixture::charuco();
  target.sigma = 2e-4;
  double squares = 0, held_chi2 = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SimulatedSession s = simulated_board(target_session(target), seed);
    const Fit f = fit(s.session);
    EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows));
    squares += error_of_board(s, f);
    s.session.shape->sigma = 0;
    held_chi2 += *fit(s.session).chi2_per_dof / 3;
  }
  EXPECT_LT(squares, 18 + 4.5 * std::sqrt(36.0));
  EXPECT_GT(held_chi2, 1.1) << "taken at its word the print would not fit";
}

TEST(Targets, OnTheTableWithTheCameraOnTheHand) {
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SimulatedSession s = simulated_board(fixture::eye_in_hand_session(), seed);
    s.session = with_unknown_mount(s.session);
    const Fit f = fit(s.session);
    EXPECT_TRUE(f.converged());
    squares += error_of_board(s, f);
  }
  EXPECT_LT(squares, 18 + 4.5 * std::sqrt(36.0));
}

TEST(Targets, OneCameraSaysErrorsInMetresToo) {
  const SimulatedSession s = simulated_board(target_session(), 7);
  const Fit f = fit(s.session);
  const FitReport reported = report(s.session, f);
  ASSERT_TRUE(reported.fitted.rms_m);
  EXPECT_GT(*reported.fitted.rms_m, 1e-5);
  EXPECT_LT(*reported.fitted.rms_m, 1e-2) << "a board of 17 cm at a metre: 0.2 px of 140 px are its depth's error";
}

TEST(Targets, PartsOfABoardAreEnough) {
  SimulationOptions o;
  o.observations = 30;
  o.seed = 8;
  o.unseen = 0.6;
  SimulatedSession s = simulate_session(target_session(), o);
  for (Observation& one : s.session.observations)  // a corner that no image ever shows
    std::erase_if(one.sightings, [](const Sighting& p) { return p.marker == 0; });
  const Fit f = fit(s.session);
  EXPECT_LT(error_of_board(s, f), 6 + 4.5 * std::sqrt(12.0));
  for (const Message& note : f.notes) EXPECT_EQ(note.find("seen in no used"), std::string::npos) << note;
}

TEST(Targets, AMissingSpringIsNamed) {
  const SimulatedSession s = simulated_board(target_session(), 5, {{"joint_elasticity", 2, {1.5e-4}}}, 50);
  const Diagnosis d = diagnose(s.session, {.with_held_out = false});
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity") << d.reason;
  for (const auto& candidate : d.candidates) EXPECT_NE(candidate.id, "marker_slip") << "a board's points stay together";
  EXPECT_EQ(diagnose(simulated_board(target_session(), 6, {}, 50).session, {.with_held_out = false}).verdict,
            Verdict::adequate);
}

TEST(Targets, OnlineNeedsNoLabelAndEndsWhereTheFitDoes) {
  for (const bool mount_is_known : {true, false})
    for (const Target& target : {fixture::charuco(), fixture::tags()}) {
      SimulatedSession s = simulated_board(target_session(target), 9);
      if (!mount_is_known) s.session = with_unknown_mount(s.session);
      OnlineCalibration online(s.session);
      OnlineStep last;
      int accepted = 0;
      for (const Observation& o : s.session.observations) {
        const OnlineStep step = online.add(o, nullptr);
        accepted += step.accepted;
        if (step.has_estimate) last = step;
      }
      EXPECT_EQ(accepted, 30);
      ASSERT_TRUE(last.has_estimate);
      FitOptions options;
      const Fit f = fit(s.session, options);
      // The fit knows the tags' corners to 1 um, online holds them.
      EXPECT_LT(small_motion_between(f.tcp_from_body, last.tcp_from_body).norm(), 1e-6);
      for (int i = 0; i < 6; ++i)
        EXPECT_NEAR(last.covariance(i, i), f.covariance(i, i), 0.05 * f.covariance(i, i)) << i;
      ASSERT_TRUE(last.tcp_from_tcp_est);
      EXPECT_LT(last.tcp_from_tcp_est->translation.norm(), 0.02);
    }
}

TEST(Targets, OnlineRejectsPointsThatDoNotLieAsOnTheTarget) {
  SimulatedSession s = simulated_board(target_session(), 10, {}, 12);
  Observation& wrong = s.session.observations[6];
  std::swap(wrong.sightings[0].in_cameras, wrong.sightings[5].in_cameras);  // two numbers exchanged
  Observation& empty = s.session.observations[7];
  empty.sightings.clear();
  OnlineCalibration online(s.session);
  for (std::size_t k = 0; k < 12; ++k) {
    const OnlineStep step = online.add(s.session.observations[k], nullptr, k == 7 ? "none of its tags was found" : "");
    EXPECT_EQ(step.accepted, k != 6 && k != 7) << step.reason;
    if (k == 6) {
      EXPECT_NE(step.reason.find("do not lie to each other"), std::string::npos) << step.reason;
    }
    if (k == 7) {
      EXPECT_EQ(step.reason, "none of its tags was found");
    }
  }
}

TEST(Targets, ChessboardsThatLookTheSameTurnedAreToldByTheRobotsMotion) {
  Target chess;
  chess.kind = TargetKind::chessboard;
  chess.columns = 8;
  chess.rows = 6;
  chess.square = 0.025;
  for (const bool mount_is_known : {true, false}) {
    SimulatedSession s = simulated_board(target_session(chess), 12);
    if (!mount_is_known) s.session = with_unknown_mount(s.session);
    const Fit truth = fit(s.session);
    for (std::size_t k = 0; k < s.session.observations.size(); k += 3)
      turn_by_half(s.session.observations[k].sightings, s.session.marker_count);
    Session online_session = s.session;
    EXPECT_EQ(undo_target_symmetry(s.session), 10);
    const Fit f = fit(s.session);
    EXPECT_LT(small_motion_between(f.tcp_from_body, truth.tcp_from_body).norm(), 1e-9);
    OnlineCalibration online(online_session);
    OnlineStep last;
    for (const Observation& o : online_session.observations) {
      last = online.add(o, nullptr);
      EXPECT_TRUE(last.accepted);
    }
    const Rigid apart = inverse(truth.tcp_from_body) * last.tcp_from_body;
    EXPECT_LT(apart.translation.norm(), 1e-6) << "the middle is the same both ways round";
  }
}

TEST(Targets, AreExportedAndReadBack) {
  const SimulatedSession s = simulated_board(target_session(fixture::charuco(12, 9, 0.015)), 11, {}, 20);
  const Fit f = fit(s.session);
  const FitReport reported = report(s.session, f);
  const std::string text = calibration_text(make_calibration(s.session, f, reported, {}, "test"));
  const Calibration again = parse_calibration(text, "calibration.xml");
  EXPECT_EQ(again.markers.size(), 88u);
}

TEST(TargetFit, ABoardsOwnFrameIsToldBesideTheBodys) {
  for (const Session& like : {target_session(), fixture::eye_in_hand_session()}) {
    const SimulatedSession s = simulated_board(like, 12);
    const auto frame = tcp_from_target(s.session, fit(s.session));
    ASSERT_TRUE(frame);
    for (std::size_t m = 0; m < s.markers_in_tcp.size(); ++m)
      EXPECT_LT((*frame * s.session.shape->markers[m] - s.markers_in_tcp[m]).norm(), 5e-4);
  }
  const SimulatedSession tags = simulated_board(target_session(fixture::tags()), 12);
  EXPECT_FALSE(tcp_from_target(tags.session, fit(tags.session))) << "they have no frame together";
}

}  // namespace
}  // namespace handsight
