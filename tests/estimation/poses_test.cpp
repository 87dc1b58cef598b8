// SPDX-License-Identifier: Apache-2.0
// Poses in place of images: sensors that tell the whole pose, robots of which only the flange's pose is known.
#include <gtest/gtest.h>

#include <random>

#include "chain/body_frame.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "effects/own_effect.h"
#include "estimation/fit/fit.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/session_check.h"
#include "fixtures/arms.h"
#include "session/pose_points.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

Session pose_session(double sigma = 5e-4, double sigma_angle = 1e-3) {
  Session s = fixture::tracker_session(3);
  s.pose_sensor = PoseSensor{sigma, sigma_angle};
  show_poses(s, pose_lever(*s.pose_sensor));
  return s;
}

SimulatedSession simulated(std::uint64_t seed, const std::vector<EffectTerm>& effects = {}, int observations = 40,
                           const Session& like = pose_session()) {
  SimulationOptions o;
  o.seed = seed;
  o.observations = observations;
  o.effects = effects;
  return simulate_session(like, o);
}

Rigid true_target(const SimulatedSession& s) {
  return align_points(Eigen::Map<const Eigen::Matrix3Xd>(s.markers_in_tcp[0].data(), 3, pose_markers),
                      Eigen::Map<const Eigen::Matrix3Xd>(s.session.shape->markers[0].data(), 3, pose_markers),
                      Eigen::VectorXd::Ones(pose_markers));
}

TEST(PosePoints, SixResidualsAreThePose) {
  const double lever = 0.4;
  const std::vector<Vector3> shape = pose_shape(lever);
  Vector6 motion;
  motion << 1e-6, -2e-6, 3e-6, 4e-6, 5e-6, -6e-6;
  const Rigid moved = small_motion<double>(motion);
  Session s = pose_session(4e-4, 1e-3);
  s.observations[0].target_pose = moved;
  show_poses(s, lever);
  Vector6 residuals;
  for (int m = 0; m < 6; ++m) {
    const Sighting& seen = s.observations[0].sightings[static_cast<std::size_t>(m)];
    residuals[m] = seen.along->dot(*seen.point - shape[static_cast<std::size_t>(m)]);
  }
  const PoseError error = pose_error(residuals, lever);
  EXPECT_LT((error.place - motion.head<3>()).norm(), 1e-10);
  EXPECT_LT((error.turn - motion.tail<3>()).norm(), 1e-10);
  EXPECT_NEAR(residuals.squaredNorm(), motion.head<3>().squaredNorm() + lever * lever * motion.tail<3>().squaredNorm(),
              1e-15);
}

TEST(Poses, TheTargetIsWhereItIsAndAsSureAsIsSaid) {
  for (const bool mount_is_known : {true, false}) {
    double squares = 0, chi2 = 0;
    constexpr int seeds = 12;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      SimulatedSession s = simulated(seed);
      s.session.mount.estimate = !mount_is_known;
      s.session.mount.known = mount_is_known;
      const Fit f = fit(s.session);
      EXPECT_TRUE(f.converged());
      EXPECT_EQ(f.covariance_kind, CovarianceKind::noise);
      EXPECT_EQ(f.rows - f.unknowns, 6 * 40 - (mount_is_known ? 6 : 12));
      const Vector6 xi = small_motion_between(true_target(s), f.tcp_from_body);
      squares += xi.dot(f.covariance.ldlt().solve(xi));
      chi2 += *f.chi2_per_dof / seeds;
    }
    EXPECT_NEAR(squares / seeds, 6, 4.5 * std::sqrt(12.0 / seeds)) << mount_is_known;
    EXPECT_NEAR(chi2, 1, 4.5 * std::sqrt(2.0 / (seeds * 228))) << mount_is_known;
  }
}

TEST(Poses, SigmasThatAreNotToldAreFoundInWhatIsLeft) {
  SimulatedSession s = simulated(3, {}, 80, pose_session(2e-4, 4e-3));
  const Rigid truth = true_target(s);
  s.session.pose_sensor = PoseSensor{};
  show_poses(s.session, usual_lever);
  const Fit f = fit(s.session);
  EXPECT_NEAR(f.problem.shape->markers[1].x(), 0.05, 0.01) << "the lever is the ratio of the sigmas";
  const Vector6 xi = small_motion_between(truth, f.tcp_from_body);
  EXPECT_LT(xi.head<3>().norm(), 5 * 2e-4);
}

TEST(Poses, AMissingSpringIsNamed) {
  const Diagnosis d = diagnose(simulated(7, {{"joint_elasticity", 2, {1e-4}}}, 80).session, {.with_held_out = false});
  ASSERT_FALSE(d.candidates.empty());
  EXPECT_EQ(d.candidates.front().id, "joint_elasticity") << d.reason;
  EXPECT_EQ(std::count(d.candidates.front().where.begin(), d.candidates.front().where.end(), "a3"), 1);
  EXPECT_EQ(diagnose(simulated(8, {}, 80).session, {.with_held_out = false}).verdict, Verdict::adequate);
}

Session flange_session() {
  Session s = pose_session();
  s.robot = poses_robot();
  s.joints.clear();
  for (const Joint& joint : s.robot.joints) s.joints.push_back(joint.name);
  s.tcp = "flange";
  s.mount.link = "base";
  s.observations.clear();
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> place(-0.5, 0.5), turn(-1.2, 1.2);
  for (int i = 0; i < 6; ++i) {
    Observation o;
    o.id = i;
    o.position =
        (Vector6() << place(random), place(random), place(random), turn(random), turn(random), turn(random)).finished();
    s.observations.push_back(o);
  }
  return s;
}

TEST(Poses, ARobotOfFlangePosesNeedsNoUrdf) {
  SimulatedSession s = simulated(5, {}, 40, flange_session());
  s.session.mount.estimate = true;
  s.session.mount.known = false;
  const Fit f = fit(s.session);
  EXPECT_TRUE(f.converged());
  const Vector6 xi = small_motion_between(true_target(s), f.tcp_from_body);
  EXPECT_LT(xi.dot(f.covariance.ldlt().solve(xi)), 25);
  const Chain chain = make_chain(s.session);
  for (const Effect& e : catalogue())
    if (moves_one_joint(e)) {
      EXPECT_TRUE(effect_places(e, chain).empty()) << e.id;
    }
}

TEST(Poses, AreWrittenAndReadBack) {
  SimulatedSession s = simulated(6, {}, 5, flange_session());
  s.session.source.reset();
  const std::string text = session_text(s.session);
  EXPECT_NE(text.find("<robot kind=\"poses\""), std::string::npos) << text.substr(0, 500);
  EXPECT_NE(text.find("<target kind=\"pose\"/>"), std::string::npos);
  EXPECT_EQ(text.find("<marker "), std::string::npos);
  const Session again = parse_session(text, "session.xml");
  EXPECT_TRUE(again.notes.empty()) << again.notes.front();
  ASSERT_EQ(again.observations.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const Observation &a = s.session.observations[k], &b = again.observations[k];
    EXPECT_LT((a.position - b.position).norm(), 1e-12);
    EXPECT_LT(small_motion_between(*a.target_pose, *b.target_pose).norm(), 1e-14);
    ASSERT_EQ(b.sightings.size(), 6u);
    EXPECT_LT((*a.sightings[3].point - *b.sightings[3].point).norm(), 1e-12);
  }
  EXPECT_EQ(*again.pose_sensor->sigma, *s.session.pose_sensor->sigma);
}

TEST(Poses, WhatIsWrongIsRefused) {
  const std::string good = session_text(simulated(6, {}, 2, flange_session()).session);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    try {
      parse_session(text.replace(at, from.size(), to), "session.xml");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal("quaternion=\"", "quaternion=\"7 0 0 0\" was=\"").find("of length 1"), std::string::npos);
  EXPECT_NE(refusal("<target kind=\"pose\"/>", "").find("<target>"), std::string::npos);
  EXPECT_NE(refusal("<flange_pose", "<flange_place").find("<flange_pose>"), std::string::npos);
}

}  // namespace
}  // namespace handsight
