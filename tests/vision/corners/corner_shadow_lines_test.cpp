// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_shadow_lines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace handsight {
namespace {

// A line 10 px from (100, 100), towards 0.5 rad.
constexpr double edge_direction = 0.5, edge_distance = 10;
const Eigen::Vector2d middle_at(100, 100);
Eigen::Vector2d normal() { return {std::cos(edge_direction), std::sin(edge_direction)}; }

// A corner that sees it, `along` px along it and `before` px before it, its edge turned and moved by what is given.
CornerModel beside(double along, double before, double turn = 0, double move = 0) {
  CornerModel model;
  model.position =
      middle_at + along * Eigen::Vector2d(-normal().y(), normal().x()) + (edge_distance - before) * normal();
  model.shadow = {edge_direction + turn, before + move, 0.5, 1.5};
  if (before < 0) model.shadow = {edge_direction + turn + M_PI, -before + move, -1, 1.5};
  return model;
}

double distance_at(const ShadowEdge& edge) {  // as if seen from the side of (100, 100)
  return std::cos(edge.direction - edge_direction) > 0 ? edge.distance : -edge.distance;
}

TEST(ShadowLines, OneTellsThoseNearIt) {
  ShadowLines lines;
  EXPECT_TRUE(lines.near(middle_at, 12).empty());
  lines.add(beside(30, 3));
  const auto edges = lines.near(middle_at, 12);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_NEAR(edges[0].edge.distance, edge_distance, 1e-9);
  EXPECT_NEAR(edges[0].edge.depth, 0.5, 1e-9);
  EXPECT_FALSE(edges[0].is_certain);
  EXPECT_TRUE(lines.near(middle_at, 9).empty()) << "the edge is 10 px away";
  lines = {};
  lines.add(beside(90, 3));
  EXPECT_TRUE(lines.near(middle_at, 12).empty()) << "one alone tells nothing so far away";
}

// Each is turned a little; together they are right, and from either side of the line.
TEST(ShadowLines, SeveralTellFartherAndBetter) {
  ShadowLines lines;
  for (const double along : {80.0, 100.0, 120.0})
    lines.add(beside(along, along == 100 ? -4 : 3, 0.04, 0.2 * std::sin(along)));
  const auto edges = lines.near(middle_at, 14);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_NEAR(distance_at(edges[0].edge), edge_distance, 1.5);  // 3.2 by one alone
  EXPECT_NEAR(std::remainder(edges[0].edge.direction - edge_direction, M_PI), 0, 0.02);
}

TEST(ShadowLines, AnotherEdgeThatTheNearestSawComesAfterThatOfSeveral) {
  ShadowLines lines;
  for (const double along : {40.0, 50.0}) lines.add(beside(along, 3));
  CornerModel other = beside(5, 6);
  other.shadow = {edge_direction + 1.2, 2, 0.3, 1.5};
  lines.add(other);
  const auto edges = lines.near(middle_at, 20);
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_TRUE(edges[0].is_certain);
  EXPECT_FALSE(edges[1].is_certain);
  EXPECT_NEAR(edges[0].edge.distance, edge_distance, 1e-6);
  EXPECT_NEAR(edges[1].edge.direction, edge_direction + 1.2, 1e-9);
}

TEST(ShadowLines, WhatWasToldBeforeIsNoNews) {
  ShadowLines lines;
  lines.add(beside(10, 3));
  EXPECT_EQ(lines.near(middle_at, 12, 0).size(), 1u);
  EXPECT_TRUE(lines.near(middle_at, 12, lines.size()).empty());
  lines.add(beside(-10, 3));
  EXPECT_EQ(lines.near(middle_at, 12, 1).size(), 1u);
}

}  // namespace
}  // namespace handsight
