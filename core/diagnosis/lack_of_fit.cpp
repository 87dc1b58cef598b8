// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/lack_of_fit.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

namespace handsight {

std::optional<LackOfFit> lack_of_fit(const Fit& f) {
  if (!f.noise || !(*f.noise > 0)) return std::nullopt;
  const double total = f.solution.normal.data_cost();
  const double unknowns = f.rows - f.unknowns;
  LackOfFit l;
  if (f.noise_estimate && f.noise_estimate->sigma > 0) {
    // The internal residuals gave the noise; what they leave is there for any effect to explain.
    const double variance = f.noise_estimate->sigma * f.noise_estimate->sigma;
    l.degrees = unknowns - f.noise_estimate->degrees;
    if (l.degrees < 1) return std::nullopt;
    l.chi2 = std::max(total / variance - f.noise_estimate->degrees, 0.0);
    const boost::math::fisher_f expected(l.degrees, f.noise_estimate->degrees);
    l.p = boost::math::cdf(boost::math::complement(expected, l.chi2 / l.degrees));
    return l;
  }
  l.degrees = unknowns;
  if (l.degrees < 1) return std::nullopt;
  l.chi2 = total / (*f.noise * *f.noise);
  l.p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(l.degrees), l.chi2));
  return l;
}

}  // namespace handsight
