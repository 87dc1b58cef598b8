// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/learned_step.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr std::size_t most_steps = 6;  // directions along which the equations are wrong are few
constexpr double least_part = 1e-3;    // of a change that the other changes do not tell: below, it tells nothing itself
constexpr double nearest = 1.5, farthest = 100;  // times the plain step

Eigen::MatrixXd columns_of(const std::deque<Eigen::VectorXd>& vectors) {
  Eigen::MatrixXd columns(vectors.front().size(), static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = vectors[i];
  return columns;
}

/// The mix of the changes that takes most of the plain step away: least |plain - changes * mix| in the metric.
Eigen::VectorXd best_mix(const Eigen::MatrixXd& changes, const Eigen::VectorXd& plain,
                         const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd weighed = information * changes;
  const Eigen::MatrixXd products = changes.transpose() * weighed;
  const Eigen::VectorXd scale = products.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scale.asDiagonal() * products * scale.asDiagonal());
  qr.setThreshold(least_part);
  return scale.asDiagonal() * qr.solve(scale.asDiagonal() * (weighed.transpose() * plain));
}

}  // namespace

Eigen::VectorXd LearnedStep::next(const Eigen::VectorXd& plain, const Eigen::MatrixXd& information,
                                  const Eigen::VectorXd& gradient) {
  if (taken_.size() == plain.size()) {
    steps_.push_back(taken_);
    changes_.push_back(plain - plain_);
    if (steps_.size() > most_steps) {
      steps_.pop_front();
      changes_.pop_front();
    }
  }
  plain_ = plain;
  taken_.resize(0);
  size_ = 1;
  if (changes_.empty()) return plain;
  const Eigen::MatrixXd changes = columns_of(changes_);
  Eigen::VectorXd learned = plain - (columns_of(steps_) + changes) * best_mix(changes, plain, information);
  constexpr double least_slope = 0.1;  // of the plain step's
  if (!(gradient.dot(learned) > least_slope * gradient.dot(plain)) || !learned.allFinite()) {
    forget();
    return plain;
  }
  size_ = std::sqrt(learned.dot(information * learned) / plain.dot(information * plain));
  if (size_ > reach_) learned *= reach_ / size_;
  size_ = std::min(size_, reach_);
  return learned;
}

void LearnedStep::took(const Eigen::VectorXd& step, bool kept_promise) {
  taken_ = step;
  if (kept_promise) reach_ = std::min(std::max(reach_, 2 * size_), farthest);
}

void LearnedStep::refused() {
  reach_ = size_ / 4;
  if (reach_ < nearest) forget();
}

void LearnedStep::forget() {
  steps_.clear();
  changes_.clear();
  taken_.resize(0);
  reach_ = std::max(reach_, nearest);
}

}  // namespace handsight
