// SPDX-License-Identifier: Apache-2.0
// How the tags of a board stand to each other, without knowing the board.
#pragma once

#include <optional>
#include <vector>

#include "targets/tag_survey.h"

namespace handsight {

/// A tag by its place in the board's rows and columns, from any of them; x to the tags' right, y down.
struct LatticeTag {
  int id = 0, x = 0, y = 0;
};

struct TagLattice {
  bool is_checkered = false;  // each second place of the lattice has a tag, as on a ChArUco board
  double pitch = 0;           // from place to place, in sides of a tag
  std::vector<LatticeTag> tags;
};

/// The largest lattice that the tags form; nothing where fewer than three do.
std::optional<TagLattice> tag_lattice(const std::vector<SurveyedTag>& tags);

}  // namespace handsight
