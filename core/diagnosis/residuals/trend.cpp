// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/residuals/trend.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace handsight {
namespace {

struct Sorted {
  std::vector<double> x, y;
};

Sorted sorted(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(x.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return x[a] < x[b]; });
  Sorted s;
  for (const Eigen::Index i : order) {
    s.x.push_back(x[i]);
    s.y.push_back(y[i]);
  }
  return s;
}

/// Mean and its sigma of the points from `first` to `last`.
TrendPoint mean_of(const Sorted& s, std::size_t first, std::size_t last) {
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(last - first);
  for (std::size_t i = first; i < last; ++i) sum += s.y[i];
  const double mean = sum / count;
  for (std::size_t i = first; i < last; ++i) squares += (s.y[i] - mean) * (s.y[i] - mean);
  const double sigma = count > 1 ? std::sqrt(squares / (count - 1) / count) : 0;
  return {s.x[first], mean, mean - 2 * sigma, mean + 2 * sigma};
}

TrendPoint local_line(const Sorted& s, double at, std::size_t window) {
  auto first = static_cast<std::size_t>(std::lower_bound(s.x.begin(), s.x.end(), at) - s.x.begin());
  std::size_t last = first;
  while (last - first < window && (first > 0 || last < s.x.size())) {
    if (last == s.x.size() || (first > 0 && at - s.x[first - 1] < s.x[last] - at)) {
      --first;
    } else {
      ++last;
    }
  }
  const double reach = std::max({at - s.x[first], s.x[last - 1] - at, 1e-12}) * 1.001;
  double w0 = 0, w1 = 0, w2 = 0, y0 = 0, y1 = 0, ww = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double d = s.x[i] - at, t = std::abs(d) / reach, u = 1 - t * t * t, w = u * u * u;
    w0 += w;
    w1 += w * d;
    w2 += w * d * d;
    y0 += w * s.y[i];
    y1 += w * d * s.y[i];
    ww += w * w;
  }
  w2 += 1e-3 * w0 * reach * reach;
  const double determinant = w0 * w2 - w1 * w1;
  const double value = (w2 * y0 - w1 * y1) / determinant, slope = (w0 * y1 - w1 * y0) / determinant;
  double squares = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double d = s.x[i] - at, t = std::abs(d) / reach, u = 1 - t * t * t, left = s.y[i] - value - slope * d;
    squares += u * u * u * left * left;
  }
  const double sigma = std::sqrt(squares / w0 * ww / (w0 * w0) * w0 * w2 / determinant);
  return {at, value, value - 2 * sigma, value + 2 * sigma};
}

}  // namespace

std::vector<TrendPoint> compute_trend(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  if (x.size() < 4) return {};
  const Sorted s = sorted(x, y);
  constexpr std::size_t few = 5, points = 41;
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 1; i < s.x.size() && starts.size() <= few; ++i)
    if (s.x[i] > s.x[i - 1]) starts.push_back(i);
  std::vector<TrendPoint> trend;
  if (starts.size() <= few) {
    for (std::size_t i = 0; i < starts.size(); ++i)
      trend.push_back(mean_of(s, starts[i], i + 1 < starts.size() ? starts[i + 1] : s.x.size()));
    return trend;
  }
  const std::size_t window = std::max<std::size_t>(6, s.x.size() / 3);
  for (std::size_t i = 0; i < points; ++i) {
    const double share = static_cast<double>(i) / (points - 1);
    trend.push_back(local_line(s, s.x.front() + share * (s.x.back() - s.x.front()), std::min(window, s.x.size())));
  }
  return trend;
}

double followed_share(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  const auto trend = compute_trend(x, y);
  const double whole = y.squaredNorm();
  if (trend.size() < 2 || !(whole > 0)) return 0;
  double left = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto after = std::lower_bound(trend.begin() + 1, trend.end() - 1, x[i],
                                        [](const TrendPoint& p, double at) { return p.x < at; });
    const TrendPoint& b = *after;
    const TrendPoint& a = *(after - 1);
    const double share = b.x > a.x ? (x[i] - a.x) / (b.x - a.x) : 0;
    left += std::pow(y[i] - a.y - std::clamp(share, 0.0, 1.0) * (b.y - a.y), 2);
  }
  return std::clamp(1 - left / whole, 0.0, 1.0);
}

}  // namespace handsight
