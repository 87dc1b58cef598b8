// SPDX-License-Identifier: Apache-2.0
// How likely it is that a saddle of the image is a corner: by its own fit, and by the saddles round it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "vision/corners/corner_candidates.h"
#include "vision/corners/corner_shape.h"

namespace handsight {

/// What tells a corner from texture, in this order: 1; px, radius of the disc on which the fit holds; px, its blur; log
/// of the position's sigma in px; log of the residual beyond the image's noise in half contrasts; log of the sine
/// between its edges.
using CornerSigns = std::array<double, 6>;

/// `image_noise`: grey levels, sigma of a pixel.
CornerSigns find_signs(const CornerFit& fit, double image_noise);

/// Log-odds that what was fitted is a corner and not a piece of texture, were no other saddle near: the signs weighed
/// by logistic regression on rendered markers, boards and texture (tests/trials/trial_corner_odds), but for the sine
/// and, with it, the constant: those by false corners on photographs, things and texture and by small real boards.
double corner_log_odds(const CornerSigns& signs);

/// The saddles of an image, by where they are, each with the probability that it is a corner: 0 at first.
class SaddleField {
 public:
  /// Stationary ones only; the others are points of an edge's end as often as not. px.
  SaddleField(int width, int height, const std::vector<CornerCandidate>& candidates);

  /// By how many more of the saddles within 40 px of `candidate` and at least half as steep, itself left out, are no
  /// corners than are, as far as is known.
  double others(const CornerCandidate& candidate) const;
  /// Numbers of some saddles, few enough to need no memory of their own.
  struct Few {
    std::array<int, 8> numbers;
    std::size_t count = 0;
    operator std::span<const int>() const { return {numbers.data(), count}; }
  };
  /// The saddles that are the one at `position` (px).
  Few at(const Eigen::Vector2d& position) const;
  /// Whether a saddle is within `distance` px, 40 at most.
  bool has_near(const Eigen::Vector2d& position, double distance) const;
  void set_probability(std::span<const int> numbers, double probability);
  /// How many of the saddles with these numbers `others` counts.
  int counted(std::span<const int> numbers, const CornerCandidate& candidate) const;
  int size() const { return first_.back(); }

 private:
  // Calls act(begin, end) for each row of cells that lie within `reach` px, 40 at most.
  template <class Act>
  void each_row_round(const Eigen::Vector2d& position, double reach, const Act& act) const;

  int across_, down_;                        // cells of 40 px
  std::vector<int> first_;                   // of each cell's saddles; one more at the end
  std::vector<float> u_, v_, depth_, says_;  // cell by cell; 1 - 2 probability
};

/// A saddle that was fitted.
struct FittedSaddle {
  CornerCandidate candidate;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // px
  std::array<double, 2> edges{};                       // rad
  double half_contrast = 0;                            // grey levels
  double own = 0, log_odds = 0;                        // alone, and among the others
  double blur = 0;                                     // px
  double level = 0;                                    // grey levels
};

/// Whether a saddle is of a board, 0 to 1: by how many others within 40 px have edges along its own and half or twice
/// its contrast at most. Up to 8 say nothing, as grain may lie along one direction too; 14 say all.
std::vector<double> board_signs(const std::vector<FittedSaddle>& suspects);

/// Log-odds of a saddle whose own are `own`, given those round it (SaddleField::others, of which -2 to 4 tell
/// something; board_signs): texture makes saddles in crowds, and of these few are corners; on a board all are.
double log_odds_among(double own, double others, double board = 0);

/// Each saddle counts by how likely it is a corner, and this depends on the others: some rounds settle it.
void weigh(std::vector<FittedSaddle>& suspects, SaddleField& field);

/// What is reported has more.
constexpr double least_log_odds = -2.9;

}  // namespace handsight
