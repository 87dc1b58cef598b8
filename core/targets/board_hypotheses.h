// SPDX-License-Identifier: Apache-2.0
// Which boards have their tags' numbers where a lattice of tags has them.
#pragma once

#include <optional>

#include "print/target.h"
#include "targets/tag_lattice.h"

namespace handsight {

/// The ChArUco board, Kalibr's grid or OpenCV's grid (of kind tags, to be laid out by lay_out_grid once its
/// lengths are known) that has these tags where they stand, as near to what was described as they allow: its
/// columns and rows, its first tag, its layout. Sizes and dictionary are those of `described`. Nothing where most of
/// the tags fit no board.
std::optional<Target> board_with(const TagLattice& lattice, const Target& described);

}  // namespace handsight
