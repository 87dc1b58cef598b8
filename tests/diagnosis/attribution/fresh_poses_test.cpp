// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/attribution/fresh_poses.h"

#include <gtest/gtest.h>

#include <random>

namespace handsight {
namespace {

/// Deviations of 1, 2 and 4 mm along the TCP's axes.
struct Hand {
  std::mt19937 random{7};
  std::normal_distribution<double> normal;
  InspectionRow row(std::int64_t id, bool is_used, double times = 1) {
    InspectionRow r{.id = id, .is_used = is_used};
    r.tcp_from_tcp_est = Rigid{};
    for (int i = 0; i < 3; ++i) r.tcp_from_tcp_est->translation[i] = times * 1e-3 * (1 << i) * normal(random);
    return r;
  }
};

TEST(FreshPoses, NinetyFiveOfAHundredLikeTheFittedOnesAreHits) {
  Hand hand;
  int hits = 0, all = 0;
  for (int draw = 0; draw < 200; ++draw) {
    Inspection inspection;
    for (int i = 0; i < 12; ++i) inspection.rows.push_back(hand.row(i, true));
    for (int i = 12; i < 32; ++i) inspection.rows.push_back(hand.row(i, false));
    for (const FreshPose& pose : fresh_poses(inspection)) hits += pose.is_hit, ++all;
  }
  ASSERT_EQ(all, 4000);
  // 200 ellipsoids of 12 observations each: the share itself is known to about 0.8 %.
  EXPECT_NEAR(static_cast<double>(hits) / all, 0.95, 0.02);
}

TEST(FreshPoses, AMissSaysHowFarTheEllipsoidReachesThatWay) {
  Hand hand;
  Inspection inspection;
  for (int i = 0; i < 400; ++i) inspection.rows.push_back(hand.row(i, true));
  InspectionRow bad{.id = 1000};
  bad.tcp_from_tcp_est = Rigid{};
  bad.tcp_from_tcp_est->translation = Vector3(0.02, 0, 0);
  inspection.rows.push_back(bad);
  bad.id = 1002;
  bad.hand_m = 0.021;  // so Inspect tells it: turned about its markers the hand is elsewhere
  inspection.rows.push_back(bad);
  InspectionRow unseen{.id = 1001};
  inspection.rows.push_back(unseen);
  const auto poses = fresh_poses(inspection);
  ASSERT_EQ(poses.size(), 2U) << "where no hand was seen nothing can be said";
  EXPECT_FALSE(poses[0].is_hit);
  EXPECT_DOUBLE_EQ(poses[0].distance, 0.02);
  EXPECT_NEAR(poses[0].allowed, 2.8e-3, 0.4e-3) << "1 mm times the root of chi-squared's 95 % with 3 degrees, 7.81";
  EXPECT_DOUBLE_EQ(poses[1].distance, 0.021) << "one figure, whoever tells it";
  EXPECT_DOUBLE_EQ(poses[1].allowed / poses[1].distance, poses[0].allowed / poses[0].distance);
}

TEST(FreshPoses, WhatIsKnownToBeWrongTestsNoModel) {
  Hand hand;
  Inspection inspection;
  for (int i = 0; i < 20; ++i) inspection.rows.push_back(hand.row(i, true));
  for (int i = 20; i < 24; ++i) inspection.rows.push_back(hand.row(i, false, 100));
  inspection.rows[20].at_second_look = true;
  inspection.rows[21].attribution.cause = ErrorCause::cameras;
  inspection.rows[22].attribution.cause = ErrorCause::body;
  const auto poses = fresh_poses(inspection);
  ASSERT_EQ(poses.size(), 4U);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(poses[static_cast<std::size_t>(i)].is_known_bad) << i;
  EXPECT_FALSE(poses[3].is_known_bad) << "a robot that is not where it says is what the test is for";
}

TEST(FreshPoses, TooFewFittedSayNothing) {
  Hand hand;
  Inspection inspection;
  for (int i = 0; i < 7; ++i) inspection.rows.push_back(hand.row(i, true));
  inspection.rows.push_back(hand.row(8, false));
  EXPECT_TRUE(fresh_poses(inspection).empty());
}

}  // namespace
}  // namespace handsight
