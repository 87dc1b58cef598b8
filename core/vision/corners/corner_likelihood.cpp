// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_likelihood.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <numeric>
#include <utility>

#include "vision/corners/corner_simd.h"

namespace handsight {
namespace {

constexpr int near_px = 40;       // px: what lies so near tells of what a corner lies in
constexpr float same_px = 2;      // px: nearer ones are the same
constexpr float as_deep = 0.25f;  // of a saddle's depth, which is a product of two curvatures
constexpr int round_count = 4;
constexpr CornerSigns weights{-7.25, 0.73, -1.95, -3.06, -1.01, 5};
constexpr double weight_of_others = -1.65, weight_of_board = 4;
constexpr double parallel_sine = 0.12;   // sine, between edges of one board: perspective turns them a little
constexpr double alike_contrast = 1.67;  // times another's contrast
constexpr double few_of_aboard = 8, most_of_aboard = 14;
constexpr double least_excess = 0.02;  // half contrasts
constexpr double least_sine = 1e-3;

int cell(double coordinate) { return static_cast<int>(coordinate) / near_px; }

bool within(double u, double v, double distance) { return u * u + v * v < distance * distance; }
bool within(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double distance) {
  return (a - b).squaredNorm() < distance * distance;
}

// Calls act(i, j) for all that are `distance` px apart at most.
template <class Act>
void each_near_pair(const std::vector<FittedSaddle>& suspects, double distance, const Act& act) {
  struct Place {
    int strip;  // of rows, `distance` px high
    double u;
    int number;
    double v;
    auto operator<=>(const Place&) const = default;  // NOLINT(modernize-use-nullptr): not of the code
  };
  std::vector<Place> places(suspects.size());
  for (std::size_t i = 0; i < suspects.size(); ++i)
    places[i] = {static_cast<int>(std::floor(suspects[i].position.y() / distance)), suspects[i].position.x(),
                 static_cast<int>(i), suspects[i].position.y()};
  std::sort(places.begin(), places.end());
  const auto act_from = [&](const Place& one, auto other, int strip) {
    for (; other != places.end() && other->strip == strip && other->u - one.u < distance; ++other)
      if (within(other->u - one.u, other->v - one.v, distance)) act(one.number, other->number);
  };
  auto below = places.begin();  // the first of the next strip that may be near
  for (auto i = places.begin(); i != places.end(); ++i) {
    act_from(*i, i + 1, i->strip);
    while (below != places.end() && std::pair(below->strip, below->u) < std::pair(i->strip + 1, i->u - distance))
      ++below;
    act_from(*i, below, i->strip + 1);
  }
}

// Of a suspect what is compared with others'.
struct Likeness {
  Eigen::Vector2d first, second;  // along the edges
  Eigen::Vector2d position;       // px
  double contrast;                // half, grey levels
};

Likeness likeness(const FittedSaddle& s) {
  const auto along = [](double angle) { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); };
  return {along(s.edges[0]), along(s.edges[1]), s.position, std::abs(s.half_contrast)};
}

bool alike(const Likeness& a, const Likeness& b) {
  const auto parallel = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return std::abs(p.x() * q.y() - p.y() * q.x()) < parallel_sine;
  };
  return a.contrast < alike_contrast * b.contrast && b.contrast < alike_contrast * a.contrast &&
         ((parallel(a.first, b.first) && parallel(a.second, b.second)) ||
          (parallel(a.first, b.second) && parallel(a.second, b.first)));
}

// What the saddles say of which the distance from (u, v) is that of others that are near.
HANDSIGHT_LANES float said(const float* u, const float* v, const float* depth, const float* says, int count, float at_u,
                           float at_v, float least_depth) {
  constexpr Simd lane_numbers{0, 1, 2, 3, 4, 5, 6, 7};
  Simd sum{}, zero{}, x, y, deep, word;
  for (int n = 0; n < count; n += simd_lanes) {
    load(u + n, x), load(v + n, y), load(depth + n, deep), load(says + n, word);
    x -= at_u, y -= at_v;
    const Simd square = x * x + y * y;
    word = square < same_px * same_px ? zero : word;
    word = square < static_cast<float>(near_px * near_px) ? word : zero;
    word = lane_numbers < static_cast<float>(count - n) ? word : zero;
    sum += deep < least_depth ? zero : word;
  }
  return total(sum);
}

}  // namespace

CornerSigns find_signs(const CornerFit& fit, double image_noise) {
  const double beyond = std::max(fit.noise * fit.noise - image_noise * image_noise, 0.0);
  const double excess = std::max(std::sqrt(beyond) / std::abs(fit.model.half_contrast), least_excess);
  const double skew = std::log(std::max(std::abs(std::sin(fit.model.edges[0] - fit.model.edges[1])), least_sine));
  return {1, fit.radius, fit.model.blur, 0.5 * std::log(fit.covariance.trace()), std::log(excess), skew};
}

double corner_log_odds(const CornerSigns& signs) {
  return std::inner_product(signs.begin(), signs.end(), weights.begin(), 0.0);
}

double log_odds_among(double own, double others, double board) {
  return own + weight_of_others * std::clamp(others, -2.0, 4.0) + weight_of_board * board;
}

SaddleField::SaddleField(int width, int height, const std::vector<CornerCandidate>& candidates)
    : across_(cell(width) + 1), down_(cell(height) + 1), first_(static_cast<std::size_t>(across_) * down_ + 1) {
  const auto cell_of = [&](const CornerCandidate& c) {
    return static_cast<std::size_t>(cell(c.position.y()) * across_ + cell(c.position.x()));
  };
  for (const CornerCandidate& c : candidates)
    if (c.stationary) ++first_[cell_of(c) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  // Whole groups are read, so there are some more.
  const std::size_t count = static_cast<std::size_t>(first_.back()) + simd_lanes;
  u_.resize(count), v_.resize(count), depth_.assign(count, -1), says_.assign(count, 1);
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (const CornerCandidate& c : candidates) {
    if (!c.stationary) continue;
    const auto n = static_cast<std::size_t>(next[cell_of(c)]++);
    u_[n] = static_cast<float>(c.position.x()), v_[n] = static_cast<float>(c.position.y()), depth_[n] = c.saddle;
  }
}

template <class Act>
void SaddleField::each_row_round(const Eigen::Vector2d& position, double reach, const Act& act) const {
  const auto from = [&](double at) { return cell(std::max(at - reach, 0.0)); };
  const int left = from(position.x()), right = std::min(cell(position.x() + reach), across_ - 1);
  const int top = from(position.y()), bottom = std::min(cell(position.y() + reach), down_ - 1);
  for (int j = top; j <= bottom; ++j)  // the cells of a row follow each other
    act(first_[static_cast<std::size_t>(j * across_ + left)],
        first_[static_cast<std::size_t>(j * across_ + right) + 1]);
}

double SaddleField::others(const CornerCandidate& candidate) const {
  double more = 0;
  each_row_round(candidate.position, near_px, [&](int begin, int end) {
    more += said(&u_[begin], &v_[begin], &depth_[begin], &says_[begin], end - begin,
                 static_cast<float>(candidate.position.x()), static_cast<float>(candidate.position.y()),
                 as_deep * candidate.saddle);
  });
  return more;
}

SaddleField::Few SaddleField::at(const Eigen::Vector2d& position) const {
  Few few;
  const auto u = static_cast<float>(position.x()), v = static_cast<float>(position.y());
  each_row_round(position, same_px, [&](int begin, int end) {
    for (int n = begin; n < end; ++n) {
      const float x = u_[n] - u, y = v_[n] - v;
      if (x * x + y * y < same_px * same_px && few.count < few.numbers.size()) few.numbers[few.count++] = n;
    }
  });
  return few;
}

bool SaddleField::has_near(const Eigen::Vector2d& position, double distance) const {
  bool has = false;
  each_row_round(position, distance, [&](int begin, int end) {
    for (int n = begin; n < end && !has; ++n) has = within({u_[n], v_[n]}, position, distance);
  });
  return has;
}

void SaddleField::set_probability(std::span<const int> numbers, double probability) {
  for (const int n : numbers) says_[n] = static_cast<float>(1 - 2 * probability);
}

int SaddleField::counted(std::span<const int> numbers, const CornerCandidate& candidate) const {
  const float least = as_deep * candidate.saddle;
  int count = 0;
  for (const int n : numbers) {  // without branches, which nobody could predict
    const double u = u_[n] - candidate.position.x(), v = v_[n] - candidate.position.y(), square = u * u + v * v;
    count += static_cast<int>(depth_[n] >= least) & static_cast<int>(square < near_px * near_px) &
             static_cast<int>(square >= same_px * same_px);
  }
  return count;
}

std::vector<double> board_signs(const std::vector<FittedSaddle>& suspects) {
  std::vector<Likeness> likenesses(suspects.size());
  std::transform(suspects.begin(), suspects.end(), likenesses.begin(), likeness);
  std::vector<double> signs(suspects.size());
  each_near_pair(suspects, near_px, [&](int i, int j) {
    if (alike(likenesses[i], likenesses[j]) && !within(likenesses[i].position, likenesses[j].position, same_px))
      ++signs[i], ++signs[j];
  });
  for (double& sign : signs) sign = std::clamp((sign - few_of_aboard) / (most_of_aboard - few_of_aboard), 0.0, 1.0);
  return signs;
}

namespace {

// Two that are near each other, and how many of the other's saddles each of them hears.
struct Tie {
  int one, other;
  std::int16_t heard_by_one, heard_by_other;
};

// All ties of one follow each other. `own`: the saddles that each of the suspects is.
std::vector<Tie> ties_of(const std::vector<FittedSaddle>& suspects, const std::vector<SaddleField::Few>& own,
                         const SaddleField& field) {
  std::vector<CornerCandidate> candidates(suspects.size());
  std::transform(suspects.begin(), suspects.end(), candidates.begin(),
                 [](const FittedSaddle& s) { return s.candidate; });
  std::vector<Tie> ties;
  ties.reserve(8 * suspects.size());
  each_near_pair(suspects, near_px + 2 * same_px, [&](int i, int j) {
    const int by_one = field.counted(own[j], candidates[i]), by_other = field.counted(own[i], candidates[j]);
    if (by_one + by_other > 0)
      ties.push_back({i, j, static_cast<std::int16_t>(by_one), static_cast<std::int16_t>(by_other)});
  });
  return ties;
}

}  // namespace

void weigh(std::vector<FittedSaddle>& suspects, SaddleField& field) {
  // Who speaks for a saddle that two were fitted to: the last.
  std::vector<int> owner(field.size(), -1);
  std::vector<SaddleField::Few> own(suspects.size());
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    own[i] = field.at(suspects[i].position);
    for (const int n : std::span<const int>(own[i])) owner[n] = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    auto& [numbers, count] = own[i];
    const auto is_anothers = [&](int n) { return owner[n] != static_cast<int>(i); };
    count = static_cast<std::size_t>(std::remove_if(numbers.begin(), numbers.begin() + count, is_anothers) -
                                     numbers.begin());
  }
  const std::vector<Tie> ties = ties_of(suspects, own, field);
  std::vector<double> if_none(suspects.size()), others, probability(suspects.size()), board = board_signs(suspects);
  const auto settle = [&] {
    for (std::size_t i = 0; i < suspects.size(); ++i) probability[i] = 1 / (1 + std::exp(-suspects[i].log_odds));
  };
  for (const auto& numbers : own) field.set_probability(numbers, 0);
  for (std::size_t i = 0; i < suspects.size(); ++i) if_none[i] = field.others(suspects[i].candidate);
  settle();
  for (int round = 0; round < round_count; ++round) {
    others = if_none;
    for (auto tie = ties.begin(); tie != ties.end();) {
      const int one = tie->one;
      double rest = others[one];
      for (; tie != ties.end() && tie->one == one; ++tie) {
        rest -= 2 * tie->heard_by_one * probability[tie->other];
        others[tie->other] -= 2 * tie->heard_by_other * probability[one];
      }
      others[one] = rest;
    }
    for (std::size_t i = 0; i < suspects.size(); ++i)
      suspects[i].log_odds = log_odds_among(suspects[i].own, others[i], board[i]);
    settle();
  }
  for (std::size_t i = 0; i < suspects.size(); ++i) field.set_probability(own[i], probability[i]);
}

}  // namespace handsight
