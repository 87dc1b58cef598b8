// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/planning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "diagnosis/planning/planning_sessions.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/fit_result.h"
#include "fixtures/hand_eye.h"
#include "fixtures/targets.h"

namespace handsight {
namespace {

using fixture::simulated;
using fixture::true_markers;
using testing::HasSubstr;

void expect_within_limits(const Session& session, const Plan& p) {
  const Chain chain = make_chain(session);
  for (const PlannedPose& pose : p.poses) {
    const Eigen::VectorXd values = joint_values(chain.robot, chain.joints, pose.position);
    for (std::size_t j = 0; j < chain.robot.joints.size(); ++j) {
      const Joint& joint = chain.robot.joints[j];
      if (!joint.moves()) continue;
      EXPECT_GE(values[static_cast<Eigen::Index>(j)], joint.lower - 1e-12) << joint.name;
      EXPECT_LE(values[static_cast<Eigen::Index>(j)], joint.upper + 1e-12) << joint.name;
    }
  }
}

void expect_apart(const Session& session, const Plan& p, double least) {
  for (std::size_t i = 0; i < p.poses.size(); ++i) {
    for (const Observation& o : session.observations) EXPECT_GE((p.poses[i].position - o.position).norm(), least);
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE((p.poses[i].position - p.poses[k].position).norm(), least);
  }
}

std::string refusal(const Session& session, const PlanOptions& options) {
  try {
    plan(session, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Planning, PosesAreWithinLimitsVisibleAndApart) {
  const SimulatedSession s = simulated(fixture::stand_session(), 20, 3);
  const Plan p = plan(s.session);
  ASSERT_EQ(p.poses.size(), 10u);
  expect_within_limits(s.session, p);
  expect_apart(s.session, p, 0.17);
  const Chain chain = make_chain(s.session);
  for (const PlannedPose& pose : p.poses) {
    const ObservationState c = states_at(chain, pose.position);
    const Rigid left_from_tcp = sensor_from_tcp(observed_ends(c, {}).ends, s.mount_from_sensor);
    for (const Vector3& x : true_markers(s, chain, pose.position)) {
      EXPECT_TRUE(is_visible(chain.rig->at(0).camera, x, 20));
      EXPECT_TRUE(is_visible(chain.rig->at(1).camera, chain.rig->at(1).camera_from_first * x, 20));
      EXPECT_LT(std::acos(-(left_from_tcp.rotation * s.normal_in_tcp).dot(x.normalized())), 1.3);
    }
  }
}

TEST(Planning, SigmaFallsWithEveryPoseAndGainsFall) {
  const SimulatedSession s = simulated(fixture::stand_session(), 12, 4);
  const Plan p = plan(s.session);
  Vector6 before = p.sigma_before;
  double gain = 1e300;
  for (const PlannedPose& pose : p.poses) {
    for (int i = 0; i < 6; ++i) EXPECT_LT(pose.sigma[i], before[i]);
    EXPECT_GT(pose.gain, 0);
    EXPECT_LE(pose.gain, gain * (1 + 1e-9));  // information gains are submodular
    before = pose.sigma;
    gain = pose.gain;
  }
  const Fit f = fit(s.session);
  EXPECT_LT((p.sigma_before - f.covariance.diagonal().cwiseSqrt()).norm(), 1e-3 * p.sigma_before.norm());
}

TEST(Planning, IsTheSameEveryTime) {
  const SimulatedSession s = simulated(fixture::stand_session(), 12, 5);
  PlanOptions o;
  o.count = 3;
  const Plan a = plan(s.session, o), b = plan(s.session, o);
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) EXPECT_EQ(a.poses[i].position, b.poses[i].position);
}

TEST(Planning, JointsThatFollowOthersKeepTheirLimits) {
  Session like = fixture::tracker_session();
  like.robot = fixture::coupled_torso();
  like.mount.link = "base";
  like.joints = {"t1", "t2", "arm_1", "arm_2"};
  like.observations[0].position = Eigen::VectorXd::Zero(4);
  like.robot.joints[2].lower = -0.4;
  like.robot.joints[2].upper = 0.3;
  const SimulatedSession s = simulated(like, 15, 6);
  const Plan p = plan(s.session);
  ASSERT_EQ(p.poses.size(), 10u);
  expect_within_limits(s.session, p);
}

TEST(Planning, BeforeATrackerWithOneMarkerAnyPoseServes) {
  const SimulatedSession s = simulated(fixture::tracker_session(1), 10, 7);
  const Plan p = plan(s.session);
  ASSERT_EQ(p.poses.size(), 10u);
  EXPECT_FALSE(p.rotation_is_observed);
  expect_within_limits(s.session, p);
  EXPECT_LT(p.poses.back().sigma.head<3>().norm(), 0.8 * p.sigma_before.head<3>().norm());
}

TEST(Planning, AJointThatHardlyMovesStaysAndIsNotToldApart) {
  Session like = fixture::stand_session();
  like.robot.joints[2].lower = 0.5;
  like.robot.joints[2].upper = 0.5 + 1e-6;
  const SimulatedSession s = simulated(like, 30, 8);
  const Chain chain = make_chain(s.session);
  PlanOptions o;
  o.count = 4;
  o.between = {"joint_scale:a3", "joint_offset:a3", effect_terms("joint_scale:a3", chain),
               effect_terms("joint_offset:a3", chain)};
  const Plan p = plan(s.session, o);
  ASSERT_EQ(p.poses.size(), 4u);
  expect_within_limits(s.session, p);
  EXPECT_FALSE(p.tells_apart);
  EXPECT_THAT(p.notes, testing::Contains(HasSubstr("cannot be told apart")));
}

TEST(Planning, RefusesWhatCannotBePlanned) {
  const SimulatedSession s = simulated(fixture::stand_session(), 8, 9);
  const Chain chain = make_chain(s.session);
  PlanOptions o;
  o.count = 0;
  EXPECT_THAT(refusal(s.session, o), HasSubstr("expected 1 to 100"));
  o.count = most_planned_poses + 1;
  EXPECT_THAT(refusal(s.session, o), HasSubstr("expected 1 to 100"));
  o.count = 2;
  o.between = {"joint_scale:a2", "joint_scale:a2", effect_terms("joint_scale:a2", chain),
               effect_terms("joint_scale:a2", chain)};
  EXPECT_THAT(refusal(s.session, o), HasSubstr("the same effect"));
  o.between->second = effect_terms("joint_offset:a2", chain);
  o.estimated = o.between->second;
  EXPECT_THAT(refusal(s.session, o), HasSubstr("in the model already"));
}

TEST(Planning, WorksFromASingleObservation) {
  const SimulatedSession s = simulated(fixture::stand_session(), 1, 10);
  PlanOptions o;
  o.count = 3;
  const Plan p = plan(s.session, o);
  EXPECT_EQ(p.poses.size(), 3u);
  expect_within_limits(s.session, p);
}

/// Every point of a board is seen by two numbers a camera: what a plan expects is what a fit finds once it is measured.
void expect_as_measured(const Session& session,
                        const std::function<Session(const std::vector<Observation>&)>& measure) {
  PlanOptions o;
  o.count = 6;
  const Plan p = plan(session, o);
  ASSERT_EQ(p.poses.size(), 6u);
  EXPECT_GT(p.poses.front().gain, 0.05);
  std::vector<Observation> all = session.observations;
  for (const PlannedPose& pose : p.poses) {
    Observation& one = all.emplace_back(all.back());
    ++one.id, one.time += 5;
    one.position = pose.position;
  }
  const Fit f = fit(measure(all));
  const Vector6 found = f.covariance.diagonal().cwiseSqrt();
  for (int i = 0; i < 6; ++i) {
    EXPECT_LT(found[i], 1.25 * p.poses.back().sigma[i]) << i;
    EXPECT_GT(found[i], 0.7 * p.poses.back().sigma[i]) << i;
  }
}

TEST(Planning, APoseOfABoardBringsWhatItsPointsDo) {
  const Session like = fixture::eye_in_hand_session();
  SimulationOptions truth;
  truth.observations = 8;
  const SimulatedSession s = simulate_session(like, truth);
  expect_as_measured(s.session,
                     [&](const std::vector<Observation>& all) { return simulate_at(like, truth, all).session; });
}

TEST(Planning, AFlangesNextPosesShowTheBoard) {
  fixture::HandEye h = fixture::hand_eye({.poses = 10, .place = 0, .turn = 0, .declare_noise = true});
  set_target(h.session, Target{.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.025});
  expect_as_measured(h.session, [&](const std::vector<Observation>& all) {
    Session like = h.session;
    like.mount.mount_from_sensor = h.flange_from_camera;
    SimulationOptions truth;
    truth.noise = 0.15;
    for (const Vector3& x : h.board) truth.markers_in_tcp.push_back(h.base_from_board * x);
    return simulate_at(like, truth, all).session;
  });
}

}  // namespace
}  // namespace handsight
