// SPDX-License-Identifier: Apache-2.0
// A ball in a socket tells no length: the robot may not shrink to agree with it.
#include "estimation/problem/robot_scale.h"

#include <gtest/gtest.h>

#include <random>

#include "diagnosis/selection/improvement.h"
#include "effects/own_effect.h"
#include "estimation/report/fit_report.h"
#include "fixtures/arms.h"
#include "fixtures/drawn.h"

namespace handsight {
namespace {

const Vector3 ball(0.02, -0.01, 0.08);  // m, on the tool

Vector3 ball_at(const Chain& chain, const Eigen::VectorXd& pose, const std::vector<EffectTerm>& terms) {
  const ObservationState c = states_at(chain, pose);
  return observed_ends(c, moved_sites(c, terms)).ends.root_from_tcp * ball;
}

/// A posture near this one in which the ball sits in the socket; none where that is out of reach.
std::optional<Eigen::VectorXd> in_socket(const Chain& chain, Eigen::VectorXd pose, const Vector3& socket,
                                         const std::vector<EffectTerm>& terms) {
  for (int step = 0; step < 60; ++step) {
    const Vector3 off = socket - ball_at(chain, pose, terms);
    if (off.norm() < 1e-9) return pose;
    Eigen::Matrix3Xd by_joint(3, pose.size());
    for (Eigen::Index j = 0; j < pose.size(); ++j) {
      Eigen::VectorXd beside = pose;
      beside[j] += 1e-6;
      by_joint.col(j) = (ball_at(chain, beside, terms) - ball_at(chain, pose, terms)) / 1e-6;
    }
    const Vector3 by = (by_joint * by_joint.transpose()).ldlt().solve(off);
    pose += (by_joint.transpose() * by).cwiseMin(0.2).cwiseMax(-0.2);
  }
  return std::nullopt;
}

/// The seven-axis arm puts its ball into this many sockets, 15 times each; its joints err by 0.3 mrad.
Session socket_session(int sockets, const std::vector<EffectTerm>& terms) {
  Session s = fixture::seven_axis_session(1);
  for (Joint& joint : s.robot.joints) joint.stiffness = 0;
  s.rig.reset();
  s.sigma_point = 1e-4;
  s.tcp = "pedestal";  // the sockets are the markers, in the robot's frame; what is measured is the tool's ball
  s.mount.link = "tool";
  s.mount.mount_from_sensor = {Matrix3::Identity(), ball};
  s.mount.estimate = true;
  s.marker_count = sockets;
  s.observations.clear();
  Session arm = fixture::seven_axis_session(1);
  for (Joint& joint : arm.robot.joints) joint.stiffness = 0;
  const Chain chain = make_chain(arm);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int socket = 0; socket < sockets; ++socket) {
    const Vector3 at(0.35 + 0.05 * (socket % 3), -0.2 + 0.1 * socket, 0.3 + 0.08 * (socket % 2));
    for (int count = 0; count < 15;) {
      Eigen::VectorXd start(7);
      for (double& q : start) q = 1.5 * uniform(random);
      const auto pose = in_socket(chain, start, at, terms);
      if (!pose) continue;
      Observation o;
      o.id = static_cast<std::int64_t>(s.observations.size());
      o.time = 10.0 * static_cast<double>(s.observations.size());
      o.position = *pose;
      for (double& q : o.position) q += 3e-4 * normal(random);
      Sighting sighting;
      sighting.marker = socket;
      sighting.point = Vector3::Zero();
      o.sightings = {sighting};
      s.observations.push_back(o);
      ++count;
    }
  }
  return s;
}

std::vector<EffectTerm> geometry(const Session& session) {
  const Chain chain = make_chain(session);
  return effect_terms("link_geometry", chain, list_own_effects(session, chain));
}

std::vector<EffectTerm> elbow_off() {
  EffectTerm elbow = term_of(*find_effect("link_geometry"), 3);
  elbow.values = {0.004, 0, 0, 0};
  return {elbow};
}

TEST(RobotScale, IsToldByTheRobotWhereNothingElseTellsALength) {
  const Session s = socket_session(6, elbow_off());
  EXPECT_TRUE(measures_no_length(s, make_chain(s)));
  Session apart = s;
  for (std::size_t i = 0; i < 15; ++i) apart.observations[i].sightings[0].point = Vector3(0.2, 0, 0);
  EXPECT_TRUE(measures_no_length(apart, make_chain(apart))) << "another marker is another place";
  apart.observations[20].sightings[0].point = Vector3(0.2, 0, 0);
  EXPECT_FALSE(measures_no_length(apart, make_chain(apart)));
  EXPECT_FALSE(measures_no_length(fixture::stand_session(), make_chain(fixture::stand_session())));
}

TEST(RobotScale, GrowsByWhatItsLinksGrow) {
  const Session s = socket_session(2, {});
  Problem p = make_problem(s, make_chain(s), {}, geometry(s));
  ASSERT_TRUE(holds_robot_scale(p));
  EXPECT_NEAR(p.robot_scale->change, 0, 1e-12);
  const Eigen::VectorXd by_effect = p.robot_scale->by_effect;
  for (Eigen::Index i = 0; i < p.effect_count(); ++i) {
    constexpr double step = 1e-6;
    Problem there = p;
    set_effects(there, step * Eigen::VectorXd::Unit(p.effect_count(), i));
    EXPECT_NEAR(there.robot_scale->change / step, by_effect[i], 1e-4) << i;
  }
}

TEST(RobotScale, DoesNotCollapseAndTheLinkIsFound) {
  const Session s = socket_session(6, elbow_off());
  const Fit f = fit(s, {.estimated = geometry(s)});
  ASSERT_TRUE(f.converged());
  ASSERT_TRUE(holds_robot_scale(f.problem));
  EXPECT_LT(std::abs(f.problem.robot_scale->change), 5e-3) << "a robot of 1.2 m that is 6 mm smaller";
  for (const FittedEffect& e : f.effects)
    for (std::size_t p = 0; p < 2; ++p)
      EXPECT_LT(std::abs(e.term.values[p] - (e.term.place == 3 && p == 0 ? 0.004 : 0)), 2e-3)
          << e.term.place << ' ' << p << ": no link is off by more than chance makes of it";
  EXPECT_TRUE(std::any_of(f.notes.begin(), f.notes.end(),
                          [](const std::string& n) { return n.find("tells a length") != std::string::npos; }));
}

TEST(RobotScale, AnImprovementDoesNotShrinkTheRobot) {
  const Session s = socket_session(6, elbow_off());
  const Improvement m = improve(s, {});
  const Fit& f = m.last.model.fit;
  if (!holds_robot_scale(f.problem)) return;  // no number of the model moves a length
  for (const FittedEffect& e : f.effects)
    if (e.term.id == "link_geometry")
      for (std::size_t p = 0; p < 2; ++p) EXPECT_LT(std::abs(e.term.values[p]), 0.01) << e.term.place;
}

}  // namespace
}  // namespace handsight
