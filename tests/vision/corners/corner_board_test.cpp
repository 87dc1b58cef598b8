// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_board.h"

#include <gtest/gtest.h>

namespace handsight {
namespace {

// A corner of a board of 20 px cells along the axes, in column i and row j.
FittedSaddle of_board(int i, int j) {
  FittedSaddle suspect;
  suspect.position = {100.0 + 20 * i, 90.0 + 20 * j};
  suspect.edges = {0, M_PI / 2};
  suspect.half_contrast = (i + j) % 2 ? -50 : 50;
  return suspect;
}

TEST(CornerBoard, NeighboursLieAlongTheEdgesAndHaveOppositeColours) {
  Lattice lattice(320, 240);
  lattice.add(of_board(0, 0)), lattice.add(of_board(1, 0)), lattice.add(of_board(0, -1)), lattice.add(of_board(1, 1));
  EXPECT_EQ(lattice.neighbours(0), (std::array<int, 4>{1, -1, -1, 2}));
  FittedSaddle same = of_board(-1, 0);
  same.half_contrast *= -1;  // as the corner itself: no board has that
  lattice.add(same);
  EXPECT_EQ(lattice.neighbours(0)[1], -1);
  lattice.add(of_board(-1, 0));
  EXPECT_EQ(lattice.neighbours(0)[1], 5);
}

TEST(CornerBoard, AnEdgesAngleNearHalfATurnIsTheSameDirection) {
  Lattice lattice(320, 240);
  FittedSaddle turned = of_board(1, 0);
  turned.edges = {M_PI / 2, M_PI - 0.01}, turned.half_contrast = 50;  // the same colours, told the other way round
  lattice.add(of_board(0, 0)), lattice.add(turned);
  EXPECT_EQ(lattice.neighbours(0)[0], 1);
}

// Next cells that reach into a fit's disc turn its edges.
TEST(CornerBoard, InSmallCellsNeighboursMayLieAsideOfTheEdges) {
  for (const double size : {7.0, 20.0}) {
    Lattice lattice(320, 240);
    for (const int i : {0, 1}) {
      FittedSaddle suspect = of_board(i, 0);
      suspect.position.x() = 100 + i * size, suspect.edges[0] = 0.4;
      lattice.add(suspect);
    }
    EXPECT_EQ(lattice.neighbours(0)[0], size < 10 ? 1 : -1);
  }
}

TEST(CornerBoard, ForetellsWhatLiesOppositeOfANeighbour) {
  Lattice lattice(320, 240);
  lattice.add(of_board(0, 0)), lattice.add(of_board(1, 0));
  const auto predicted = lattice.predicted_by(0);
  ASSERT_EQ(predicted.size(), 1u);
  EXPECT_NEAR((predicted[0].position - of_board(-1, 0).position).norm(), 0, 1e-9);
  EXPECT_NEAR(predicted[0].spacing, 20, 1e-9);
  EXPECT_TRUE(lattice.suits(predicted[0].witness, of_board(-1, 0)));
  EXPECT_FALSE(lattice.suits(predicted[0].witness, of_board(-2, 0)));
  lattice.add(of_board(-1, 0));
  EXPECT_TRUE(lattice.predicted_by(0).empty());
}

TEST(CornerBoard, AHoleIsForetoldThoughTheNextButTwoLooksLikeANeighbour) {
  Lattice lattice(320, 240);
  lattice.add(of_board(0, 0)), lattice.add(of_board(1, 0)), lattice.add(of_board(-3, 0));
  ASSERT_EQ(lattice.neighbours(0)[1], 2);
  const auto predicted = lattice.predicted_by(0);
  ASSERT_EQ(predicted.size(), 1u);
  EXPECT_NEAR((predicted[0].position - of_board(-1, 0).position).norm(), 0, 1e-9);
  const CornerModel expected = lattice.expected(predicted[0]);
  EXPECT_EQ(expected.half_contrast, of_board(-1, 0).half_contrast);
  EXPECT_EQ(expected.position, predicted[0].position);
}

TEST(CornerBoard, ForetellsAsFarAwayAsANeighboursNeighbourWhereBothSidesAreLacking) {
  Lattice lattice(320, 240);
  lattice.add(of_board(0, 0)), lattice.add(of_board(0, 1)), lattice.add(of_board(1, 1));
  bool is_predicted = false;
  for (const PredictedCorner& predicted : lattice.predicted_by(0))
    is_predicted |= (predicted.position - of_board(1, 0).position).norm() < 1e-9;
  EXPECT_TRUE(is_predicted);
  lattice.add(of_board(1, 0));
  for (const PredictedCorner& predicted : lattice.predicted_by(0))
    EXPECT_GT((predicted.position - of_board(1, 0).position).norm(), 1);
}

TEST(CornerBoard, KnowsWhatIsNear) {
  Lattice lattice(320, 240);
  lattice.add(of_board(0, 0));
  EXPECT_TRUE(lattice.has_near({101, 91}, 2));
  EXPECT_FALSE(lattice.has_near({103, 90}, 2));
  EXPECT_FALSE(lattice.has_near({-50, 1e4}, 2));
}

// A shadow changes contrast and grey level by the same; another board does not.
TEST(CornerBoard, AShadowBetweenNeighboursDividesNoBoard) {
  Lattice lattice(320, 240);
  FittedSaddle lit = of_board(0, 0), dark = of_board(1, 0), other = of_board(-1, 0);
  lit.level = 120, dark.level = 36, dark.half_contrast *= 0.3, other.level = 120, other.half_contrast *= 0.3;
  lattice.add(lit), lattice.add(dark), lattice.add(other);
  EXPECT_EQ(lattice.neighbours(0), (std::array<int, 4>{1, -1, -1, -1}));
}

TEST(CornerBoard, TellsWhereTheLightChangesFromOneCornerToTheNextButOne) {
  Lattice lattice(320, 240);
  FittedSaddle beyond = of_board(2, 0);
  beyond.half_contrast *= 0.5;
  lattice.add(of_board(0, 0)), lattice.add(of_board(-1, 0)), lattice.add(beyond), lattice.add(of_board(0, 2));
  EXPECT_TRUE(lattice.light_changes_at({of_board(1, 0).position, 20, 0, 1}));
  EXPECT_FALSE(lattice.light_changes_at({of_board(0, 1).position, 20, 0, 1}));
  EXPECT_FALSE(lattice.light_changes_at({of_board(0, -1).position, 20, 0, 1})) << "nothing is known there";
}

TEST(CornerBoard, WhatLiesElsewhereAfterAllIsFoundThere) {
  Lattice lattice(320, 240);
  for (int i = 0; i < 4; ++i) lattice.add(of_board(i, 0));
  FittedSaddle moved = of_board(1, 0);
  const Eigen::Vector2d before = moved.position;
  moved.position += Eigen::Vector2d(70, 40);  // in another cell of the lattice
  lattice.replace(1, moved);
  EXPECT_FALSE(lattice.has_near(before, 3));
  EXPECT_EQ(lattice.nearest(moved.position, 3), 1);
  for (const int i : {0, 2, 3}) EXPECT_EQ(lattice.nearest(of_board(i, 0).position, 3), i);
  EXPECT_EQ(lattice.nearest({20, 200}, 5), -1);
}

}  // namespace
}  // namespace handsight
