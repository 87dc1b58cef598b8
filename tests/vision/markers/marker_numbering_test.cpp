// SPDX-License-Identifier: Apache-2.0
#include "vision/markers/marker_numbering.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace handsight {
namespace {

const std::vector<Vector3> triangle = {{0, 0, 0}, {0.06, 0, 0}, {0.01, 0.04, 0}};

KnownMarkers assess_knowledge(const std::vector<Vector3>& markers, double sigma = 5e-4) {
  KnownMarkers known;
  for (const Vector3& x : markers) {
    known.in_body.emplace_back(x);
    known.sigma.push_back(sigma);
  }
  return known;
}

/// The markers in this order, turned and moved, as somebody would point at them: the first is called 0.
std::vector<NumberedPoint> pointed(const std::vector<Vector3>& markers, const std::vector<int>& order,
                                   double sigma = 5e-4) {
  const Rigid sensor_from_body{rotation_from_rpy({0.3, -0.7, 2.1}), {0.1, -0.2, 0.9}};
  std::vector<NumberedPoint> points;
  for (const int m : order)
    points.push_back({static_cast<int>(points.size()), sensor_from_body * markers[static_cast<std::size_t>(m)],
                      sigma * sigma * Matrix3::Identity()});
  return points;
}

TEST(MarkerNumbering, EveryOrderOfATriangleIsKnownByItsSides) {
  std::vector<int> order = {0, 1, 2};
  do {
    const auto numbers = numbers_by_sides(pointed(triangle, order), assess_knowledge(triangle));
    if (order == std::vector<int>{0, 1, 2}) {
      EXPECT_FALSE(numbers) << "as they are numbered they agree";
    } else {
      ASSERT_TRUE(numbers);
      EXPECT_EQ(*numbers, order);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(MarkerNumbering, EqualSidesTellNothing) {
  const std::vector<Vector3> isosceles = {{0, 0, 0}, {0.06, 0, 0}, {0.03, 0.02, 0}};
  const auto numbers = numbers_by_sides(pointed(isosceles, {2, 0, 1}), assess_knowledge(isosceles));
  EXPECT_FALSE(numbers) << "two orders fit";
}

TEST(MarkerNumbering, CornersThatAreNotTheMarkersKeepTheirNumbers) {
  auto points = pointed(triangle, {1, 0, 2});
  points[1].point.x() += 0.03;
  EXPECT_FALSE(numbers_by_sides(points, assess_knowledge(triangle)));
}

TEST(MarkerNumbering, ThreeOfFiveMarkersAreKnownToo) {
  const std::vector<Vector3> five = {
      {0, 0, 0}, {0.06, 0, 0}, {0.01, 0.04, 0}, {-0.03, 0.01, 0.02}, {0.02, -0.05, 0.01}};
  const auto numbers = numbers_by_sides(pointed(five, {4, 2, 0}), assess_knowledge(five));
  ASSERT_TRUE(numbers);
  EXPECT_EQ(*numbers, (std::vector<int>{4, 2, 0}));
}

TEST(MarkerNumbering, WherePointsAreBadlyKnownTheNumbersStay) {
  EXPECT_FALSE(numbers_by_sides(pointed(triangle, {1, 0, 2}, 0.02), assess_knowledge(triangle)));
}

}  // namespace
}  // namespace handsight
