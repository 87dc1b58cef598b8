// SPDX-License-Identifier: Apache-2.0
#include "vision/corners/corner_board.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr int cell_size = 32;          // px
constexpr double reach_px = 64;        // px: cells that are larger are smaller in a coarser image
constexpr double usual_reach = 24;     // px, where most have all their neighbours
constexpr double least_spacing = 3;    // px
constexpr double parallel_sine = 0.3;  // sine, between edges of neighbours
constexpr double alike_contrast = 2;   // times another's contrast
// A shadow's edge between two changes contrast and grey level by the same: so many times, and how alike what is left.
constexpr double most_shadow = 5, alike_in_shadow = 1.3;
constexpr double least_shadow = 1.15;      // times: what changes less may be uneven light
constexpr double next_but_two = 2;         // times the spacing, at least
constexpr double straight = 0.95;          // cosine, between a step and the edge along which it is
constexpr double most_unequal = 6;         // times the other side of a cell, as steep views show it
constexpr double most_aside_share = 0.25;  // of the spacing, from the straight line along an edge
// Next cells that reach into a small one's disc turn its edges: so far aside a neighbour may lie all the same, where
// the corners of other rows are farther.
constexpr double most_off_line = 0.5, aside_of_small = 3;  // of the spacing; px
constexpr double sure_share = 0.89;  // of a reach: what is nearer along an edge and not farther aside lies in the reach

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double most_aside(double along) {
  return std::max(most_aside_share * along, std::min(most_off_line * along, aside_of_small));
}

}  // namespace

Lattice::Node Lattice::make_node(const FittedSaddle& s) {
  const auto along = [](double angle) { return Eigen::Vector2d(std::cos(angle), std::sin(angle)); };
  return {s.position, {along(s.edges[0]), along(s.edges[1])}, s.edges, s.level, s.half_contrast, s.blur};
}

bool Lattice::are_of_one_board(const Node& a, const Node& b) {
  const double one = std::abs(a.half_contrast), other = std::abs(b.half_contrast);
  const auto within = [](double p, double q, double times) { return p < times * q && q < times * p; };
  const bool alike = within(one, other, alike_contrast) ||
                     (within(one, other, most_shadow) && within(one * b.level, other * a.level, alike_in_shadow));
  return alike && edges_go_on(a, b);
}

bool Lattice::edges_go_on(const Node& a, const Node& b) {
  const auto parallel = [&](int i, int j) { return std::abs(cross(a.along[i], b.along[j])) < parallel_sine; };
  if (!(parallel(0, 0) && parallel(1, 1)) && !(parallel(0, 1) && parallel(1, 0))) return false;
  const Eigen::Vector2d between = a.along[0] + a.along[1];  // in a sector of both
  const auto colour = [&](const Node& n) {
    return n.half_contrast * cross(n.along[0], between) * cross(n.along[1], between);
  };
  return colour(a) * colour(b) < 0;
}

Lattice::Lattice(int width, int height)
    : across_(width / cell_size + 1),
      down_(height / cell_size + 1),
      first_(static_cast<std::size_t>(across_) * down_, -1) {}

int& Lattice::first_near(const Eigen::Vector2d& position) {
  const int u = std::clamp(static_cast<int>(position.x()) / cell_size, 0, across_ - 1);
  const int v = std::clamp(static_cast<int>(position.y()) / cell_size, 0, down_ - 1);
  return first_[static_cast<std::size_t>(v * across_ + u)];
}

void Lattice::add(const FittedSaddle& suspect) {
  int& first = first_near(suspect.position);
  next_.push_back(first), first = size();
  nodes_.push_back(make_node(suspect));
}

void Lattice::replace(int number, const FittedSaddle& suspect) {
  int* link = &first_near(nodes_[number].position);
  while (*link != number) link = &next_[*link];
  *link = next_[number];
  int& first = first_near(suspect.position);
  next_[number] = first, first = number;
  nodes_[number] = make_node(suspect);
}

template <class Act>
void Lattice::each_near(const Eigen::Vector2d& position, double reach, const Act& act) const {
  const auto cell = [&](double at, int cells) {
    return std::clamp(static_cast<int>(std::max(at, 0.0)) / cell_size, 0, cells - 1);
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

bool Lattice::light_changes_at(const PredictedCorner& predicted) const {
  const Node& witness = nodes_[predicted.witness];
  const Eigen::Vector2d step = predicted.position - witness.position, beyond = predicted.position + step;
  const double reach = most_aside_share * step.norm(), here = std::abs(witness.half_contrast);
  bool changes = false;
  each_near(beyond, reach, [&](int n) {
    const double there = std::abs(nodes_[n].half_contrast);
    const bool differs = there > least_shadow * here || here > least_shadow * there;
    changes |= differs && (nodes_[n].position - beyond).squaredNorm() < reach * reach;
  });
  return changes;
}

CornerModel Lattice::expected(const PredictedCorner& predicted) const {
  const Node& witness = nodes_[predicted.witness];
  CornerModel model;
  model.position = predicted.position, model.edges = witness.edges, model.blur = witness.blur;
  model.level = witness.level, model.half_contrast = -witness.half_contrast;
  return model;
}

bool Lattice::suits(int number, const FittedSaddle& suspect) const {
  return are_of_one_board(nodes_[number], make_node(suspect));
}

bool Lattice::may_suit(int number, const FittedSaddle& seen) const {
  return edges_go_on(nodes_[number], make_node(seen));
}

Lattice::Nearest Lattice::nearest_within(int number, double reach) const {
  const Node& here = nodes_[number];
  Nearest nearest{{-1, -1, -1, -1}, {reach, reach, reach, reach}};
  each_near(here.position, reach, [&](int n) {
    const Eigen::Vector2d off = nodes_[n].position - here.position;
    if (off.squaredNorm() > reach * reach) return;
    for (int edge = 0; edge < 2; ++edge) {
      const double along = here.along[edge].dot(off), distance = std::abs(along);
      const int place = 2 * edge + (along < 0);
      if (!(distance > least_spacing && distance < nearest.distances[place])) continue;
      if (std::abs(cross(here.along[edge], off)) > most_aside(distance)) continue;
      if (are_of_one_board(here, nodes_[n])) nearest.distances[place] = distance, nearest.numbers[place] = n;
    }
  });
  return nearest;
}

std::array<int, 4> Lattice::neighbours(int number) const {
  const Nearest nearest = nearest_within(number, usual_reach);
  const auto& distances = nearest.distances;
  const bool are_all = *std::max_element(distances.begin(), distances.end()) < sure_share * usual_reach;
  return are_all ? nearest.numbers : nearest_within(number, reach_px).numbers;
}

std::optional<Eigen::Vector2d> Lattice::step_beside(int number, int place, const std::array<int, 4>& near) const {
  const Eigen::Vector2d along = (place % 2 == 0 ? 1 : -1) * nodes_[number].along[place / 2];
  for (const int beside : {near[place ^ 2], near[place ^ 3]}) {
    if (beside < 0) continue;
    const Eigen::Vector2d aside = nodes_[beside].position - nodes_[number].position;
    for (const int next : neighbours(beside)) {
      if (next < 0) continue;
      const Eigen::Vector2d step = nodes_[next].position - nodes_[beside].position;
      if (along.dot(step) > straight * step.norm() && step.norm() < most_unequal * aside.norm()) return step;
    }
  }
  return std::nullopt;
}

std::vector<PredictedCorner> Lattice::predicted_by(int number) const {
  const Node& here = nodes_[number];
  std::vector<PredictedCorner> all;
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
        near[place] >= 0 && (nodes_[near[place]].position - here.position).norm() < next_but_two * step->norm();
    if (!is_there) all.push_back({here.position + *step, step->norm(), number, here.blur});
  }
  return all;
}

}  // namespace handsight
