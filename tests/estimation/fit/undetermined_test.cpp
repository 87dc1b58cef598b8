// SPDX-License-Identifier: Apache-2.0
// What poses do not show is said in words, and no figure stands beside it.
#include "estimation/fit/undetermined.h"

#include <gmock/gmock.h>

#include "estimation/body_error.h"
#include "estimation/fit/fit.h"
#include "estimation/report/prediction.h"
#include "fixtures/arms.h"

namespace handsight {
namespace {

using testing::HasSubstr;

Joint sliding(const std::string& name, int parent, int child, const Vector3& xyz, const Vector3& axis) {
  Joint joint = fixture::make_joint(name, parent, child, xyz, {0, 0, 0}, axis, 0.25);
  joint.kind = JointKind::prismatic;
  return joint;
}

Session seen(Robot robot, Session s = fixture::stand_session(3)) {
  s.robot = std::move(robot);
  s.mount.link = s.robot.links.front().name;
  s.tcp = s.robot.links.back().name;
  s.mount.estimate = true;
  s.joints.clear();
  for (const Joint& joint : s.robot.joints) s.joints.push_back(joint.name);
  s.observations[0].position = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s.joints.size()));
  return s;
}

Robot scara() {
  Robot r;
  r.name = "scara";
  r.links = {fixture::make_link("base", 0, Vector3::Zero(), -1), fixture::make_link("l1", 4, {0.1, 0, 0}, 0),
             fixture::make_link("l2", 3, {0.1, 0, 0}, 1), fixture::make_link("quill", 1, {0, 0, 0.05}, 2),
             fixture::make_link("hand", 0.5, {0, 0, 0}, 3)};
  r.joints = {fixture::make_joint("s1", 0, 1, {0, 0, 0.5}, {0, 0, 0}, {0, 0, 1}, 2),
              fixture::make_joint("s2", 1, 2, {0.3, 0, 0}, {0, 0, 0}, {0, 0, 1}, 2),
              sliding("s3", 2, 3, {0.25, 0, 0}, {0, 0, 1}),
              fixture::make_joint("s4", 3, 4, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}, 2.6)};
  return r;
}

Robot gantry() {
  Robot r;
  r.name = "gantry";
  r.links = {fixture::make_link("base", 0, Vector3::Zero(), -1), fixture::make_link("x", 4, {0.1, 0, 0}, 0),
             fixture::make_link("y", 3, {0.1, 0, 0}, 1), fixture::make_link("hand", 1, {0, 0, 0.05}, 2)};
  r.joints = {sliding("gx", 0, 1, {0.2, 0, 0.6}, {1, 0, 0}), sliding("gy", 1, 2, {0, 0, 0}, {0, 1, 0}),
              sliding("gz", 2, 3, {0, 0, 0}, {0, 0, 1})};
  return r;
}

Robot turntable() {
  Robot r;
  r.name = "turntable";
  r.links = {fixture::make_link("base", 0, Vector3::Zero(), -1), fixture::make_link("hand", 1, {0, 0, 0}, 0)};
  r.joints = {fixture::make_joint("turn", 0, 1, {0.3, 0, 0.5}, {0, 0, 0}, {0, 0, 1}, 2.6)};
  return r;
}

SimulatedSession simulated(const Session& like, int observations = 20) {
  SimulationOptions o;
  o.observations = observations;
  o.seed = 5;
  o.most_turned = 1.4;
  o.farthest = 4;
  return simulate_session(like, o);
}

constexpr std::array<bool, 6> z_alone{false, false, true, false, false, false};
constexpr std::array<bool, 6> place{true, true, true, false, false, false};

TEST(Undetermined, IsWhereAScaraHoldsTheBodyAlongItsAxes) {
  const auto s = simulated(seen(scara()));
  const Fit f = fit(s.session);
  ASSERT_TRUE(f.converged());
  const auto texts = undetermined_texts(f);
  ASSERT_EQ(texts.size(), 2);
  EXPECT_THAT(texts[0], HasSubstr("TCP->Body is not determined in its place along the TCP's z: every pose turns the "
                                  "hand about the same axis"));
  EXPECT_THAT(texts[1], HasSubstr("The sensor's mount is not determined in its place along the z of the mount's link"));
  EXPECT_EQ(undetermined_motions(body_covariance_at_origin(f)).numbers, z_alone);
  EXPECT_EQ(undetermined_motions(mount_covariance_at_origin(f)).numbers, z_alone);
  EXPECT_FALSE(never_moved(f));
  // The others are as near as they say.
  const Vector6 off = body_error(s, f);
  for (const int i : {0, 1, 3, 4, 5}) {
    EXPECT_LT(std::abs(off[i]), 5 * std::sqrt(f.covariance(i, i)));
    EXPECT_LT(std::sqrt(f.covariance(i, i)), 0.01);
  }
  for (const std::string text : texts) EXPECT_THAT(f.notes, testing::Contains(text));
}

TEST(Undetermined, IsWhatOneAxisDoesNotTell) {
  const Fit f = fit(simulated(seen(turntable())).session);
  ASSERT_TRUE(f.converged());
  const auto texts = undetermined_texts(f);
  ASSERT_EQ(texts.size(), 4);
  EXPECT_THAT(texts[0], HasSubstr("its place along the TCP's z: every pose turns the hand about the same axis"));
  EXPECT_THAT(texts[1], HasSubstr("its turn about the TCP's z: every pose turns the hand about the same axis"));
}

TEST(Undetermined, IsThePlaceWhereNoPoseTurnsTheHand) {
  const Fit f = fit(simulated(seen(gantry(), fixture::tracker_session())).session);
  ASSERT_TRUE(f.converged());
  const auto texts = undetermined_texts(f);
  ASSERT_FALSE(texts.empty());
  EXPECT_THAT(texts[0], HasSubstr("TCP->Body is not determined in its place: no pose turns the hand"));
  EXPECT_EQ(undetermined_motions(body_covariance_at_origin(f)).numbers, place);
  EXPECT_FALSE(never_moved(f));
}

TEST(Undetermined, IsEverythingWhereTheHandNeverMoved) {
  Session like = fixture::stand_session(3);
  like.mount.estimate = true;
  Session s = simulated(like, 1).session;
  for (int i = 1; i < 10; ++i) {
    Observation again = s.observations.front();
    again.id = i;
    again.time += i;
    s.observations.push_back(again);
  }
  const Fit f = fit(s);
  EXPECT_TRUE(never_moved(f));
  const auto texts = undetermined_texts(f);
  ASSERT_EQ(texts.size(), 4);
  EXPECT_THAT(texts[0], HasSubstr("TCP->Body is not determined in its place: the hand stands in one and the same pose "
                                  "in all observations"));
  EXPECT_THAT(texts[1], HasSubstr("TCP->Body is not determined in its turn: "));
}

TEST(Undetermined, IsNothingOfAnArmThatTurns) {
  Session like = fixture::stand_session(3);
  like.mount.estimate = true;
  const Fit f = fit(simulated(like).session);
  ASSERT_TRUE(f.converged());
  EXPECT_TRUE(undetermined_texts(f).empty());
  EXPECT_FALSE(undetermined_motions(body_covariance_at_origin(f)).is_any());
}

/// What nothing is known of is no error of where the hand is.
TEST(Undetermined, DoesNotBlurPredictions) {
  const auto s = simulated(seen(scara()));
  const PredictionModel model = prediction_model(fit(s.session));
  EXPECT_LT(std::sqrt(model.covariance.diagonal().head<6>().maxCoeff()), 0.01);
}

}  // namespace
}  // namespace handsight
