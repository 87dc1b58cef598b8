// SPDX-License-Identifier: Apache-2.0
#include "compare/shared_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handsight {
namespace {

constexpr double least_range = 0.2;    // rad (m)
constexpr double most_frequency = 5;   // per rad
constexpr std::size_t most_waves = 8;  // of one joint
constexpr double smoothness = 0.25;    // rad: waves much shorter than this are implausible
constexpr double usual_shift = 3e-4;   // m
constexpr double usual_turn = 5e-4;    // rad (m)

double reading(const Problem& p, const ProblemObservation& o, std::size_t joint) {
  const ProblemSource& source = *p.source;
  return source.states[static_cast<std::size_t>(o.index)].sensor[source.chain.joints[joint]];
}

/// Waves over one and a half times the range: what they add up to need not come back at its end.
void set_waves(SharedCurve& curve, double low, double high, double usual) {
  curve.centre = 0.5 * (low + high);
  const double step = 2 * std::numbers::pi / (1.5 * (high - low));
  double squares = 0;
  for (std::size_t k = 1; k <= most_waves && (k == 1 || static_cast<double>(k) * step <= most_frequency); ++k) {
    const double frequency = static_cast<double>(k) * step;
    curve.frequencies.push_back(frequency);
    curve.sizes.push_back(std::exp(-0.5 * std::pow(smoothness * (frequency - step), 2)));
    squares += std::pow(curve.sizes.back(), 2);
  }
  for (double& size : curve.sizes) size *= usual / std::sqrt(squares);
}

}  // namespace

std::vector<SharedCurve> shared_curves(const std::vector<const Problem*>& problems) {
  std::vector<SharedCurve> curves;
  for (std::size_t joint = 0; joint < problems.front()->source->chain.joints.size(); ++joint) {
    double low = INFINITY, high = -INFINITY;
    for (const Problem* p : problems)
      for (const ProblemObservation& o : p->observations) {
        low = std::min(low, reading(*p, o, joint));
        high = std::max(high, reading(*p, o, joint));
      }
    if (!(high - low > least_range)) continue;
    for (int axis = -1; axis < 3; ++axis) {
      SharedCurve& curve = curves.emplace_back();
      curve.joint = joint;
      curve.axis = axis;
      set_waves(curve, low, high, axis < 0 ? usual_turn : usual_shift);
    }
  }
  return curves;
}

Eigen::Index column_count(const std::vector<SharedCurve>& curves) {
  Eigen::Index count = 0;
  for (const SharedCurve& c : curves) count += c.columns();
  return count;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> motion_by_curves(const std::vector<SharedCurve>& curves, const Problem& p,
                                                          const ProblemObservation& o, const Unknowns& u) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> motion(6, column_count(curves));
  if (curves.empty()) return motion;
  const Matrix6 by_root_motion = adjoint(inverse(o.root_from_mount * find_mount(o, u) * o.sensor_motion));
  const Matrix3 sensor_from_tcp = sensor_from_tcp_at(o, u).rotation;
  Eigen::Index column = 0;
  for (const SharedCurve& c : curves) {
    Vector6 direction = Vector6::Zero();
    if (c.axis < 0)
      direction = by_root_motion * o.motion.tcp_by_value.col(static_cast<Eigen::Index>(c.joint));
    else
      direction.head<3>() = sensor_from_tcp.col(c.axis);
    const double angle = reading(p, o, c.joint) - c.centre;
    for (std::size_t k = 0; k < c.frequencies.size(); ++k) {
      motion.col(column++) = c.sizes[k] * std::sin(c.frequencies[k] * angle) * direction;
      motion.col(column++) = c.sizes[k] * std::cos(c.frequencies[k] * angle) * direction;
    }
  }
  return motion;
}

}  // namespace handsight
