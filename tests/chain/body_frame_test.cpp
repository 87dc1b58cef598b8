// SPDX-License-Identifier: Apache-2.0
#include "chain/body_frame.h"

#include <gtest/gtest.h>

namespace handsight {
namespace {

const std::vector<Vector3> triangle = {{0.01, 0.02, 0.10}, {0.07, 0.03, 0.11}, {0.02, 0.09, 0.09}};

std::vector<std::optional<Vector3>> known(const std::vector<Vector3>& markers) {
  return {markers.begin(), markers.end()};
}

TEST(BodyFrame, IsThatOfTheThesis) {
  const BodySides sides = choose_sides(known(triangle));
  // The side lengths are 61.6, 80.6 and 71.4 mm: 1-2 is the longest, 0-2 the second.
  EXPECT_EQ(sides.longest->from, 1);
  EXPECT_EQ(sides.longest->to, 2);
  EXPECT_EQ(sides.second->from, 0);
  EXPECT_EQ(sides.second->to, 2);
  const Rigid frame = body_frame(sides, triangle).tcp_from_body;
  const Vector3 x = (triangle[2] - triangle[1]).normalized();
  const Vector3 z = x.cross(triangle[2] - triangle[0]).normalized();
  EXPECT_LT((frame.rotation.col(0) - x).norm(), 1e-14);
  EXPECT_LT((frame.rotation.col(2) - z).norm(), 1e-14);
  EXPECT_LT((frame.rotation.col(1) - z.cross(x)).norm(), 1e-14);
  EXPECT_LT((frame.translation - (triangle[0] + triangle[1] + triangle[2]) / 3).norm(), 1e-15);
}

TEST(BodyFrame, OfEqualSidesTheFirstIsTaken) {
  const double height = std::sqrt(3.0) / 2;
  const BodySides sides = choose_sides({Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0.5, height, 0)});
  // 1-2 and 0-2 are equal to 0-1 but for rounding; what matters is that the kept choice does not move the frame.
  std::vector<Vector3> jittered = {{0, 0, 0}, {1, 0, 0}, {0.5, height + 1e-3, 0}};
  const Rigid before = body_frame(sides, {{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}).tcp_from_body;
  const Rigid after = body_frame(sides, jittered).tcp_from_body;
  EXPECT_LT(small_motion_between(before, after).norm(), 5e-3);
}

TEST(BodyFrame, ASecondSideAlongTheLongestIsPassedOver) {
  const BodySides sides =
      choose_sides({Vector3(0, 0, 0), Vector3(0.09, 0, 0), Vector3(0.1, 0, 0), Vector3(0.05, 0.02, 0)});
  EXPECT_EQ(sides.longest->from, 0);
  EXPECT_EQ(sides.longest->to, 2);  // 0-1 is the second longest, and parallel
  ASSERT_TRUE(sides.second);
  EXPECT_TRUE(sides.second->from == 3 || sides.second->to == 3);
}

TEST(BodyFrame, DerivativeAgreesWithDifferences) {
  const BodySides sides = choose_sides(known(triangle));
  const BodyFrame frame = body_frame(sides, triangle);
  for (int k = 0; k < 9; ++k) {
    std::vector<Vector3> more = triangle, less = triangle;
    more[static_cast<std::size_t>(k / 3)][k % 3] += 1e-8;
    less[static_cast<std::size_t>(k / 3)][k % 3] -= 1e-8;
    const Vector6 difference =
        small_motion_between(body_frame(sides, less).tcp_from_body, body_frame(sides, more).tcp_from_body) / 2e-8;
    EXPECT_LT((frame.motion_by_markers.col(k) - difference).norm(), 1e-5) << k;  // entries are near 10 per m
  }
}

TEST(BodyFrame, TwoMarkersLeaveTheTurnAboutTheirLine) {
  const std::vector<Vector3> two = {triangle[0], triangle[1]};
  const BodySides sides = choose_sides(known(two));
  const Matrix3 start = rotation_from_rpy({0.3, 0.1, 0.2});
  const BodyFrame frame = body_frame(sides, two, start);
  EXPECT_LT((frame.tcp_from_body.rotation.col(0) - (two[1] - two[0]).normalized()).norm(), 1e-14);
  ASSERT_EQ(frame.unobserved.cols(), 1);
  EXPECT_LT((frame.unobserved.col(0).tail<3>() - frame.tcp_from_body.rotation.col(0)).norm(), 1e-14);
  const Matrix6 covariance = body_covariance(frame, 1e-8 * Eigen::MatrixXd::Identity(6, 6));
  EXPECT_NEAR(frame.tcp_from_body.rotation.col(0).dot(Matrix3(covariance.bottomRightCorner<3, 3>()) *
                                                      frame.tcp_from_body.rotation.col(0)),
              3.2899, 1e-3);
}

TEST(BodyFrame, OneMarkerIsOnlyAnOrigin) {
  const BodyFrame frame = body_frame(choose_sides({triangle[0]}), {triangle[0]});
  EXPECT_LT((frame.tcp_from_body.translation - triangle[0]).norm(), 1e-16);
  EXPECT_EQ(frame.unobserved.cols(), 3);
}

TEST(BodyFrame, MarkersWithoutAPositionAreLeftOut) {
  const BodySides sides = choose_sides({triangle[0], std::nullopt, triangle[1], triangle[2]});
  EXPECT_EQ(sides.markers, (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(sides.longest->from, 2);
  EXPECT_EQ(sides.longest->to, 3);
}

}  // namespace
}  // namespace handsight
