// SPDX-License-Identifier: Apache-2.0
// Rows of two tables of poses find each other whatever their order, and nothing else does.
#include "geometry/pose_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace handsight {
namespace {

struct Tables {
  std::vector<Rigid> a, b;
  std::vector<std::size_t> of_b;  // the row of A
};

/// A robot that looks at a board from so many sides: errors of `turn` (rad) and `shift` (m) in each row of A.
Tables mixed(std::uint64_t seed, std::size_t count, double turn, double shift) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto three = [&](double size) {
    Vector3 v;
    for (double& x : v) x = size * normal(random);
    return v;
  };
  const Rigid x{rotation_from_vector<double>(three(1.0)), three(0.1)};
  const Rigid base_from_board{rotation_from_vector<double>(three(1.0)), three(0.5)};
  Tables t;
  for (std::size_t i = 0; i < count; ++i) {
    const Rigid base_from_flange{rotation_from_vector<double>(three(0.4)), three(0.2)};
    t.b.push_back(inverse(base_from_flange * x) * base_from_board);
    t.a.push_back(base_from_flange * Rigid{rotation_from_vector<double>(three(turn)), three(shift)});
  }
  t.of_b.resize(count);
  std::iota(t.of_b.begin(), t.of_b.end(), std::size_t{0});
  std::shuffle(t.of_b.begin(), t.of_b.end(), random);
  std::vector<Rigid> b;
  for (const std::size_t i : t.of_b) b.push_back(t.b[i]);
  t.b = std::move(b);
  return t;
}

TEST(PoseMatching, FindsTheOrderOfARobotThatErrs) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const std::size_t count : {8, 16, 40}) {
      const Tables t = mixed(seed, count, 1e-3, 1e-3);
      const auto found = match_poses(t.a, t.b);
      ASSERT_TRUE(found) << seed << ", " << count;
      EXPECT_EQ(found->count(), count) << seed;
      for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(found->of_b[k], t.of_b[k]) << seed << ", " << count;
    }
}

TEST(PoseMatching, LeavesOutWhatHasNoPartner) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Tables t = mixed(seed, 20, 1e-3, 1e-3);
    t.a.erase(t.a.begin() + 3);
    t.b[7] = t.b[7] * Rigid{rotation_from_rpy({0.9, 0.4, 2.0}), {0.4, 0.3, -0.5}};
    const auto found = match_poses(t.a, t.b);
    ASSERT_TRUE(found) << seed;
    for (std::size_t k = 0; k < t.b.size(); ++k) {
      if (k == 7 || t.of_b[k] == 3) {
        EXPECT_FALSE(found->of_b[k]) << seed;
      } else {
        EXPECT_EQ(found->of_b[k], t.of_b[k] - (t.of_b[k] > 3)) << seed;
      }
    }
  }
}

TEST(PoseMatching, OfPosesThatHaveNothingToDoWithEachOtherPairsFew) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Tables t = mixed(seed, 20, 1e-3, 1e-3), other = mixed(seed + 100, 20, 1e-3, 1e-3);
    const auto found = match_poses(t.a, other.b);
    EXPECT_LT(found ? found->count() : 0, 14u) << seed;
  }
}

TEST(PoseMatching, SaysNothingWhereAllTurnAboutOneAxis) {
  Tables t = mixed(1, 12, 0, 0);
  for (std::size_t i = 0; i < t.a.size(); ++i)
    t.a[i].rotation = rotation_from_rpy({0, 0, 0.2 * static_cast<double>(i)});
  EXPECT_FALSE(match_poses(t.a, t.b));
}

}  // namespace
}  // namespace handsight
