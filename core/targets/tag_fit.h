// SPDX-License-Identifier: Apache-2.0
// Where a tag's corners are: the whole tag as it should look, blurred and lit, laid over the image by least squares.
#pragma once

#include <array>
#include <optional>

#include "print/dictionary.h"
#include "targets/quads.h"

namespace handsight {

struct TagFit {
  Quad corners;                                // px
  std::array<Eigen::Matrix2d, 4> covariances;  // px^2
  double blur = 1;                             // px, sigma, of lens and pixel together
  double contrast = 0;                         // grey levels between white and black
  double unexplained = 0;                      // share of the tag's own variance that neither tag nor noise explains
};

struct TagFitOptions {
  /// modules around the tag that are white. The corners' surroundings are left out where other black touches them.
  double quiet_zone = 0.5;
  bool corners_touch = false;
};

/// Least squares of I(p) = level + contrast w(h^-1 p): h carries the tag's square to its four corners, which are the
/// unknowns beside level, contrast and blur; w is the whiteness of the tag's modules, blurred across each edge as the
/// lens does it (exactly so along edges, nearly where they meet). Every edge of the tag takes part, so that the corners
/// are known several times better than from the four lines of its outline. For tags of more than 48 px a side each
/// corner is then fitted in its own surroundings, so that a lens that bends lines does not matter. Nothing where the
/// fit runs away by more than 0.7 modules from the start, leaves the image, or is no such tag (what is left
/// unexplained is more than 0.12 of what a corner is recognised by, or 0.25 of a large tag).
/// `image_noise`: grey levels, sigma of a pixel.
std::optional<TagFit> fit_tag(const Image& image, const TagPattern& pattern, const Quad& start, double image_noise,
                              const TagFitOptions& options = {});

}  // namespace handsight
