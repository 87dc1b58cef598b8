// SPDX-License-Identifier: Apache-2.0
// What is black on a target: for printing, for simulated images, and for comparing images with what should be there.
#pragma once

#include <vector>

#include "print/dictionary.h"
#include "print/target.h"

namespace handsight {

/// A rectangle on the sheet, m, in the frame of its piece.
struct Box {
  Vector2 top_left = Vector2::Zero(), size = Vector2::Zero();
};

/// What is printed of one piece: boxes that do not overlap, and the smallest box that holds them all.
struct PrintedPattern {
  std::vector<Box> black;
  Box outline;
};

/// The pattern of a piece (0 but for single tags). The sheet around and between the boxes is white.
PrintedPattern pattern_of(const Target& target, int piece = 0);

/// Is the sheet black at a place of the piece's frame, m? Made once of a target and asked of millions of places.
class BlackAt {
 public:
  explicit BlackAt(const Target& target, int piece = 0);
  bool operator()(double x, double y) const;

 private:
  bool tag_is_black(std::size_t tag, double x, double y) const;
  bool square_is_black(double x, double y) const;
  bool circle_is_black(double x, double y) const;
  bool grid_is_black(double x, double y) const;

  Target target_;
  std::vector<PlacedTag> tags_;
  std::vector<TagPattern> patterns_;
  std::vector<int> tag_of_cell_;  // ChArUco: by square; -1: none
};

}  // namespace handsight
