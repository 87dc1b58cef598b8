// SPDX-License-Identifier: Apache-2.0
// Every kind of blunder is named first where it was made, and nothing is named where none was.
#include "blunders/find_blunders.h"

#include "blunder_fixture.h"
#include "blunders/mended.h"

namespace handsight {
namespace {

using fixture::blunders_in;
using fixture::seven_axes;
using fixture::six_axes;
using fixture::turned;
using fixture::with_joint;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr double pi = std::numbers::pi;

TEST(FindBlunders, AJointThatCountsTheOtherWay) {
  for (const char* joint : {"a1", "a2", "a4", "a6"})
    EXPECT_THAT(blunders_in(turned(six_axes(), joint)), ElementsAre(std::string("joint_sense:") + joint));
  EXPECT_THAT(blunders_in(turned(seven_axes(), "j5")), ElementsAre("joint_sense:j5"));
}

TEST(FindBlunders, AJointThatHalfTurnsOfItsNeighboursWouldTurnToo) {
  // Of a shoulder of three axes in one point the middle one counts the other way: half a turn of both others is the
  // same, which zeros that are free would find.
  for (const std::uint64_t seed : {1, 2, 3})
    EXPECT_THAT(blunders_in(turned(seven_axes(seed), "j2")), ElementsAre("joint_sense:j2")) << seed;
}

TEST(FindBlunders, TwoJointsThatCountTheOtherWay) {
  EXPECT_THAT(blunders_in(turned(turned(six_axes(2), "a3"), "a5")),
              UnorderedElementsAre("joint_sense:a3", "joint_sense:a5"));
}

TEST(FindBlunders, JointsOfRobotsThatNobodyHasBuilt) {
  for (std::uint64_t seed : {3, 5, 8}) {
    const Session right = fixture::simulated_right(fixture::with_free_mount(fixture::seen_random_session(seed)), seed);
    const std::string joint = right.joints[2];
    EXPECT_THAT(blunders_in(right), IsEmpty()) << seed;
    const auto names = blunders_in(turned(right, joint));
    EXPECT_THAT(names, ElementsAre("joint_sense:" + joint)) << seed;
  }
}

TEST(FindBlunders, ExchangedJoints) {
  Session s = six_axes(3);
  for (Observation& o : s.observations) std::swap(o.position[1], o.position[4]);
  EXPECT_THAT(blunders_in(s), ElementsAre("joint_swap:a2,a5"));
}

TEST(FindBlunders, AJointReckonedAgainstTheHorizontal) {
  const Session s = six_axes(4);
  EXPECT_THAT(blunders_in(with_joint(s, "a3", [](const auto& q, double a3) { return a3 - q[1]; })),
              ElementsAre("joint_coupled:a3,a2"));
  EXPECT_THAT(blunders_in(with_joint(s, "a3", [](const auto& q, double a3) { return a3 + q[1]; })),
              ElementsAre("joint_coupled:a3,-a2"));
}

TEST(FindBlunders, AnotherZero) {
  const Session s = seven_axes(5);
  EXPECT_THAT(blunders_in(with_joint(s, "j4", [](const auto&, double q) { return q - pi / 2; })),
              ElementsAre("joint_zero:j4=1.5708"));
  // Half a turn between two joints that meet is as good as the joint between them turned.
  EXPECT_THAT(blunders_in(with_joint(s, "j3", [](const auto&, double q) { return q + pi; })),
              ElementsAre(testing::AnyOf("joint_zero:j3=3.14159", "joint_zero:j3=-3.14159", "joint_sense:j2")));
}

TEST(FindBlunders, AnotherZeroOfAnySize) {
  const auto found = blunders_in(with_joint(seven_axes(6), "j5", [](const auto&, double q) { return q + 0.35; }));
  ASSERT_EQ(found.size(), 1u);
  ASSERT_THAT(found[0], testing::StartsWith("joint_zero:j5="));
  EXPECT_NEAR(std::stod(found[0].substr(found[0].find('=') + 1)), -0.35, 0.01);
}

TEST(FindBlunders, AJointInDegrees) {
  EXPECT_THAT(blunders_in(with_joint(six_axes(7), "a4", [](const auto&, double q) { return q * 180 / pi; })),
              ElementsAre("joint_degrees:a4"));
}

TEST(FindBlunders, ImagesPairedWithOtherReadings) {
  for (const int shift : {1, -1, 2}) {
    Session s = six_axes(8);
    const auto right = s.observations;
    const int count = static_cast<int>(right.size());
    for (int i = 0; i < count; ++i) {
      const int from = (i - shift + count) % count;  // the readings of i stand at i + shift
      s.observations[static_cast<std::size_t>(i)].position = right[static_cast<std::size_t>(from)].position;
    }
    s.observations.erase(shift > 0 ? s.observations.begin() : s.observations.end() - 1);
    EXPECT_THAT(blunders_in(s), ElementsAre("pairing_shift:" + std::to_string(shift)));
  }
}

TEST(FindBlunders, InvertedPoses) {
  const Session s = fixture::pose_session(1);
  EXPECT_THAT(blunders_in(s), IsEmpty());
  EXPECT_THAT(blunders_in(fixture::with_target_poses(s, [](const Rigid& p) { return inverse(p); })),
              ElementsAre("pose_inverted:target"));
  EXPECT_THAT(blunders_in(fixture::with_flange_poses(s, [](const Rigid& p) { return inverse(p); })),
              ElementsAre("pose_inverted:flange"));
}

TEST(FindBlunders, InvertedPosesAreSaidToBeTheOtherSideToo) {
  const Session wrong = fixture::with_target_poses(fixture::pose_session(1), [](const Rigid& p) { return inverse(p); });
  const std::vector<Blunder> found = find_blunders(wrong, fit(wrong));
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found.front().text.english(), HasSubstr("the sensor stands beside the robot"));
  EXPECT_THAT(found.front().fix.english(), HasSubstr("Convert with --eye-on-base"));
}

Rigid read_as_rpy(const Rigid& p) { return {rotation_from_rpy(vector_from_rotation(p.rotation)), p.translation}; }
Rigid read_as_vector(const Rigid& p) {
  return {rotation_from_vector<double>(rpy_from_rotation(p.rotation)), p.translation};
}

TEST(FindBlunders, RotationVectorsReadAsRollPitchYaw) {
  for (std::uint64_t seed : {1, 2, 3}) {
    const Session s = fixture::pose_session(seed);
    EXPECT_THAT(blunders_in(fixture::with_flange_poses(s, read_as_rpy)),
                ElementsAre("euler_convention:flange=rotation_vector"));
    EXPECT_THAT(blunders_in(fixture::with_target_poses(s, read_as_rpy)),
                ElementsAre("euler_convention:target=rotation_vector"));
    EXPECT_THAT(blunders_in(fixture::with_target_poses(fixture::with_flange_poses(s, read_as_rpy), read_as_rpy)),
                ElementsAre("euler_convention:both=rotation_vector"));
  }
}

TEST(FindBlunders, RotationVectorsOfAFlangeBeforeImages) {
  // The flange's poses stand for the robot, its camera sees a board on the table.
  const Session arm = fixture::with_free_mount(fixture::simulated_right(fixture::eye_in_hand_session(), 3));
  Session s = arm;
  s.robot = poses_robot();
  s.joints = joint_names(s.robot);
  s.tcp = "base";
  s.mount.link = "flange";
  s.mount.known = false;
  const Chain chain = make_chain(arm);
  for (Observation& o : s.observations) {
    const ChainEnds ends = chain_ends(chain, o.position);
    o.position = make_position(inverse(ends.root_from_tcp) * ends.root_from_mount);
  }
  EXPECT_THAT(blunders_in(s), IsEmpty());
  EXPECT_THAT(blunders_in(fixture::with_flange_poses(s, read_as_rpy)),
              ElementsAre("euler_convention:flange=rotation_vector"));
}

TEST(FindBlunders, RollPitchYawReadAsRotationVectors) {
  EXPECT_THAT(blunders_in(fixture::with_flange_poses(fixture::pose_session(4), read_as_vector)),
              ElementsAre("euler_convention:flange=rpy"));
}

TEST(FindBlunders, TurnsInAnotherOrder) {
  // A B C of a controller, turns about z, y, x, in columns that are called roll, pitch and yaw.
  const auto read = [](const Rigid& p) {
    const Vector3 rpy = rpy_from_rotation(p.rotation);
    return Rigid{rotation_from_rpy({rpy.z(), rpy.y(), rpy.x()}), p.translation};
  };
  EXPECT_THAT(blunders_in(fixture::with_flange_poses(fixture::pose_session(5), read)),
              ElementsAre("euler_convention:flange=zyx"));
}

TEST(FindBlunders, QuaternionsWithWFirst) {
  const auto read = [](const Rigid& p) {  // w x y z taken for x y z w
    const Eigen::Quaterniond q(p.rotation);
    return Rigid{Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix(), p.translation};
  };
  EXPECT_THAT(blunders_in(fixture::with_flange_poses(fixture::pose_session(6), read)),
              ElementsAre("quaternion_order:flange=wxyz"));
  EXPECT_THAT(blunders_in(fixture::with_target_poses(fixture::pose_session(7), read)),
              ElementsAre("quaternion_order:target=wxyz"));
}

TEST(FindBlunders, MillimetresForMetres) {
  Session tracker = fixture::simulated_right(fixture::with_free_mount(fixture::tracker_session(4)), 9);
  tracker.sigma_point.reset();
  for (Observation& o : tracker.observations)
    for (Sighting& s : o.sightings) *s.point *= 1e3;
  EXPECT_THAT(blunders_in(tracker), ElementsAre("length_unit:points"));

  Session board = fixture::simulated_right(fixture::with_free_mount(fixture::target_session()), 9);
  Target target = *board.target;
  target.square *= 1e3;
  target.tag *= 1e3;
  set_target(board, target);
  EXPECT_THAT(blunders_in(board), ElementsAre("length_unit:board"));

  Session rig = six_axes(9);
  rig.rig->at(1).camera_from_first.translation *= 1e3;
  EXPECT_THAT(blunders_in(rig), ElementsAre("length_unit:rig"));
}

/// A tracker whose axes are left-handed: whichever they are, its place takes up the rest.
TEST(FindBlunders, PointsInAMirror) {
  for (const int axis : {0, 1, 2}) {
    Session tracker = fixture::simulated_right(fixture::with_free_mount(fixture::tracker_session(4)), 9);
    for (Observation& o : tracker.observations)
      for (Sighting& s : o.sightings) (*s.point)[axis] *= -1;
    EXPECT_THAT(blunders_in(tracker), ElementsAre("points_mirrored")) << axis;
  }
}

TEST(FindBlunders, AnotherLink) {
  Session s = six_axes(10);
  s.tcp = "l4";
  EXPECT_THAT(blunders_in(s), ElementsAre("wrong_link:hand"));
  Session mounted = six_axes(10);
  mounted.mount.link = "l1";
  EXPECT_THAT(blunders_in(mounted), ElementsAre("wrong_link:mount=stand"));
}

TEST(FindBlunders, ExchangedSides) {
  Session s = six_axes(11);
  for (Observation& o : s.observations)
    for (Sighting& seen : o.sightings) {
      for (CameraPoint& point : seen.in_cameras) point.camera = 1 - point.camera;
      std::reverse(seen.in_cameras.begin(), seen.in_cameras.end());
    }
  EXPECT_THAT(blunders_in(s), ElementsAre("sides_swapped"));
}

TEST(FindBlunders, ColumnsAndRowsOfABoard) {
  Session s = fixture::simulated_right(fixture::with_free_mount(fixture::target_session()), 12);
  EXPECT_THAT(blunders_in(s), IsEmpty());
  Target target = *s.target;
  std::swap(target.columns, target.rows);
  set_target(s, target);
  EXPECT_THAT(blunders_in(s), ElementsAre("board_transposed"));
}

TEST(FindBlunders, ABoardCountedFromTheOtherCorner) {
  const Session right =
      fixture::simulated_right(fixture::with_free_mount(fixture::target_session(fixture::charuco(), 2)), 13);
  const std::string second = right.rig->at(1).name;
  const Session wrong = mended(right, "marker_order:" + second);  // its own inverse
  EXPECT_THAT(blunders_in(wrong), ElementsAre("marker_order:" + second));
}

TEST(FindBlunders, OrdinaryDeviationsAreNoBlunders) {
  const auto offset = [](int joint, double value) { return EffectTerm{"joint_offset", joint, {value}}; };
  const Session like = fixture::with_free_mount(fixture::seven_axis_session(4));
  // Zeros of all joints off by degrees, as on printed arms.
  EXPECT_THAT(blunders_in(fixture::simulated_right(like, 1,
                                                   {offset(0, 0.05), offset(1, -0.06), offset(2, 0.04), offset(3, 0.1),
                                                    offset(4, -0.07), offset(5, 0.05)})),
              IsEmpty());
  // One joint alone, by 4 degrees: by its value, or not at all.
  const auto one = blunders_in(fixture::simulated_right(like, 2, {offset(3, 0.07)}));
  ASSERT_LE(one.size(), 1u);
  if (!one.empty()) {
    ASSERT_THAT(one[0], testing::StartsWith("joint_zero:j4="));
    EXPECT_NEAR(std::stod(one[0].substr(one[0].find('=') + 1)), 0.07, 0.01);
  }
  // Soft joints, bent links.
  EXPECT_THAT(blunders_in(fixture::simulated_right(like, 3,
                                                   {{"joint_elasticity", 1, {2e-4}}, {"joint_elasticity", 3, {2e-4}}})),
              IsEmpty());
  EXPECT_THAT(
      blunders_in(fixture::simulated_right(like, 4, {{"link_geometry", 2, {0.004, -0.003, 0.002, 0.01, -0.02, 0.01}}})),
      IsEmpty());
}

TEST(FindBlunders, ABlunderBesideOrdinaryDeviations) {
  const auto offset = [](int joint, double value) { return EffectTerm{"joint_offset", joint, {value}}; };
  const Session like = fixture::with_free_mount(fixture::seven_axis_session(4));
  const Session off = fixture::simulated_right(like, 5, {offset(1, 0.01), offset(2, -0.02), offset(3, 0.02)});
  EXPECT_THAT(blunders_in(turned(off, "j6")), ElementsAre("joint_sense:j6"));
}

TEST(FindBlunders, SentencesSayWhatAndWhere) {
  const Session s = turned(six_axes(), "a3");
  const Fit f = fit(s);
  const auto found = find_blunders(s, f);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].text.english(), testing::HasSubstr("a3"));
  EXPECT_THAT(found[0].fix, testing::AllOf(testing::HasSubstr("a3"), testing::HasSubstr("session.xml")));
  EXPECT_TRUE(found[0].in_pixels);
  EXPECT_LT(found[0].rms_after, 0.5);
  EXPECT_GT(found[0].rms_before, 10);
  EXPECT_GT(found[0].ln_bayes_factor, 100);
}

TEST(FindBlunders, EndsWhereNobodyWantsItAnyMore) {
  const Session s = turned(six_axes(), "a3");
  EXPECT_THAT(find_blunders(s, fit(s), [](double) { return false; }), IsEmpty());
}

TEST(FindBlunders, PosesThatDoNotGoWithTheOthersUpToNearlyHalf) {
  // A tracker that takes a body for turned: in a stretch of rows, and each time a little otherwise.
  Session s = fixture::pose_session(8);
  std::string ids;
  for (std::size_t i = 6; i < 16; ++i) {
    const double by = 0.7 + 0.1 * static_cast<double>(i);
    const Rigid turned{rotation_from_rpy({by, 0.4, -0.3}), {0.1, 0.02 * static_cast<double>(i), 0.05}};
    *s.observations[i].target_pose = *s.observations[i].target_pose * turned;
    ids += (ids.empty() ? "" : ",") + std::to_string(s.observations[i].id);
  }
  show_poses(s, pose_lever(*s.pose_sensor));
  const Fit whole = fit(s);
  const auto found = find_blunders(s, whole);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, "stray_poses");
  EXPECT_EQ(found[0].where, ids);
  EXPECT_LT(found[0].rms_after, 1e-3);
  EXPECT_THAT(found[0].text.english(), testing::HasSubstr("10 of 24"));
  EXPECT_LT(fit(mended(s, "stray_poses:" + ids)).residual_rms, 1e-3);
}

TEST(FindBlunders, InvertedPosesOfATargetOfAnotherSize) {
  const Session wrong = fixture::with_target_poses(fixture::pose_session(9), [](const Rigid& p) {
    return inverse(Rigid{p.rotation, 3.1 * p.translation});
  });
  EXPECT_THAT(blunders_in(wrong), testing::UnorderedElementsAre(testing::StartsWith("pose_inverted:"),
                                                                testing::StartsWith("target_scaled:target=0.32")));
}

/// A hand that only turns about its own axis before a target that is told larger by a factor, with noise of 10 mm and
/// 20 mrad times `noise`.
Session turned_about_one_axis(std::uint64_t seed, double factor, double noise) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Rigid flange_from_camera{rotation_from_rpy({0.03, -0.05, 1.54}), {0.06, -0.03, 0.05}};
  const Rigid base_from_board{rotation_from_rpy({0.02, 0.03, 0.5}), {0.55, 0.08, 0.01}};
  Session s = fixture::pose_session(seed);
  for (Observation& o : s.observations) {
    const Rigid base_from_flange{rotation_from_rpy({3.13, 0.01, 0.5 * normal(random)}),
                                 {0.5 + 0.1 * normal(random), 0.1 * normal(random), 0.5}};
    o.position = make_position(base_from_flange);
    o.target_pose = inverse(base_from_flange * flange_from_camera) * base_from_board;
    o.target_pose->translation =
        o.target_pose->translation * factor + 0.01 * noise * Vector3(fixture::drawn_3([&] { return normal(random); }));
    o.target_pose->rotation *=
        rotation_from_vector<double>(0.02 * noise * Vector3(fixture::drawn_3([&] { return normal(random); })));
  }
  show_poses(s, usual_lever);
  return s;
}

TEST(FindBlunders, AWrongRowWhereTheHandTurnsAboutOneAxis) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    Session s = turned_about_one_axis(seed, 1, 0.1);
    Observation& wrong = s.observations[5 + seed];
    wrong.target_pose->translation += Vector3(0.2, -0.1, 0.05);
    wrong.target_pose->rotation *= rotation_from_rpy({0.0, 0.0, 0.3});
    show_poses(s, usual_lever);
    EXPECT_THAT(blunders_in(s), ElementsAre("stray_poses:" + std::to_string(wrong.id))) << seed;
  }
}

/// What tells a target's size hardly tells how the turns are to be read.
TEST(FindBlunders, ASizeThatExplainsAsMuchNeedsNoOtherMistake) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Session s = turned_about_one_axis(seed, 1 / 0.6, 1);
    EXPECT_THAT(blunders_in(s), testing::Not(testing::Contains(testing::StartsWith("euler_convention")))) << seed;
  }
}

}  // namespace
}  // namespace handsight
