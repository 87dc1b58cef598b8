// SPDX-License-Identifier: Apache-2.0
#include "targets/tag_whiteness.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handsight {
namespace {

constexpr std::size_t skew_term_count = 5;

/// The normal distribution's integral and density, by tables: exact to 1e-6.
struct NormalTable {
  static constexpr int count = 1024;
  static constexpr double most = 5;
  std::array<double, count + 2> integral{}, density{};
  NormalTable() {
    for (int i = 0; i < count + 2; ++i) {
      const double x = (2.0 * i / count - 1) * most;
      integral[static_cast<std::size_t>(i)] = 0.5 * std::erfc(-x / std::sqrt(2.0));
      density[static_cast<std::size_t>(i)] = std::exp(-0.5 * x * x) / std::sqrt(2 * M_PI);
    }
  }
  struct Value {
    double integral, density;
  };
  Value at(double x) const {
    if (x <= -most) return {0, 0};
    if (x >= most) return {1, 0};
    const double place = (x / most + 1) * (0.5 * count);
    const auto i = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(i);
    return {integral[i] + part * (integral[i + 1] - integral[i]), density[i] + part * (density[i + 1] - density[i])};
  }
};

const NormalTable& normal() {
  static const NormalTable table;
  return table;
}

/// Shares of the light that come from the modules of one row or column, near a place; the first and the last stand for
/// all that is beyond.
struct Shares {
  int first = 0, count = 0;
  std::array<double, 16> share{}, slope{};  // slope: by the place, per module
  /// Differences of density times Hermite's polynomials over each module: the terms of the skew below.
  std::array<std::array<double, 16>, skew_term_count> terms{};
};

/// Hermite's polynomials times the density, at x in sigmas.
std::array<double, skew_term_count> hermite(double x, double density) {
  std::array<double, skew_term_count> h{density, x * density};
  for (std::size_t n = 2; n < skew_term_count; ++n) h[n] = x * h[n - 1] - static_cast<double>(n - 1) * h[n - 2];
  return h;
}

Shares shares_near(double place, double sigma, int side) {
  Shares shares;
  const double reach = std::min(4 * sigma, 5.0);
  shares.first = std::clamp(static_cast<int>(std::floor(place - reach)), -1, side);
  const int last = std::clamp(static_cast<int>(std::floor(place + reach)), -1, side);
  shares.count = last - shares.first + 1;
  NormalTable::Value left{0, 0};
  std::array<double, skew_term_count> left_terms{};
  for (int i = 0; i < shares.count; ++i) {
    const bool is_last = i + 1 == shares.count;
    const double x = (shares.first + i + 1 - place) / sigma;
    const NormalTable::Value right = is_last ? NormalTable::Value{1, 0} : normal().at(x);
    const auto right_terms = hermite(x, right.density);
    for (std::size_t n = 0; n < skew_term_count; ++n)
      shares.terms[n][static_cast<std::size_t>(i)] = right_terms[n] - left_terms[n];
    left_terms = right_terms;
    shares.share[static_cast<std::size_t>(i)] = right.integral - left.integral;
    shares.slope[static_cast<std::size_t>(i)] = (left.density - right.density) / sigma;
    left = right;
  }
  return shares;
}

}  // namespace

Whiteness whiteness(const TagPattern& pattern, const Vector2& place, double sigma_x, double sigma_y,
                    double correlation) {
  const Shares x = shares_near(place.x(), sigma_x, pattern.side), y = shares_near(place.y(), sigma_y, pattern.side);
  Whiteness w{0, 0, 0};
  for (int j = 0; j < y.count; ++j) {
    const int row = y.first + j;
    double sum = 0, slope = 0;
    std::array<double, skew_term_count> terms{};
    for (int i = 0; i < x.count; ++i) {
      const int column = x.first + i;
      const bool is_outside = row < 0 || column < 0 || row >= pattern.side || column >= pattern.side;
      if (!is_outside && !pattern.is_white(column, row)) continue;
      sum += x.share[static_cast<std::size_t>(i)], slope += x.slope[static_cast<std::size_t>(i)];
      for (std::size_t n = 0; n < skew_term_count; ++n) terms[n] += x.terms[n][static_cast<std::size_t>(i)];
    }
    double factor = 1;
    for (std::size_t n = 0; n < skew_term_count; ++n) {
      factor *= correlation / static_cast<double>(n + 1);
      w.value += factor * y.terms[n][static_cast<std::size_t>(j)] * terms[n];
    }
    w.value += y.share[static_cast<std::size_t>(j)] * sum;
    w.by_x += y.share[static_cast<std::size_t>(j)] * slope;
    w.by_y += y.slope[static_cast<std::size_t>(j)] * sum;
  }
  return w;
}

}  // namespace handsight
