// SPDX-License-Identifier: Apache-2.0
// Dark quadrilaterals of an image: what may be the black square of a tag.
#pragma once

#include <array>
#include <vector>

#include "geometry/rigid.h"
#include "vision/image/image.h"

namespace handsight {

/// Corners in px, clockwise as the image shows them, good to about a pixel.
using Quad = std::array<Vector2, 4>;

/// The dark quadrilaterals with sides of at least `least_side` px; the same one may come several times, from several
/// thresholds. Contours after thresholds against the mean of windows of several sizes, as the detectors of ArUco do it;
/// some of the thresholds are below the middle of black and white, which parts tags that touch at their corners.
std::vector<Quad> find_quads(const Image& image, double least_side);

/// The same in the image made smaller by a whole factor: good to about as many pixels, and with sides of `least_side`
/// pixels of the small one.
std::vector<Quad> find_quads_in_small(const Image& image, int factor, double least_side);

}  // namespace handsight
