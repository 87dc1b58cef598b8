// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_board.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr int kCell = 32;            // px
constexpr double kReach = 64;        // px: cells that are larger are smaller in a coarser image
constexpr double kUsualReach = 24;   // px, where most have all their neighbours
constexpr double kLeastSpacing = 3;  // px
constexpr double kParallel = 0.3;    // sine, between edges of neighbours
constexpr double kAlike = 2;         // times another's contrast
// A shadow's edge between two changes contrast and grey level by the same: so many times, and how alike what is left.
constexpr double kMostShadow = 5, kAlikeInShadow = 1.3;
constexpr double kLeastShadow = 1.15;  // times: what changes less may be uneven light
constexpr double kNextButTwo = 2;      // times the spacing, at least
constexpr double kStraight = 0.95;     // cosine, between a step and the edge along which it is
constexpr double kMostUnequal = 6;     // times the other side of a cell, as steep views show it
constexpr double kAside = 0.25;        // of the spacing, from the straight line along an edge
// Next cells that reach into a small one's disc turn its edges: so far aside a neighbour may lie all the same, where
// the corners of other rows are farther.
constexpr double kMostAside = 0.5, kAsideOfSmall = 3;  // of the spacing; px
constexpr double kSure = 0.89;  // of a reach: what is nearer along an edge and not farther aside lies in the reach

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double most_aside(double along) { return std::max(kAside * along, std::min(kMostAside * along, kAsideOfSmall)); }

}  // namespace

Lattice::Node Lattice::node_of(const Suspect& s) {
  const auto along = [](double angle) { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); };
  return {s.position, {along(s.edges[0]), along(s.edges[1])}, s.edges, s.level, s.half_contrast, s.blur};
}

bool Lattice::are_of_one_board(const Node& a, const Node& b) {
  const double one = std::abs(a.half_contrast), other = std::abs(b.half_contrast);
  const auto within = [](double p, double q, double times) { return p < times * q && q < times * p; };
  const bool alike = within(one, other, kAlike) ||
                     (within(one, other, kMostShadow) && within(one * b.level, other * a.level, kAlikeInShadow));
  return alike && edges_go_on(a, b);
}

bool Lattice::edges_go_on(const Node& a, const Node& b) {
  const auto parallel = [&](int i, int j) { return std::abs(cross(a.along[i], b.along[j])) < kParallel; };
  if (!(parallel(0, 0) && parallel(1, 1)) && !(parallel(0, 1) && parallel(1, 0))) return false;
  const Eigen::Vector2d between = a.along[0] + a.along[1];  // in a sector of both
  const auto colour = [&](const Node& n) {
    return n.half_contrast * cross(n.along[0], between) * cross(n.along[1], between);
  };
  return colour(a) * colour(b) < 0;
}

Lattice::Lattice(int width, int height)
    : across_(width / kCell + 1), down_(height / kCell + 1), first_(static_cast<std::size_t>(across_) * down_, -1) {}

int& Lattice::first_near(const Eigen::Vector2d& position) {
  const int u = std::clamp(static_cast<int>(position.x()) / kCell, 0, across_ - 1);
  const int v = std::clamp(static_cast<int>(position.y()) / kCell, 0, down_ - 1);
  return first_[static_cast<std::size_t>(v * across_ + u)];
}

void Lattice::add(const Suspect& suspect) {
  int& first = first_near(suspect.position);
  next_.push_back(first), first = size();
  nodes_.push_back(node_of(suspect));
}

void Lattice::replace(int number, const Suspect& suspect) {
  int* link = &first_near(nodes_[number].position);
  while (*link != number) link = &next_[*link];
  *link = next_[number];
  int& first = first_near(suspect.position);
  next_[number] = first, first = number;
  nodes_[number] = node_of(suspect);
}

template <class Act>
void Lattice::each_near(const Eigen::Vector2d& position, double reach, const Act& act) const {
  const auto cell = [&](double at, int cells) {
    return std::clamp(static_cast<int>(std::max(at, 0.0)) / kCell, 0, cells - 1);
  };
  const int left = cell(position.x() - reach, across_), right = cell(position.x() + reach, across_);
  const int bottom = cell(position.y() + reach, down_);
  for (int v = cell(position.y() - reach, down_); v <= bottom; ++v)
    for (int u = left; u <= right; ++u)
      for (int n = first_[static_cast<std::size_t>(v * across_ + u)]; n >= 0; n = next_[n]) act(n);
}

bool Lattice::has_near(const Eigen::Vector2d& position, double distance) const {
  bool has = false;
  each_near(position, distance,
            [&](int n) { has |= (nodes_[n].position - position).squaredNorm() < distance * distance; });
  return has;
}

int Lattice::nearest(const Eigen::Vector2d& position, double distance) const {
  int nearest = -1;
  double least = distance * distance;
  each_near(position, distance, [&](int n) {
    const double far = (nodes_[n].position - position).squaredNorm();
    if (far < least) least = far, nearest = n;
  });
  return nearest;
}

bool Lattice::light_changes_at(const Foretold& foretold) const {
  const Node& witness = nodes_[foretold.witness];
  const Eigen::Vector2d step = foretold.position - witness.position, beyond = foretold.position + step;
  const double reach = kAside * step.norm(), here = std::abs(witness.half_contrast);
  bool changes = false;
  each_near(beyond, reach, [&](int n) {
    const double there = std::abs(nodes_[n].half_contrast);
    const bool differs = there > kLeastShadow * here || here > kLeastShadow * there;
    changes |= differs && (nodes_[n].position - beyond).squaredNorm() < reach * reach;
  });
  return changes;
}

CornerModel Lattice::expected(const Foretold& foretold) const {
  const Node& witness = nodes_[foretold.witness];
  CornerModel model;
  model.position = foretold.position, model.edges = witness.edges, model.blur = witness.blur;
  model.level = witness.level, model.half_contrast = -witness.half_contrast;
  return model;
}

bool Lattice::suits(int number, const Suspect& suspect) const {
  return are_of_one_board(nodes_[number], node_of(suspect));
}

bool Lattice::may_suit(int number, const Suspect& seen) const { return edges_go_on(nodes_[number], node_of(seen)); }

Lattice::Nearest Lattice::nearest_within(int number, double reach) const {
  const Node& here = nodes_[number];
  Nearest nearest{{-1, -1, -1, -1}, {reach, reach, reach, reach}};
  each_near(here.position, reach, [&](int n) {
    const Eigen::Vector2d off = nodes_[n].position - here.position;
    if (off.squaredNorm() > reach * reach) return;
    for (int edge = 0; edge < 2; ++edge) {
      const double along = here.along[edge].dot(off), distance = std::abs(along);
      const int place = 2 * edge + (along < 0);
      if (!(distance > kLeastSpacing && distance < nearest.distances[place])) continue;
      if (std::abs(cross(here.along[edge], off)) > most_aside(distance)) continue;
      if (are_of_one_board(here, nodes_[n])) nearest.distances[place] = distance, nearest.numbers[place] = n;
    }
  });
  return nearest;
}

std::array<int, 4> Lattice::neighbours(int number) const {
  const Nearest nearest = nearest_within(number, kUsualReach);
  const auto& distances = nearest.distances;
  const bool are_all = *std::max_element(distances.begin(), distances.end()) < kSure * kUsualReach;
  return are_all ? nearest.numbers : nearest_within(number, kReach).numbers;
}

std::optional<Eigen::Vector2d> Lattice::step_beside(int number, int place, const std::array<int, 4>& near) const {
  const Eigen::Vector2d along = (place % 2 == 0 ? 1 : -1) * nodes_[number].along[place / 2];
  for (const int beside : {near[place ^ 2], near[place ^ 3]}) {
    if (beside < 0) continue;
    const Eigen::Vector2d aside = nodes_[beside].position - nodes_[number].position;
    for (const int next : neighbours(beside)) {
      if (next < 0) continue;
      const Eigen::Vector2d step = nodes_[next].position - nodes_[beside].position;
      if (along.dot(step) > kStraight * step.norm() && step.norm() < kMostUnequal * aside.norm()) return step;
    }
  }
  return std::nullopt;
}

std::vector<Foretold> Lattice::foretold_by(int number) const {
  const Node& here = nodes_[number];
  std::vector<Foretold> all;
  const std::array<int, 4> near = neighbours(number);
  for (int place = 0; place < 4; ++place) {
    const int behind = near[place ^ 1];
    std::optional<Eigen::Vector2d> step;
    if (behind >= 0)
      step = here.position - nodes_[behind].position;
    else if (near[place] < 0)
      step = step_beside(number, place, near);
    if (!step) continue;
    // What is much farther is the next but two.
    const bool is_there =
        near[place] >= 0 && (nodes_[near[place]].position - here.position).norm() < kNextButTwo * step->norm();
    if (!is_there) all.push_back({here.position + *step, step->norm(), number, here.blur});
  }
  return all;
}

}  // namespace handsight
