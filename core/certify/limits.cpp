// SPDX-License-Identifier: Apache-2.0
#include "certify/limits.h"

#include <Eigen/Eigenvalues>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace handsight {

double length_limit(const Matrix3& covariance, double probability) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(covariance, Eigen::EigenvaluesOnly);
  const Vector3 variances = eigen.eigenvalues().cwiseMax(0);
  const double sum = variances.sum(), squares = variances.squaredNorm();
  if (!(sum > 0)) return 0;
  const double scale = squares / sum, degrees = sum * sum / squares;
  return std::sqrt(scale * boost::math::quantile(boost::math::chi_squared(degrees), probability));
}

ShareInterval clopper_pearson(int inside, int all, double confidence) {
  namespace bm = boost::math;
  const double tail = (1 - confidence) / 2;
  ShareInterval share;
  if (inside > 0) share.low = bm::quantile(bm::beta_distribution<>(inside, all - inside + 1), tail);
  if (inside < all) share.high = bm::quantile(bm::beta_distribution<>(inside + 1, all - inside), 1 - tail);
  return share;
}

}  // namespace handsight
