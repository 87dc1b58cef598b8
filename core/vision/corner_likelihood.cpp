// SPDX-License-Identifier: Apache-2.0
#include "vision/corner_likelihood.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "vision/corner_lanes.h"

namespace handsight {
namespace {

constexpr int kNear = 40;         // px: what lies so near tells of what a corner lies in
constexpr float kSame = 2;        // px: nearer ones are the same
constexpr float kAsDeep = 0.25f;  // of a saddle's depth, which is a product of two curvatures
constexpr int kRounds = 4;
constexpr CornerSigns kWeights{-7.08, 0.73, -1.95, -3.06, -1.01};
constexpr double kWeightOfOthers = -1.65;
constexpr double kLeastExcess = 0.02;  // half contrasts

int cell(double coordinate) { return static_cast<int>(coordinate) / kNear; }

// What the saddles say of which the distance from (u, v) is that of others that are near.
HANDSIGHT_LANES float said(const float* u, const float* v, const float* depth, const float* says, int count, float at_u,
                           float at_v, float least_depth) {
  constexpr Lanes kNumber{0, 1, 2, 3, 4, 5, 6, 7};
  Lanes sum{}, zero{}, x, y, deep, word;
  for (int n = 0; n < count; n += kLanes) {
    load(u + n, x), load(v + n, y), load(depth + n, deep), load(says + n, word);
    x -= at_u, y -= at_v;
    const Lanes square = x * x + y * y;
    word = square < kSame * kSame ? zero : word;
    word = square < static_cast<float>(kNear * kNear) ? word : zero;
    word = kNumber < static_cast<float>(count - n) ? word : zero;
    sum += deep < least_depth ? zero : word;
  }
  return total(sum);
}

}  // namespace

CornerSigns signs_of(const CornerFit& fit, double image_noise) {
  const double beyond = std::max(fit.noise * fit.noise - image_noise * image_noise, 0.0);
  const double excess = std::max(std::sqrt(beyond) / std::abs(fit.model.half_contrast), kLeastExcess);
  return {1, fit.radius, fit.model.blur, 0.5 * std::log(fit.covariance.trace()), std::log(excess)};
}

double corner_log_odds(const CornerSigns& signs) {
  return std::inner_product(signs.begin(), signs.end(), kWeights.begin(), 0.0);
}

double log_odds_among(double own, double others) { return own + kWeightOfOthers * others; }

SaddleField::SaddleField(int width, int height, const std::vector<Candidate>& candidates)
    : across_(cell(width) + 1), down_(cell(height) + 1), first_(static_cast<std::size_t>(across_) * down_ + 1) {
  const auto cell_of = [&](const Candidate& c) {
    return static_cast<std::size_t>(cell(c.position.y()) * across_ + cell(c.position.x()));
  };
  for (const Candidate& c : candidates)
    if (c.stationary) ++first_[cell_of(c) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  // Whole groups are read, so there are some more.
  const std::size_t count = static_cast<std::size_t>(first_.back()) + kLanes;
  u_.resize(count), v_.resize(count), depth_.assign(count, -1), says_.assign(count, 1);
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (const Candidate& c : candidates) {
    if (!c.stationary) continue;
    const auto n = static_cast<std::size_t>(next[cell_of(c)]++);
    u_[n] = static_cast<float>(c.position.x()), v_[n] = static_cast<float>(c.position.y()), depth_[n] = c.saddle;
  }
}

template <class Act>
void SaddleField::each_row_round(const Eigen::Vector2d& position, const Act& act) const {
  const int x = cell(position.x()), y = cell(position.y());
  const int left = std::max(x - 1, 0), right = std::min(x + 1, across_ - 1);
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, down_ - 1); ++j)  // the cells of a row follow each other
    act(first_[static_cast<std::size_t>(j * across_ + left)],
        first_[static_cast<std::size_t>(j * across_ + right) + 1]);
}

double SaddleField::others(const Candidate& candidate) const {
  double more = 0;
  each_row_round(candidate.position, [&](int begin, int end) {
    more += said(&u_[begin], &v_[begin], &depth_[begin], &says_[begin], end - begin,
                 static_cast<float>(candidate.position.x()), static_cast<float>(candidate.position.y()),
                 kAsDeep * candidate.saddle);
  });
  return std::clamp(more, -2.0, 4.0);
}

std::vector<int> SaddleField::at(const Eigen::Vector2d& position) const {
  std::vector<int> numbers;
  const auto u = static_cast<float>(position.x()), v = static_cast<float>(position.y());
  each_row_round(position, [&](int begin, int end) {
    for (int n = begin; n < end; ++n) {
      const float x = u_[n] - u, y = v_[n] - v;
      if (x * x + y * y < kSame * kSame) numbers.push_back(n);
    }
  });
  return numbers;
}

void SaddleField::set_probability(const std::vector<int>& numbers, double probability) {
  for (const int n : numbers) says_[n] = static_cast<float>(1 - 2 * probability);
}

void weigh(std::vector<Suspect>& suspects, SaddleField& field) {
  std::vector<std::vector<int>> own;
  for (const Suspect& suspect : suspects) own.push_back(field.at(suspect.position));
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < suspects.size(); ++i)
      field.set_probability(own[i], 1 / (1 + std::exp(-suspects[i].log_odds)));
    for (Suspect& suspect : suspects) suspect.log_odds = log_odds_among(suspect.own, field.others(suspect.candidate));
  }
}

}  // namespace handsight
