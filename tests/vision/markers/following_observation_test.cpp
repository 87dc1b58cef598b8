// SPDX-License-Identifier: Apache-2.0
// Matching of corners to markers, on corners made by projection: no image is needed to try every confusion.
#include "vision/markers/following_observation.h"

#include <gtest/gtest.h>

#include <numeric>

#include "fixtures/arms.h"
#include "simulation/random.h"
#include "vision/markers/first_observation.h"

namespace handsight {
namespace {

const Rigid truth{rotation_from_rpy({2.9, 0.2, 0.4}), {0.05, -0.04, 0.9}};
const double corner_sigma = 0.05;  // px

struct Scene {
  StereoRig rig = make_stereo(*fixture::stand_session().rig);
  std::vector<Corner> left, right;
  Random random{1};

  void add_corner(std::vector<Corner>& corners, const Vector2& pixel) {
    const double a = random.gaussian(), b = random.gaussian();
    corners.push_back({pixel + corner_sigma * Vector2(a, b),
                       corner_sigma * corner_sigma * Eigen::Matrix2d::Identity(),
                       1,
                       100,
                       {0.3, 1.8}});
  }
  void add_point(const Vector3& in_left) {
    add_corner(left, project(rig.left, in_left));
    add_corner(right, project(rig.right, Vector3(rig.right_from_left * in_left)));
  }
  void add_distractors(int count) {
    for (int i = 0; i < count; ++i) {
      const double x = random.uniform(-0.25, 0.25), y = random.uniform(-0.2, 0.2), z = random.uniform(0.6, 1.6);
      add_point({x, y, z});
    }
  }
};

KnownMarkers known(const std::vector<Vector3>& markers) {
  return {{markers.begin(), markers.end()}, std::vector<double>(markers.size(), 1e-4)};
}

std::vector<Vector3> random_markers(int count, Random& random) {
  std::vector<Vector3> all;
  while (static_cast<int>(all.size()) < count) {
    const double x = random.uniform(-0.06, 0.06), y = random.uniform(-0.06, 0.06), z = random.uniform(-0.01, 0.01);
    const Vector3 next(x, y, z);
    bool apart = true;
    for (const Vector3& other : all) apart = apart && (other - next).norm() > 0.014;
    if (apart) all.push_back(next);
  }
  return all;
}

Rigid sagged(double metres, double rad) {
  Vector6 off;
  off << 0.6 * metres, -0.64 * metres, 0.48 * metres, rad, -0.5 * rad, 0.3 * rad;
  Rigid shifted = truth;
  shifted.translation += off.head<3>();
  shifted.rotation = rotation_from_vector<double>(Vector3(off.tail<3>())) * truth.rotation;
  return shifted;
}

/// Every matched marker is on its own corner: marker m's corner is number m in both images.
void expect_right(const Match& match, int base = 0) {
  for (const MatchedMarker& m : match.markers) {
    EXPECT_TRUE(m.left < 0 || m.left == m.marker + base) << m.left;
    EXPECT_TRUE(m.right < 0 || m.right == m.marker + base) << m.right;
  }
}

TEST(Match, FindsTheTriangleAmongDistractorsThoughTheArmSags) {
  int found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    Scene scene;
    scene.random = Random(static_cast<std::uint64_t>(trial));
    const std::vector<Vector3> markers = random_markers(3, scene.random);
    for (const Vector3& m : markers) scene.add_point(truth * m);
    scene.add_distractors(60);
    const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), sagged(0.02, 0.05));
    expect_right(match);  // never a wrong marker
    found += match.accepted() ? 1 : 0;
  }
  EXPECT_GE(found, 97);  // small or nearly symmetric triangles may be refused as ambiguous
}

TEST(Match, ManyMarkersOfWhichAFewAreSeen) {
  for (const int count : {20, 64}) {
    Scene scene;
    const std::vector<Vector3> markers = random_markers(count, scene.random);
    for (const Vector3& m : markers) scene.add_point(truth * m);
    // Only every sixth is really seen: the others' corners move out of the image.
    for (std::size_t i = 0; i < scene.left.size(); ++i)
      if (i % 6 != 0)
        scene.left[i].position = scene.right[i].position = Vector2(-100 - 10.0 * static_cast<double>(i), -50);
    scene.add_distractors(30);
    const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), sagged(0.008, 0.02));
    EXPECT_TRUE(match.accepted()) << match.reason;
    EXPECT_EQ(match.markers.size(), static_cast<std::size_t>((count + 5) / 6)) << count;
    expect_right(match);
  }
}

TEST(Match, NeverTwoMarkersOnOneCorner) {
  Scene scene;
  const std::vector<Vector3> markers = {{0, 0, 0}, {0.05, 0, 0}, {0.02, 0.06, 0}, {0.021, 0.063, 0}};  // 3 mm apart
  for (std::size_t m = 0; m < 3; ++m) scene.add_point(truth * markers[m]);
  const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), truth);
  ASSERT_TRUE(match.accepted()) << match.reason;
  EXPECT_EQ(match.markers.size(), 3u);
  expect_right(match);
}

TEST(Match, SaysHowFarTheBodyIsOff) {
  Scene scene;
  const std::vector<Vector3> markers = {{0, 0, 0}, {0.07, 0, 0}, {0.02, 0.05, 0}};
  for (const Vector3& m : markers) scene.add_point(truth * m);
  const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), sagged(0.043, 0));
  EXPECT_EQ(match.reason, "the markers as a whole are more than 30 mm from where they must be");
  MatchOptions wider;
  wider.body_gate = 0.06;
  EXPECT_TRUE(match_markers(scene.rig, scene.left, scene.right, known(markers), sagged(0.043, 0), wider).accepted());
}

TEST(Match, SideLengthsDecide) {
  Scene scene;
  const std::vector<Vector3> markers = {{0, 0, 0}, {0.07, 0, 0}, {0.02, 0.05, 0}};
  std::vector<Vector3> loose = markers;
  loose[2] += Vector3(0.008, 0.008, 0);
  for (const Vector3& m : loose) scene.add_point(truth * m);
  const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), truth);
  EXPECT_FALSE(match.accepted());
  EXPECT_NE(match.reason.find("side lengths"), std::string::npos) << match.reason;
}

TEST(Match, AMarkerThatOneCameraMissesJoinsByTheOther) {
  Scene scene;
  const std::vector<Vector3> markers = {{0, 0, 0}, {0.07, 0, 0}, {0.02, 0.05, 0}, {0.06, 0.05, 0.01}};
  for (const Vector3& m : markers) scene.add_point(truth * m);
  scene.right.pop_back();
  const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), truth);
  ASSERT_EQ(match.markers.size(), 4u);
  EXPECT_EQ(match.markers[3].left, 3);
  EXPECT_EQ(match.markers[3].right, -1);
}

TEST(Match, TwoOfThreeAreNoPose) {
  Scene scene;
  const std::vector<Vector3> markers = {{0, 0, 0}, {0.07, 0, 0}, {0.02, 0.05, 0}};
  scene.add_point(truth * markers[0]);
  scene.add_point(truth * markers[1]);
  const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), truth);
  EXPECT_FALSE(match.accepted());
  EXPECT_NE(match.reason.find("only 2 of 3"), std::string::npos) << match.reason;
}

TEST(Match, AnAmbiguousTriangleIsRefused) {
  Scene scene;
  const double half = 0.008;  // an equilateral triangle of 16 mm: turned by 120 degrees it looks the same
  const std::vector<Vector3> markers = {{-half, 0, 0}, {half, 0, 0}, {0, half * std::sqrt(3.0), 0}};
  for (const Vector3& m : markers) scene.add_point(truth * m);
  EXPECT_FALSE(match_markers(scene.rig, scene.left, scene.right, known(markers), std::nullopt).accepted());
}

TEST(Label, SnapsAndFindsThePartners) {
  Scene scene;
  const std::vector<Vector3> markers = {{0, 0, 0}, {0.07, 0, 0}, {0.02, 0.05, 0}};
  for (const Vector3& m : markers) scene.add_point(truth * m);
  scene.add_distractors(40);
  std::vector<Vector2> pointed;
  for (const Vector3& m : markers) pointed.push_back(project(scene.rig.left, Vector3(truth * m)) + Vector2(1.5, -2));
  const FirstLabels labels = label_first(scene.rig, scene.left, scene.right, pointed);
  ASSERT_EQ(labels.refusal, "");
  for (std::size_t m = 0; m < 3; ++m) EXPECT_LT((labels.markers[m].point.point - truth * markers[m]).norm(), 2e-3);
}

TEST(Label, RefusesInWordsThatHelp) {
  Scene scene;
  const std::vector<Vector3> line = {{0, 0, 0}, {0.04, 0.0005, 0}, {0.08, 0, 0}};
  for (const Vector3& m : line) scene.add_point(truth * m);
  std::vector<Vector2> pointed;
  for (const Vector3& m : line) pointed.push_back(project(scene.rig.left, Vector3(truth * m)));
  EXPECT_NE(label_first(scene.rig, scene.left, scene.right, pointed).refusal.find("on a line"), std::string::npos);
  pointed[1] += Vector2(0, 200);
  EXPECT_NE(label_first(scene.rig, scene.left, scene.right, pointed).refusal.find("Marker 1: no corner within 12 px"),
            std::string::npos);
  scene.right.clear();
  pointed.resize(1);
  EXPECT_NE(label_first(scene.rig, scene.left, scene.right, pointed).refusal.find("epipolar line"), std::string::npos);
}

TEST(FollowingObservation, BoardsOfAThousandCornersAreDecidedToo) {
  // Every corner of the board may be every marker, and each side of the markers is one of the board's thousands of
  // times.
  const double square = 0.006;
  const std::vector<Vector3> markers = {{0, 0, 0}, {5 * square, 0, 0}, {0, 4 * square, 0}};
  Scene scene;
  for (int column = -20; column < 20; ++column)
    for (int row = -13; row < 12; ++row) scene.add_point(truth * Vector3(square * column, square * row, 0));
  const Match match = match_markers(scene.rig, scene.left, scene.right, known(markers), truth);
  EXPECT_FALSE(match.accepted()) << "nothing tells which corners of the board are the markers";
  EXPECT_GE(match.reason.english().size(), 20u);
  EXPECT_FALSE(match_markers(scene.rig, scene.left, scene.right, known(markers), std::nullopt).accepted());
}

TEST(Label, RefusesOneCornerForTwoMarkers) {
  Scene scene;
  const std::vector<Vector3> markers = {{0, 0, 0}, {0.07, 0, 0}, {0.02, 0.05, 0}};
  for (const Vector3& m : markers) scene.add_point(truth * m);
  scene.add_distractors(200);  // so that the corner's epipolar line has many partners
  std::vector<Vector2> pointed;
  for (const Vector3& m : markers) pointed.push_back(project(scene.rig.left, Vector3(truth * m)));
  pointed[1] = pointed[0] + Vector2(2, 1);
  const std::string refusal = label_first(scene.rig, scene.left, scene.right, pointed).refusal;
  EXPECT_NE(refusal.find("Markers 0 and 1: both are nearest to the corner"), std::string::npos) << refusal;
}

TEST(Label, ChoosesAmongManyMarkersOnCrowdedLines) {
  Scene scene;
  std::vector<Vector3> markers;
  for (int m = 0; m < 12; ++m) markers.push_back({0.03 * (m % 4), 0.03 * (m / 4) + 0.001 * (m % 4), 0.002 * (m % 3)});
  for (const Vector3& m : markers) scene.add_point(truth * m);
  scene.add_distractors(400);
  std::vector<Vector2> pointed;
  for (const Vector3& m : markers) pointed.push_back(project(scene.rig.left, Vector3(truth * m)));
  const FirstLabels labels = label_first(scene.rig, scene.left, scene.right, pointed);
  int right = 0;
  for (std::size_t m = 0; m < labels.markers.size(); ++m)
    right += (labels.markers[m].point.point - truth * markers[m]).norm() < 5e-3 ? 1 : 0;
  EXPECT_TRUE(right >= 8 || labels.refusal.find("too many partners") != std::string::npos) << right << labels.refusal;
}

}  // namespace
}  // namespace handsight
