// SPDX-License-Identifier: Apache-2.0
#include "readers/series.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace handsight {
namespace {

/// Joint values at a time between two readings; nothing outside of them or in a gap.
struct At {
  Eigen::VectorXd position;
  bool is_inside = false, is_gap = false;
};

At joints_at(const JointSeries& joints, double time, double widest_gap) {
  At at;
  if (joints.times.empty() || time < joints.times.front() || time > joints.times.back()) return at;
  const auto after =
      static_cast<std::size_t>(std::upper_bound(joints.times.begin(), joints.times.end(), time) - joints.times.begin());
  const std::size_t b = std::min(after, joints.times.size() - 1), a = b > 0 ? b - 1 : 0;
  const double span = joints.times[b] - joints.times[a];
  at.is_inside = true;
  at.is_gap = span > widest_gap;
  const double share = span > 0 ? (time - joints.times[a]) / span : 1;
  at.position = joints.positions[a] + share * (joints.positions[b] - joints.positions[a]);
  return at;
}

/// The largest way of a joint within a time about an instant.
double movement(const JointSeries& joints, double time, double width, double widest_gap) {
  const double begin = std::max(time - width / 2, joints.times.front()),
               end = std::min(time + width / 2, joints.times.back());
  Eigen::VectorXd lowest = joints_at(joints, begin, widest_gap).position, highest = lowest;
  const auto take = [&](const Eigen::VectorXd& q) {
    lowest = lowest.cwiseMin(q);
    highest = highest.cwiseMax(q);
  };
  take(joints_at(joints, end, widest_gap).position);
  for (auto i = std::lower_bound(joints.times.begin(), joints.times.end(), begin); i != joints.times.end() && *i <= end;
       ++i)
    take(joints.positions[static_cast<std::size_t>(i - joints.times.begin())]);
  return (highest - lowest).maxCoeff();
}

/// Of neighbours that show one standstill the middle one is kept.
void keep_one_a_standstill(const PairingOptions& options, Pairing& p) {
  Pairing kept{{}, {}, p.outside, p.moving, p.gaps, 0};
  for (std::size_t begin = 0; begin < p.events.size();) {
    std::size_t end = begin + 1;
    while (end < p.events.size() &&
           (p.positions[end] - p.positions[begin]).cwiseAbs().maxCoeff() <= 2 * options.still_within)
      ++end;
    const std::size_t middle = begin + (end - begin) / 2;
    kept.events.push_back(p.events[middle]);
    kept.positions.push_back(p.positions[middle]);
    kept.repeated += end - begin - 1;
    begin = end;
  }
  p = std::move(kept);
}

/// Speeds of the joints together at evenly spaced times.
std::vector<double> joint_speeds(const JointSeries& joints, double begin, double step, std::size_t count) {
  std::vector<double> speeds(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = begin + step * static_cast<double>(i);
    const At a = joints_at(joints, t - step, 1e9), b = joints_at(joints, t + step, 1e9);
    if (a.is_inside && b.is_inside) speeds[i] = (b.position - a.position).norm() / (2 * step);
  }
  return speeds;
}

std::vector<double> resampled(const std::vector<double>& times, const std::vector<double>& values, double begin,
                              double step, std::size_t count) {
  std::vector<double> out(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = begin + step * static_cast<double>(i);
    const auto after = std::upper_bound(times.begin(), times.end(), t);
    if (after == times.begin() || after == times.end()) continue;
    const auto b = static_cast<std::size_t>(after - times.begin()), a = b - 1;
    const double share = (t - times[a]) / std::max(1e-12, times[b] - times[a]);
    out[i] = values[a] + share * (values[b] - values[a]);
  }
  return out;
}

/// Of a with b moved by `shift` places.
double correlation(const std::vector<double>& a, const std::vector<double>& b, std::ptrdiff_t shift) {
  double n = 0, sa = 0, sb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) + shift;
    if (k < 0 || k >= static_cast<std::ptrdiff_t>(b.size())) continue;
    const double x = a[i], y = b[static_cast<std::size_t>(k)];
    n += 1;
    sa += x;
    sb += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
  if (n < 10) return 0;
  const double va = aa - sa * sa / n, vb = bb - sb * sb / n;
  return va > 0 && vb > 0 ? (ab - sa * sb / n) / std::sqrt(va * vb) : 0;
}

}  // namespace

Pairing paired(const JointSeries& joints, const std::vector<double>& events, const PairingOptions& options) {
  Pairing p;
  for (std::size_t e = 0; e < events.size(); ++e) {
    const double time = events[e] - options.lag;
    const At at = joints_at(joints, time, options.widest_gap);
    if (!at.is_inside) {
      ++p.outside;
    } else if (at.is_gap) {
      ++p.gaps;
    } else if (options.still_for > 0 &&
               movement(joints, time, options.still_for, options.widest_gap) > options.still_within) {
      ++p.moving;
    } else {
      p.events.push_back(e);
      p.positions.push_back(at.position);
    }
  }
  if (options.still_for > 0) keep_one_a_standstill(options, p);
  return p;
}

std::optional<double> estimated_lag(const JointSeries& joints, const std::vector<double>& times,
                                    const std::vector<double>& speeds, double most) {
  if (times.size() < 20 || joints.times.size() < 20) return std::nullopt;
  const double begin = std::max(times.front(), joints.times.front()), end = std::min(times.back(), joints.times.back());
  constexpr double step = 0.01;  // s
  if (end - begin < 4 * most) return std::nullopt;
  const auto count = static_cast<std::size_t>((end - begin) / step);
  const std::vector<double> a = joint_speeds(joints, begin, step, count),
                            b = resampled(times, speeds, begin, step, count);
  const auto widest = static_cast<std::ptrdiff_t>(most / step);
  std::ptrdiff_t best = 0;
  double largest = -1;
  for (std::ptrdiff_t shift = -widest; shift <= widest; ++shift)
    if (const double c = correlation(a, b, shift); c > largest) {
      largest = c;
      best = shift;
    }
  if (largest < 0.5 || std::abs(best) == widest) return std::nullopt;
  // The top of the parabola through the best and its neighbours.
  const double before = correlation(a, b, best - 1), after = correlation(a, b, best + 1);
  const double bend = before - 2 * largest + after;
  return step * (static_cast<double>(best) + (bend < 0 ? 0.5 * (before - after) / bend : 0.0));
}

std::vector<double> compute_speeds(const PoseSeries& series) {
  std::vector<double> speeds(series.poses.size(), 0.0);
  for (std::size_t i = 1; i + 1 < series.poses.size(); ++i) {
    const Vector6 way = small_motion_between(series.poses[i - 1], series.poses[i + 1]);
    const Vector3 shift = series.poses[i + 1].translation - series.poses[i - 1].translation;
    const double span = series.times[i + 1] - series.times[i - 1];
    if (span > 0) speeds[i] = std::hypot(shift.norm(), 0.3 * way.tail<3>().norm()) / span;
  }
  return speeds;
}

}  // namespace handsight
