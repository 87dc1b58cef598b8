// SPDX-License-Identifier: Apache-2.0
// Fits with one camera, with three, with five.
#include "fixtures/rigs.h"

#include <gtest/gtest.h>

#include "chain/body_frame.h"
#include "effects/own_effect.h"
#include "estimation/report/export.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/prediction.h"
#include "estimation/report/session_check.h"
#include "session/calibration_xml.h"

namespace handsight {
namespace {

SimulatedSession seen_by(int cameras, std::uint64_t seed, const std::vector<EffectTerm>& effects = {},
                         int observations = 60) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = seed;
  o.effects = effects;
  return simulate_session(fixture::rig_session(cameras), o);
}

Rigid true_body(const SimulatedSession& s, const BodySides& sides) {
  return body_frame(sides, s.markers_in_tcp).tcp_from_body;
}

/// Squares of the error in units of its covariance: 6 on average.
double error_of_body(const SimulatedSession& s, const Fit& f) {
  const Vector6 xi = small_motion_between(true_body(s, f.sides), f.tcp_from_body);
  return xi.dot(f.covariance.ldlt().solve(xi));
}

std::vector<EffectTerm> list_terms(const Session& session, const std::vector<std::string>& values) {
  std::vector<EffectTerm> terms;
  const Chain chain = make_chain(session);
  for (const std::string& text : values) add_effect_value(text, session.robot, terms, list_own_effects(session, chain));
  return terms;
}

TEST(Rigs, TheBodyIsWhereItIs) {
  for (const int cameras : {1, 2, 3, 5}) {
    double squares = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const SimulatedSession s = seen_by(cameras, seed);
      const Fit f = fit(s.session);
      EXPECT_TRUE(f.converged());
      EXPECT_EQ(f.covariance_kind, CovarianceKind::noise);
      EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows)) << cameras;
      squares += error_of_body(s, f);
    }
    EXPECT_LT(squares, 24 + 4.5 * std::sqrt(48.0)) << cameras << " cameras";  // chi-squared of 24
  }
}

TEST(Rigs, AMountOfWhichOnlyAGuessIsKnownIsFound) {
  for (const int cameras : {1, 3}) {
    SimulatedSession s = seen_by(cameras, 3);
    const Rigid truth = s.session.mount.mount_from_sensor;
    s.session.mount.estimate = true;
    s.session.mount.mount_from_sensor =
        truth * small_motion<double>((Vector6() << 0.1, -0.05, 0.1, 0.2, -0.15, 0.2).finished());
    const Fit f = fit(s.session);
    EXPECT_TRUE(f.converged()) << cameras;
    EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows)) << cameras;
    EXPECT_LT(small_motion_between(truth, estimate(f).mount_from_sensor).norm(), 0.02) << cameras;
  }
}

TEST(Rigs, AMountOfWhichNothingIsKnownIsFoundByOneCameraToo) {
  for (const int cameras : {1, 3})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SimulatedSession s = seen_by(cameras, seed);
      const Rigid truth = s.session.mount.mount_from_sensor;
      s.session.mount.estimate = true;
      s.session.mount.known = false;
      s.session.mount.mount_from_sensor = Rigid{};
      const Fit f = fit(s.session);
      EXPECT_TRUE(f.converged()) << cameras;
      EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows)) << cameras << " seed " << seed;
      EXPECT_LT(small_motion_between(truth, estimate(f).mount_from_sensor).norm(), 0.02) << cameras;
    }
}

TEST(Rigs, EffectsOfEachCameraAreRecovered) {
  const std::vector<std::pair<int, std::string>> hidden = {{1, "camera_intrinsics:cam_0.fx=3"},
                                                           {1, "lens_distortion:cam_0.k1=0.02"},
                                                           {3, "rig:cam_1.ry=2e-3"},
                                                           {3, "rig:cam_2.x=1e-3"},
                                                           {3, "camera_intrinsics:cam_2.cy=3"},
                                                           {3, "lens_distortion:cam_1.p1=1e-3"},
                                                           {5, "camera_intrinsics:cam_3.fy=-2.5"},
                                                           {5, "rig:cam_4.rz=1e-3"},
                                                           {2, "camera_intrinsics:cam_1_fx=3"}};
  for (const auto& [cameras, text] : hidden) {
    const std::vector<EffectTerm> truth = list_terms(fixture::rig_session(cameras), {text});
    const SimulatedSession s = seen_by(cameras, 5, truth);
    EffectTerm free = list_terms(s.session, {text}).front();
    std::fill(free.values.begin(), free.values.end(), 0.0);
    const Fit f = fit(s.session, {.estimated = {free}});
    EXPECT_EQ(f.covariance_kind, CovarianceKind::noise) << text << " leaves more than the noise";
    for (std::size_t p = 0; p < free.values.size(); ++p)
      EXPECT_LT(std::abs(f.effects[0].term.values[p] - truth[0].values[p]), 4.5 * f.effects[0].sigmas[p]) << text;
  }
}

TEST(Rigs, AnExportedCalibrationIsReadBackWithTheEffectsOfItsCameras) {
  const std::vector<EffectTerm> truth = list_terms(
      fixture::rig_session(3), {"rig:cam_2.x=1e-3", "camera_intrinsics:cam_0.fx=2", "joint_offset:a2.offset=1e-3"});
  const SimulatedSession s = seen_by(3, 6, truth);
  std::vector<EffectTerm> free =
      list_terms(s.session, {"rig:cam_2.x=0", "camera_intrinsics:cam_0.fx=0", "joint_offset:a2.offset=0"});
  const FitOptions options{.estimated = free};
  const Fit f = fit(s.session, options);
  const PredictionModel here = prediction_model(f);
  const Calibration written = parse_calibration(
      calibration_text(make_calibration(s.session, f, report(s.session, f, options), options, "test")),
      "calibration.xml");
  const PredictionModel there = prediction_model(written, s.session.robot);
  ASSERT_EQ(here.effects.size(), there.effects.size());
  for (std::size_t t = 0; t < here.effects.size(); ++t) {
    const auto twin = std::find_if(there.effects.begin(), there.effects.end(),
                                   [&](const EffectTerm& e) { return e.id == here.effects[t].id; });
    ASSERT_NE(twin, there.effects.end());
    EXPECT_EQ(twin->values, here.effects[t].values);
  }
}

TEST(Rigs, ACheckNamesTheCameras) {
  const auto said = [](int cameras) { return check_session(seen_by(cameras, 1, {}, 12).session).contents.at(1); };
  EXPECT_NE(said(1).find("One camera (cam_0)"), std::string::npos) << said(1);
  EXPECT_NE(said(3).find("Three cameras (cam_0, cam_1 and cam_2)"), std::string::npos) << said(3);
}

TEST(Rigs, TheCameraObjectiveNeedsTwoThatSee) {
  const SimulatedSession s = seen_by(1, 1, {}, 20);
  try {
    fit(s.session, {.objective = Objective::camera});
    FAIL() << "one camera has no points";
  } catch (const InputError& error) {
    EXPECT_GT(std::string(error.what()).size(), 20u);
  }
  EXPECT_NO_THROW(fit(seen_by(3, 1, {}, 20).session, {.objective = Objective::camera}));
}

TEST(Rigs, AKnownShapeMakesOneCameraSurer) {
  double free = 0, known = 0, squares = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SimulatedSession s = seen_by(1, seed, {}, 30);
    free += fit(s.session).covariance.topLeftCorner<3, 3>().trace();
    s.session.shape = KnownShape{s.markers_in_tcp, 1e-6};
    const Fit f = fit(s.session);
    EXPECT_TRUE(f.converged());
    EXPECT_EQ(f.unknowns, 6) << "a body that is held has six";
    EXPECT_NEAR(*f.chi2_per_dof, 1, 4.5 * std::sqrt(2.0 / f.rows));
    known += f.covariance.topLeftCorner<3, 3>().trace();
    squares += error_of_body(s, f);
  }
  EXPECT_LT(known, free);
  EXPECT_LT(squares, 24 + 4.5 * std::sqrt(48.0));
}

}  // namespace
}  // namespace handsight
