// SPDX-License-Identifier: Apache-2.0
#include "geometry/pose_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "geometry/hand_eye_consensus.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_rows = 8;
constexpr double lever = 0.3;           // m: how far off a turn is felt
constexpr double alike_turn = 0.02;     // rad: of two motions that may be one
constexpr double alike_way = 0.02;      // m: along their axes
constexpr double least_turn = 0.1;      // rad: a motion that turns less has no axis to speak of
constexpr double nearest_match = 0.15;  // rad, a shift as a turn `lever` away: of one row, before all have been asked
constexpr std::size_t seeds = 6;
constexpr int draws = 300;
constexpr std::size_t most_triples = 4000;  // of a seed: positions that all look alike tell nothing

/// What stays of a motion whatever frame it is told in.
struct Screw {
  double turn = 0, way = 0;  // rad; m along the axis
};

/// Of each motion from one row to another.
class Screws {
 public:
  explicit Screws(const std::vector<Rigid>& poses) : count_(poses.size()), all_(count_ * count_) {
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t k = 0; k < count_; ++k) {
        const Rigid motion = inverse(poses[k]) * poses[i];
        const Vector3 turn = vector_from_rotation(motion.rotation);
        const double angle = turn.norm();
        all_[i * count_ + k] = {angle, angle > least_turn ? turn.dot(motion.translation) / angle : 0};
      }
  }
  const Screw& between(std::size_t i, std::size_t k) const { return all_[i * count_ + k]; }
  std::size_t count() const { return count_; }

 private:
  std::size_t count_;
  std::vector<Screw> all_;
};

bool are_alike(const Screw& a, const Screw& b) {
  return std::abs(a.turn - b.turn) < alike_turn && (a.turn < least_turn || std::abs(a.way - b.way) < alike_way);
}

using Triple = std::array<std::size_t, 3>;

/// How well three rows tell X: the smaller turn of two motions, times the sine between their axes.
double find_worth(const std::vector<Rigid>& a, const Triple& rows) {
  const Vector3 first = vector_from_rotation((inverse(a[rows[1]]) * a[rows[0]]).rotation),
                second = vector_from_rotation((inverse(a[rows[2]]) * a[rows[0]]).rotation);
  const double least = std::min(first.norm(), second.norm());
  return least < least_turn ? 0 : least * first.normalized().cross(second.normalized()).norm();
}

/// The most telling of many drawn ones, no two of which share a row: one row that is wrong spoils one of them.
std::vector<Triple> choose_seeds(const std::vector<Rigid>& a) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> row(0, a.size() - 1);
  std::vector<std::pair<double, Triple>> drawn;
  for (int i = 0; i < draws; ++i) {
    const Triple rows{row(random), row(random), row(random)};
    if (const double worth = find_worth(a, rows); worth > least_turn * least_turn) drawn.emplace_back(worth, rows);
  }
  std::stable_sort(drawn.begin(), drawn.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  std::vector<Triple> chosen;
  std::vector<bool> is_taken(a.size(), false);
  for (const auto& [worth, rows] : drawn) {
    if (chosen.size() == seeds) break;
    if (std::any_of(rows.begin(), rows.end(), [&](std::size_t r) { return is_taken[r]; })) continue;
    for (const std::size_t r : rows) is_taken[r] = true;
    chosen.push_back(rows);
  }
  return chosen;
}

/// Each row of B with the row of A that X brings nearest to it, the nearest pairs first and within `most`.
PoseMatching pair_nearest(const std::vector<Rigid>& a, const std::vector<Rigid>& b, const Rigid& x, const Rigid& middle,
                          double most) {
  struct Near {
    double left;
    std::size_t of_a, of_b;
  };
  std::vector<Near> near;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Rigid b_from_middle = inverse(a[i] * x) * middle;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const double shift = (b[k].translation - b_from_middle.translation).norm() / lever;
      if (shift > most) continue;
      const double turn = vector_from_rotation(Matrix3(b[k].rotation.transpose() * b_from_middle.rotation)).norm();
      if (const double left = std::hypot(turn, shift); left < most) near.push_back({left, i, k});
    }
  }
  std::stable_sort(near.begin(), near.end(), [](const Near& p, const Near& q) { return p.left < q.left; });
  PoseMatching m{x, std::vector<std::optional<std::size_t>>(b.size())};
  std::vector<bool> is_taken(a.size(), false);
  for (const Near& n : near)
    if (!is_taken[n.of_a] && !m.of_b[n.of_b]) m.of_b[n.of_b] = n.of_a, is_taken[n.of_a] = true;
  return m;
}

/// X of two motions about two axes, and where A X B then is.
struct Answer {
  Rigid x, middle;
};

Answer solve(const std::vector<Rigid>& a, const std::vector<Rigid>& b, const Triple& rows, const Triple& of_b) {
  Matrix3 sum = Matrix3::Zero(), normal = 1e-12 * Matrix3::Identity();
  std::array<Rigid, 2> motion_a, motion_b;
  std::array<Vector3, 2> turn_a, turn_b;
  for (std::size_t n = 0; n < 2; ++n) {
    motion_a[n] = inverse(a[rows[n + 1]]) * a[rows[0]];
    motion_b[n] = b[of_b[n + 1]] * inverse(b[of_b[0]]);
    turn_a[n] = vector_from_rotation(motion_a[n].rotation), turn_b[n] = vector_from_rotation(motion_b[n].rotation);
    sum += turn_a[n] * turn_b[n].transpose();
  }
  sum += turn_a[0].cross(turn_a[1]) * turn_b[0].cross(turn_b[1]).transpose();
  Answer answer{{nearest_rotation(sum), Vector3::Zero()}, {}};
  Vector3 right = Vector3::Zero();
  for (std::size_t n = 0; n < 2; ++n) {
    const Matrix3 of = motion_a[n].rotation - Matrix3::Identity();
    normal += of.transpose() * of;
    right += of.transpose() * (answer.x.rotation * motion_b[n].translation - motion_a[n].translation);
  }
  answer.x.translation = normal.inverse() * right;
  answer.middle = a[rows[0]] * answer.x * b[of_b[0]];
  return answer;
}

/// What most rows of both have in common where three rows of A are any three of B.
class Matcher {
 public:
  Matcher(const std::vector<Rigid>& a, const std::vector<Rigid>& b) : a_(a), b_(b), of_a_(a), of_b_(backwards(b)) {}

  void try_seed(const Triple& rows) {
    std::size_t tried = 0;
    for (std::size_t i = 0; i < b_.size(); ++i)
      for (std::size_t k = 0; k < b_.size(); ++k) {
        if (!are_alike(of_a_.between(rows[0], rows[1]), of_b_.between(i, k))) continue;
        for (std::size_t n = 0; n < b_.size(); ++n) {
          if (!are_alike(of_a_.between(rows[0], rows[2]), of_b_.between(i, n)) ||
              !are_alike(of_a_.between(rows[1], rows[2]), of_b_.between(k, n)))
            continue;
          if (++tried > most_triples || pairs_nearly_all()) return;
          try_triple(rows, {i, k, n});
        }
      }
  }

  const std::optional<PoseMatching>& best() const { return best_; }
  bool pairs_nearly_all() const {
    constexpr double nearly_all = 0.9;
    return best_ &&
           static_cast<double>(best_->count()) > nearly_all * static_cast<double>(std::min(a_.size(), b_.size()));
  }

 private:
  /// A motion of B is B_k B_i^-1, that of A A_k^-1 A_i: both are told alike of the inverse poses.
  static std::vector<Rigid> backwards(std::vector<Rigid> poses) {
    for (Rigid& pose : poses) pose = inverse(pose);
    return poses;
  }

  void try_triple(const Triple& rows, const Triple& of_b) {
    const Answer answer = solve(a_, b_, rows, of_b);
    PoseMatching m = pair_nearest(a_, b_, answer.x, answer.middle, nearest_match);
    if (!best_ || m.count() > best_->count()) best_ = std::move(m);
  }

  const std::vector<Rigid>&a_, &b_;
  Screws of_a_, of_b_;
  std::optional<PoseMatching> best_;
};

/// Once more by all pairs together.
void refine(const std::vector<Rigid>& a, const std::vector<Rigid>& b, PoseMatching& m) {
  constexpr double times_left = 6, least = 0.04;
  std::vector<Rigid> pair_a, pair_b;
  for (std::size_t k = 0; k < b.size(); ++k)
    if (m.of_b[k]) pair_a.push_back(a[*m.of_b[k]]), pair_b.push_back(b[k]);
  const auto all = hand_eye_consensus(pair_a, pair_b);
  if (!all) return;
  const auto first =
      static_cast<std::size_t>(std::find(all->agrees.begin(), all->agrees.end(), true) - all->agrees.begin());
  const Rigid middle = pair_a[first] * all->x * pair_b[first];
  PoseMatching again = pair_nearest(a, b, all->x, middle, std::max(least, times_left * all->left));
  if (again.count() >= std::min(m.count(), all->count())) m = std::move(again);
}

}  // namespace

std::size_t PoseMatching::count() const {
  return static_cast<std::size_t>(
      std::count_if(of_b.begin(), of_b.end(), [](const auto& row) { return row.has_value(); }));
}

std::optional<PoseMatching> match_poses(const std::vector<Rigid>& a, const std::vector<Rigid>& b) {
  if (std::min(a.size(), b.size()) < fewest_rows) return std::nullopt;
  Matcher matcher(a, b);
  for (const Triple& rows : choose_seeds(a)) matcher.try_seed(rows);
  if (!matcher.best() || matcher.best()->count() < fewest_rows) return std::nullopt;
  PoseMatching m = *matcher.best();
  refine(a, b, m);
  return m;
}

}  // namespace handsight
