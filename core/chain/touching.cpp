// SPDX-License-Identifier: Apache-2.0
#include "chain/touching.h"

#include <Eigen/Cholesky>

namespace handsight {

namespace {

constexpr double longest_step = 0.3;    // rad (m)
constexpr double close_enough = 1e-11;  // m

/// d held / d position, by small steps.
Eigen::MatrixXd by_position(const TipInFixture& tip, const FixtureKind& kind, const Eigen::VectorXd& at,
                            const Eigen::VectorXd& held) {
  constexpr double step = 1e-6;
  Eigen::MatrixXd by(held.size(), at.size());
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    Eigen::VectorXd beside = at;
    beside[j] += step;
    by.col(j) = (held_by(kind, tip(beside)) - held) / step;
  }
  return by;
}

}  // namespace

std::optional<Eigen::VectorXd> touching_posture(const TipInFixture& tip, const FixtureKind& kind,
                                                const Eigen::VectorXd& wanted, const Eigen::VectorXd& start,
                                                const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  constexpr int most_steps = 60;
  Eigen::VectorXd position = start.cwiseMax(lower).cwiseMin(upper);
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXd held = held_by(kind, tip(position)), off = wanted - held;
    if (off.norm() < close_enough) return position;
    const Eigen::MatrixXd by = by_position(tip, kind, position, held);
    Eigen::MatrixXd square = by * by.transpose();
    square.diagonal().array() += 1e-12;
    const Eigen::VectorXd way = by.transpose() * square.ldlt().solve(off);
    position = (position + way.cwiseMin(longest_step).cwiseMax(-longest_step)).cwiseMax(lower).cwiseMin(upper);
  }
  return std::nullopt;
}

}  // namespace handsight
