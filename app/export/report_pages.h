// SPDX-License-Identifier: GPL-3.0-or-later
// Where the pictures of a report stand on pages of paper, so that none leaves half of a page empty.
#pragma once

#include <vector>

namespace handsight::app {

struct PlacedPicture {
  int index = 0;     // into the heights
  double scale = 1;  // smaller than 1: drawn smaller, to fit where it is
};

/// An order of pictures of these heights (captions included) on pages of that height; of the first one so much is free.
/// The first picture stays first. A page is filled with the next picture that fits, else with the next one drawn
/// smaller, by three fifths at most.
std::vector<PlacedPicture> placed_pictures(const std::vector<double>& heights, double page, double free_of_first);

}  // namespace handsight::app
