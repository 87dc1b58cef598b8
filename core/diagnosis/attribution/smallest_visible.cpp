// SPDX-License-Identifier: Apache-2.0
// The smallest wrong corner that an observation could have shown: Baarda's minimal detectable bias.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>

#include "chain/sighting.h"
#include "diagnosis/attribution/error_attribution.h"
#include "diagnosis/evidence/body_rows.h"
#include "geometry/orthonormal_columns.h"

namespace handsight {
namespace {

constexpr double power = 0.8;

/// What a test of two degrees (three) of freedom shows with that power.
double noncentrality_of(int degrees) {
  const double limit =
      boost::math::quantile(boost::math::complement(boost::math::chi_squared(degrees), least_likely_noise));
  return boost::math::non_central_chi_squared::find_non_centrality(degrees, limit, 1 - power);
}

double noncentrality(Eigen::Index degrees) {
  static const double two = noncentrality_of(2), three = noncentrality_of(3);
  return degrees == 3 ? three : two;
}

}  // namespace

std::optional<double> smallest_visible(const Problem& problem, const ProblemObservation& o, const Unknowns& u,
                                       double noise) {
  const BodyRows rows = body_rows(problem, o, u);
  const Eigen::Index count = rows.error.size();
  if (count <= 6) return std::nullopt;
  const Eigen::MatrixXd q = orthonormal_columns(rows.by_body);
  double largest = 0;
  Eigen::Index row = 0;
  for (const Sighting& s : o.sightings) {
    const Eigen::Index size = s.point ? row_count(s) : 2;
    for (Eigen::Index end = row + row_count(s); row < end; row += size) {
      const Eigen::MatrixXd mine = q.middleRows(row, size);
      const Eigen::MatrixXd shown = Eigen::MatrixXd::Identity(size, size) - mine * mine.transpose();
      const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(shown).eigenvalues().minCoeff();
      if (least < 1e-6) return std::nullopt;
      largest = std::max(largest, noise * std::sqrt(noncentrality(size) / least));
    }
  }
  return largest;
}

}  // namespace handsight
