// SPDX-License-Identifier: Apache-2.0
// X-corners numbered by column and row, neighbour by neighbour, so that the lattice bends as the lens does.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "geometry/rigid.h"
#include "vision/corners/corner_options.h"
#include "vision/image/image.h"

namespace handsight {

struct LatticeCell {
  int column = 0, row = 0;
  auto operator<=>(const LatticeCell&) const = default;  // NOLINT(modernize-use-nullptr): not of the code
};

/// Numbers of corners by their place, right-handed as the image shows it (x right, y down).
using CornerLattice = std::map<LatticeCell, std::size_t>;

struct LatticeExtent {
  LatticeCell least{1 << 20, 1 << 20}, most{-(1 << 20), -(1 << 20)};
  int columns() const { return most.column - least.column + 1; }
  int rows() const { return most.row - least.row + 1; }
};
LatticeExtent find_extent(const CornerLattice& lattice);

/// All lattices of at least `least` corners, the largest first; each corner is in one at most.
std::vector<CornerLattice> corner_lattices(const Image& image, const std::vector<Corner>& corners, std::size_t least);

/// Pixels by their place in a lattice.
using LatticePixels = std::map<LatticeCell, Vector2>;

/// What the places around one (itself left out) say of it.
struct LatticeGuess {
  Vector2 pixel = Vector2::Zero();                  // px
  Eigen::Matrix2d slope = Eigen::Matrix2d::Zero();  // px by column and row
  bool is_between = false;                          // neighbours on both sides along columns and rows
};

/// By the nearest places, with a surface of second order where there are enough of them; nothing where fewer than four
/// are within four steps.
std::optional<LatticeGuess> guess_pixel(const LatticePixels& pixels, const LatticeCell& cell);

}  // namespace handsight
