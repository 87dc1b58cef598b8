// SPDX-License-Identifier: Apache-2.0
// Boards predict their own missing corners: on the other side of a corner from one neighbour there is another, with
// the colours the other way round.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "vision/corners/corner_likelihood.h"

namespace handsight {

/// Where a corner should be.
struct PredictedCorner {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // px
  double spacing = 0;                                  // px, to the corner that predicts it
  int witness = 0;                                     // number of that corner
  double blur = 0;                                     // px, of that corner
};

/// Corners by where they are, and which are neighbours on a board.
class Lattice {
 public:
  Lattice(int width, int height);
  /// Corners have numbers in the order in which they come.
  void add(const FittedSaddle& suspect);
  /// What lies elsewhere after all.
  void replace(int number, const FittedSaddle& suspect);
  int size() const { return static_cast<int>(nodes_.size()); }
  const Eigen::Vector2d& position(int number) const { return nodes_[number].position; }

  /// Numbers of the neighbours: along the first edge forwards and backwards, then along the second; -1 where none is
  /// within 64 px, has edges along the same directions, a like contrast and the opposite colours.
  std::array<int, 4> neighbours(int number) const;
  /// What the neighbours of this corner predict of those that it lacks: on the other side of one, or, where both are
  /// lacking, as far away as a neighbour's neighbour beside.
  std::vector<PredictedCorner> predicted_by(int number) const;
  /// Whether the corner beyond a predicted one stands in another light than its witness: a shadow's edge lies between.
  bool light_changes_at(const PredictedCorner& predicted) const;
  /// What a predicted corner looks like, if it is what its witness is.
  CornerModel expected(const PredictedCorner& predicted) const;
  /// Whether a suspect may be a neighbour of this corner, wherever it is.
  bool suits(int number, const FittedSaddle& suspect) const;
  /// The same of what circles show of it, whose contrast glare and blur change: by edges and colours alone.
  bool may_suit(int number, const FittedSaddle& seen) const;
  /// Whether a corner is within `distance` px.
  bool has_near(const Eigen::Vector2d& position, double distance) const;
  /// The nearest of these; -1 where there is none.
  int nearest(const Eigen::Vector2d& position, double distance) const;

 private:
  struct Node {
    Eigen::Vector2d position;
    std::array<Eigen::Vector2d, 2> along;  // the edges
    std::array<double, 2> edges;           // rad
    double level, half_contrast, blur;
  };
  static Node make_node(const FittedSaddle& suspect);
  int& first_near(const Eigen::Vector2d& position);  // of the cell's corners
  static bool are_of_one_board(const Node& a, const Node& b);
  static bool edges_go_on(const Node& a, const Node& b);
  // px, to the neighbour at this place, by a neighbour across that has one there.
  std::optional<Eigen::Vector2d> step_beside(int number, int place, const std::array<int, 4>& near) const;
  struct Nearest {
    std::array<int, 4> numbers;
    std::array<double, 4> distances;  // px, along the edge
  };
  Nearest nearest_within(int number, double reach) const;
  template <class Act>
  void each_near(const Eigen::Vector2d& position, double reach, const Act& act) const;

  int across_, down_;
  std::vector<int> first_, next_;  // by cell of 32 px; by corner
  std::vector<Node> nodes_;
};

}  // namespace handsight
