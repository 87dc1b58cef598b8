// SPDX-License-Identifier: Apache-2.0
#include "vision/markers/marker_numbering.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handsight {
namespace {

constexpr std::size_t most_points = 6;  // all their orders are tried

/// Chi-squared of the sides for these numbers.
double compute_misfit(const std::vector<NumberedPoint>& points, const std::vector<int>& numbers,
                      const KnownMarkers& known) {
  double sum = 0;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      const auto i = static_cast<std::size_t>(numbers[a]), j = static_cast<std::size_t>(numbers[b]);
      const Vector3 side = points[b].point - points[a].point;
      const Vector3 along = side.normalized();
      const double variance = along.dot((points[a].covariance + points[b].covariance) * along) +
                              known.sigma[i] * known.sigma[i] + known.sigma[j] * known.sigma[j] + 1e-12;
      sum += std::pow(side.norm() - (*known.in_body[j] - *known.in_body[i]).norm(), 2) / variance;
    }
  return sum;
}

struct Order {
  std::vector<int> numbers;
  double misfit = std::numeric_limits<double>::infinity();
};

/// The two best orders of the known markers among the points.
std::pair<Order, Order> best_orders(const std::vector<NumberedPoint>& points, const KnownMarkers& known) {
  std::vector<int> all;
  for (std::size_t m = 0; m < known.in_body.size(); ++m)
    if (known.in_body[m]) all.push_back(static_cast<int>(m));
  std::pair<Order, Order> best;
  const std::size_t count = points.size();
  do {
    // Orders that differ only behind the points are one.
    if (!std::is_sorted(all.begin() + static_cast<std::ptrdiff_t>(count), all.end())) continue;
    const std::vector<int> numbers(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    const double misfit = compute_misfit(points, numbers, known);
    if (misfit < best.first.misfit) {
      best.second = best.first;
      best.first = {numbers, misfit};
    } else if (misfit < best.second.misfit) {
      best.second = {numbers, misfit};
    }
  } while (std::next_permutation(all.begin(), all.end()));
  return best;
}

}  // namespace

std::optional<std::vector<int>> numbers_by_sides(const std::vector<NumberedPoint>& points, const KnownMarkers& known) {
  const auto known_count = static_cast<std::size_t>(
      std::count_if(known.in_body.begin(), known.in_body.end(), [](const auto& x) { return x.has_value(); }));
  if (points.size() < 3 || points.size() > known_count || known_count > most_points) return std::nullopt;
  std::vector<int> given;
  for (const NumberedPoint& p : points) {
    given.push_back(p.marker);
    if (p.marker < 0 || static_cast<std::size_t>(p.marker) >= known.in_body.size()) return std::nullopt;
    if (!known.in_body[static_cast<std::size_t>(p.marker)]) return std::nullopt;
  }
  constexpr double limit = 16;  // a side four sigma off, alone
  const double sides = 0.5 * static_cast<double>(points.size() * (points.size() - 1));
  const auto [first, second] = best_orders(points, known);
  const bool may_stay = compute_misfit(points, given, known) <= limit;
  if (may_stay || first.numbers == given) return std::nullopt;
  if (first.misfit > limit + sides || second.misfit < first.misfit + limit) return std::nullopt;
  return first.numbers;
}

}  // namespace handsight
