// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <random>

#include "experiment/paths/joint_paths.h"
#include "experiment/written_session.h"
#include "robot/posture.h"
#include "temporary_folder.h"

namespace handsight {
namespace {

using testing::HasSubstr;

struct Paths : testing::Test {
  void SetUp() override {
    if (what_paths_need()) GTEST_SKIP() << *what_paths_need();
  }
  static CollisionWorld world_of(const Session& session, const Cell& cell = {}) {
    return {make_chain(session), robot_solids(session), cell, {session.observations[0].position}};
  }
  static Eigen::VectorXd drawn(const JointRanges& ranges, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    Eigen::VectorXd q = ranges.lower;
    for (Eigen::Index j = 0; j < q.size(); ++j) q[j] += uniform(random) * (ranges.upper[j] - ranges.lower[j]);
    return q;
  }
};

Cell post_beside_the_arm() { return {{{{0.1, 0.1, 1.2}, {Matrix3::Identity(), {0.35, 0.25, 0.6}}}}, {}}; }

TEST_F(Paths, AtTwiceFinerStepsNothingTouches) {
  int ways = 0, round = 0;
  for (const Session& session : {fixture::stand_session(), fixture::seven_axis_session()}) {
    const Chain chain = make_chain(session);
    const CollisionWorld world = world_of(session, post_beside_the_arm());
    const JointRanges ranges = joint_ranges(chain, {session.observations[0].position});
    std::mt19937_64 random(3);
    Eigen::VectorXd from = session.observations[0].position;
    for (int i = 0; i < 40; ++i) {
      const Eigen::VectorXd to = drawn(ranges, random);
      const auto way = way_between(world, chain, ranges, from, to, 0.3);
      if (!way) continue;
      ++ways;
      round += way->size() > 1 ? 1 : 0;
      for (const Eigen::VectorXd& point : *way) {
        for (const Eigen::VectorXd& q : steps_between(world, chain, from, point, 2))
          ASSERT_FALSE(world.touching(q, false)) << *world.touching(q, false);
        from = point;
      }
    }
  }
  EXPECT_GE(ways, 12);
  EXPECT_GE(round, 2) << "no way led round anything";
}

/// Of where a robot has come into without a search, none may be found out again but the way that it came.
TEST_F(Paths, WhereNoWayIsFoundItGoesBackFirst) {
  const Session session = fixture::stand_session();
  const Chain chain = make_chain(session);
  const CollisionWorld world = world_of(session, post_beside_the_arm());
  const Eigen::VectorXd before = session.observations[0].position;
  const JointRanges ranges = joint_ranges(chain, {before});
  std::mt19937_64 random(3);
  const auto is_blocked = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return !world.touching(b) && !is_free(world, chain, a, b);
  };
  Eigen::VectorXd at = before, to = before;
  for (int i = 0; i < 400; ++i) {
    const Eigen::VectorXd a = drawn(ranges, random), b = drawn(ranges, random);
    if (!is_free(world, chain, before, a) || !is_free(world, chain, before, b) || !is_blocked(a, b)) continue;
    at = a, to = b;
    break;
  }
  ASSERT_NE(at, to) << "no two postures with something between";
  EXPECT_FALSE(way_between(world, chain, ranges, at, to, 0)) << "without time for a search";
  EXPECT_FALSE(way_by_going_back(world, chain, ranges, at, {}, to, 0));
  const auto way = way_by_going_back(world, chain, ranges, at, {before}, to, 0);
  ASSERT_TRUE(way);
  EXPECT_EQ(*way, (std::vector{before, to}));
  EXPECT_FALSE(way_by_going_back(world, chain, ranges, at, {to, before}, to, 0)) << "not free";
}

TEST_F(Paths, WhatStandsInTheWayIsNamed) {
  Session session = fixture::stand_session();
  Cell cell;
  cell.boxes.push_back({{0.3, 0.3, 0.3}, {Matrix3::Identity(), {0.55, 0, 0.85}}});
  const CollisionWorld free_world = world_of(session), world(make_chain(session), robot_solids(session), cell, {});
  EXPECT_FALSE(free_world.touching(session.observations[0].position));
  const auto touching = world.touching(session.observations[0].position);
  ASSERT_TRUE(touching);
  EXPECT_THAT(*touching, HasSubstr("box 1 of the cell"));
}

TEST_F(Paths, TheFloorIsOneUnlessThePlanesAreTold) {
  Session session = fixture::stand_session();
  Eigen::VectorXd down = Eigen::VectorXd::Zero(6);
  down[1] = 1.4;
  down[2] = 0.17;
  const auto touching = world_of(session).touching(down);
  ASSERT_TRUE(touching);
  EXPECT_THAT(*touching, HasSubstr("the floor"));
  Cell deep;
  deep.planes.push_back({Vector3::UnitZ(), -3});
  EXPECT_FALSE(world_of(session, deep).touching(down));
}

TEST_F(Paths, LinesOfSightEndAtLinksBetween) {
  const Session session = fixture::stand_session();
  const CollisionWorld world = world_of(session);
  const Eigen::VectorXd q = session.observations[0].position;
  EXPECT_FALSE(world.is_hidden(q, {0.9, -1.0, 0.9}, {0, 0, 0}));
  // From behind the arm, along it.
  EXPECT_TRUE(world.is_hidden(q, {-0.8, 0, 0.8}, {0, 0, 0}));
}

TEST_F(Paths, NoPointMovesFartherThanItIsSaid) {
  const Session session = fixture::seven_axis_session();
  const Chain chain = make_chain(session);
  const CollisionWorld world = world_of(session);
  std::mt19937_64 random(5);
  const JointRanges ranges = joint_ranges(chain, {});
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd a = drawn(ranges, random), b = a + 0.02 * (drawn(ranges, random) - a);
    const double way =
        (chain_ends(chain, a).root_from_tcp.translation - chain_ends(chain, b).root_from_tcp.translation).norm();
    EXPECT_LE(way, world.farthest_way(b - a) + 1e-4);  // springs give way by less
  }
}

TEST(RobotSolids, BoxesHoldEveryPointOfAMesh) {
  Mesh mesh;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (std::uint32_t i = 0; i < 300; ++i) {  // an L of small triangles
    const float x = uniform(random), y = uniform(random), z = 0.1F * uniform(random);
    const Eigen::Vector3f corner(i % 2 == 0 ? x : 0.1F * x - 0.9F, i % 2 == 0 ? 0.1F * y - 0.9F : y, z);
    for (const Eigen::Vector3f& off :
         {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(0.02F, 0, 0), Eigen::Vector3f(0, 0.02F, 0)})
      mesh.points.emplace_back(corner + off);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto boxes = make_boxes(mesh, {0.5, 0.5, 0.5}, 0, {rotation_from_rpy({0.3, 0.2, 0.1}), {1, 2, 3}});
  EXPECT_GE(boxes.size(), 2U);
  EXPECT_LE(boxes.size(), 8U);
  for (const Eigen::Vector3f& point : mesh.points) {
    const Vector3 x = Rigid{rotation_from_rpy({0.3, 0.2, 0.1}), {1, 2, 3}} * Vector3(0.5 * point.cast<double>());
    bool is_held = false;
    for (const RobotSolid& box : boxes)
      is_held = is_held || ((inverse(box.link_from_solid) * x).cwiseAbs().array() <= box.size.array() + 1e-9).all();
    EXPECT_TRUE(is_held);
  }
}

TEST(RobotSolids, CollisionShapesComeBeforeVisualOnesAndAnSrdfIsRead) {
  TemporaryFolder folder;
  const auto place = fixture::written_session(fixture::stand_session(), folder.path);
  std::string text = read_file(place / "session.urdf");
  const auto at = text.find("<link name=\"l1\"");
  ASSERT_NE(at, std::string::npos);
  const auto end = text.find('>', at);
  const bool is_closed = text[end - 1] == '/';
  const std::string shapes =
      "><visual><geometry><sphere radius=\"0.3\"/></geometry></visual><collision><origin xyz=\"0 0 0.1\"/>"
      "<geometry><box size=\"0.1 0.2 0.3\"/></geometry></collision>";
  text.replace(is_closed ? end - 1 : end, is_closed ? 2 : 1, is_closed ? shapes + "</link>" : shapes);
  replace_file(place / "session.urdf", text);
  replace_file(place / "arm.srdf",
               "<robot name=\"a\"><disable_collisions link1=\"l3\" link2=\"hand\" reason=\"Never\"/></robot>");
  const RobotSolids solids = robot_solids(read_session(place));
  int of_l1 = 0;
  for (const RobotSolid& s : solids.solids)
    if (s.link == 1) {
      ++of_l1;
      EXPECT_EQ(s.kind, RobotSolidKind::box);
      EXPECT_NEAR((s.size - Vector3(0.05, 0.1, 0.15)).norm(), 0, 1e-12);
      EXPECT_NEAR(s.link_from_solid.translation.z(), 0.1, 1e-12);
    }
  EXPECT_EQ(of_l1, 1);
  EXPECT_TRUE(solids.never_watched.contains({"hand", "l3"}));
}

TEST(Cells, AreReadAndWhatIsNotKnownIsRefused) {
  const Cell cell = parse_cell(
      R"(<handsight_cell version="1"><box size="1 2 3" xyz="0 0 1" rpy="0 0 1"/><plane normal="0 0 2" offset="-0.1"/></handsight_cell>)",
      "cell.xml");
  ASSERT_EQ(cell.boxes.size(), 1U);
  ASSERT_EQ(cell.planes.size(), 1U);
  EXPECT_NEAR(cell.planes[0].normal.z(), 1, 1e-15);
  EXPECT_EQ(cell.planes[0].offset, -0.1);
  for (const char* text : {"<handsight_cell version=\"1\"><ball size=\"1\"/></handsight_cell>",
                           "<handsight_cell version=\"1\"><box size=\"1 0 3\"/></handsight_cell>",
                           "<handsight_cell version=\"1\"><plane normal=\"0 0 0\" offset=\"1\"/></handsight_cell>",
                           "<handsight_cell version=\"2\"/>", "<cell version=\"1\"/>"})
    try {
      parse_cell(text, "cell.xml");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cell.xml")) << text;
    }
}

}  // namespace
}  // namespace handsight
