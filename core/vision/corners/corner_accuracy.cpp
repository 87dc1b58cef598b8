// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_accuracy.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "vision/corners/corner_odd_system.h"
#include "vision/corners/corner_patch.h"

namespace handsight {
namespace {

// Of the variance, that rendered boards of all kinds show: of what moves, of what stays, by the smoothed residuals.
constexpr double measured_share = 0.80, measured_of_staying = 0.75, measured_smoothed = 0.26;
constexpr double freedom_of_image = 30;  // of the variance that the image's corners tell together
constexpr double plain_chi2 = 30;  // chi-squared of added light and bends, four numbers, that noise and the pixels'
                                   // grid do not make: below it the position is better off without them

// The fit's own position, which knows of neither added light nor bends: what they usually are pulls at it. The
// information of the unknowns is that of this variance.
Eigen::Matrix2d covariance_of_staying(const OddSystem& system, const OddVector& information, double variance) {
  Eigen::Matrix4d inverse = system.hessian.topLeftCorner<4, 4>();
  inverse.diagonal() += information.head<4>();
  inverse = inverse.inverse().eval();
  const Eigen::Matrix<double, 2, 4> pulls = inverse.topRows<2>() * system.hessian.topRightCorner<4, 4>();
  const Eigen::Vector4d usual = variance * information.tail<4>().cwiseInverse();
  return measured_of_staying * variance * inverse.topLeftCorner<2, 2>() +
         pulls * usual.asDiagonal() * pulls.transpose();
}

}  // namespace

double pooling(double variance, double weights, double of_image) {
  const double own = std::max(0.5 * weights - odd_unknown_count, 0.0);
  return (own + freedom_of_image * of_image / variance) / (own + freedom_of_image);
}

bool is_plain(const OddSystem& system) {
  double chi2 = 0;
  for (int i = 4; i < odd_unknown_count; ++i) chi2 += system.seen[i] * system.seen[i] / system.seen_variance[i];
  return chi2 * std::min(system.variance_ratio, 1.0) > plain_chi2;  // in terms of all that the fit leaves
}

std::optional<LastStep> last_step(const OddSystem& system, const Habits& habits) {
  const double variance = system.variance * correlation_factor(system, habits);
  OddVector information = usual_information(variance, habits.added, habits.bend);
  for (int i = 4; i < 6; ++i) {  // light may be added by as much as it seems to be here
    const double seen = std::max(system.seen[i] * system.seen[i] - system.seen_variance[i], 0.0);
    information(i) = variance / (habits.added * habits.added + seen);
  }
  OddVector side = system.side;
  side.segment<2>(2) -= information.segment<2>(2).cwiseProduct(system.shade);
  OddMatrix inverse = system.hessian;
  inverse.diagonal() += information;
  if (!invert_odd(inverse)) return std::nullopt;
  const OddVector step = inverse * side;
  LastStep last;
  last.is_needed = system.is_smoothed || is_plain(system) || are_bent(habits) || are_glared(habits);
  last.move = step.head<2>();
  if (!last.is_needed)
    last.covariance = covariance_of_staying(system, information, variance);
  else
    last.covariance =
        (system.is_smoothed ? measured_smoothed : measured_share) * variance * inverse.topLeftCorner<2, 2>();
  if (system.is_smoothed) last.covariance += system.alias;
  if (!(last.covariance(0, 0) > 0 && last.covariance.determinant() > 0)) return std::nullopt;
  return last;
}

}  // namespace handsight
