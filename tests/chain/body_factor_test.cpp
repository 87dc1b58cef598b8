// SPDX-License-Identifier: Apache-2.0
#include "chain/body_factor.h"

#include <gtest/gtest.h>

#include <random>

namespace handsight {
namespace {

TEST(BodyFactor, IsOneOfTheBodysCovariance) {
  const std::vector<Vector3> all = {{0.01, 0.02, 0.10}, {0.07, 0.03, 0.11}, {0.02, 0.09, 0.09}, {0.05, 0.05, 0.2}};
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (std::size_t count = 1; count <= all.size(); ++count) {  // with one marker no rotation shows, with two not all
    const std::vector<Vector3> markers(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    const BodyFrame frame = body_frame(choose_sides({markers.begin(), markers.end()}), markers);
    Eigen::MatrixXd of_markers(3 * static_cast<Eigen::Index>(count), 5);
    for (double& x : of_markers.reshaped()) x = 1e-3 * normal(random);
    const Eigen::MatrixXd factor = body_factor(frame, of_markers);
    const Matrix6 covariance = body_covariance(frame, of_markers * of_markers.transpose());
    EXPECT_EQ(factor.rows(), 6);
    EXPECT_LT((factor * factor.transpose() - covariance).norm(), 1e-14 * covariance.norm()) << count;
  }
}

}  // namespace
}  // namespace handsight
