// SPDX-License-Identifier: Apache-2.0
// A smooth curve through points, with its band.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace handsight {

/// Of the curve at x: its value, and its band.
struct TrendPoint {
  double x = 0, y = 0, low = 0, high = 0;
};

/// Local straight lines (tricube weights over the nearest third); the band is two sigma of the curve by the scatter
/// about it. Where x takes few values (directions of approach), the mean at each. Empty with fewer than 4 points.
std::vector<TrendPoint> compute_trend(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

/// Share of y's square that the curve explains, 0 to 1.
double followed_share(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

}  // namespace handsight
