// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth curve through points, with its band.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "widgets/plots/scatter_plot.h"

namespace handsight::app {

/// Local straight lines (tricube weights over the nearest third); the band is two sigma of the curve by the scatter
/// about it. Where x takes few values (directions of approach), the mean at each.
std::vector<widgets::TrendPoint> trend_of(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

/// Share of y's square that the curve explains, 0 to 1.
double followed_share(const Eigen::VectorXd& x, const Eigen::VectorXd& y);

}  // namespace handsight::app
