// SPDX-License-Identifier: Apache-2.0
// How rough pixels are: what noise an image has, and whether its colours were interpolated.
#pragma once

#include <Eigen/Core>

#include "vision/image/image.h"

namespace handsight {

/// Grey levels, sigma of the white noise of a pixel: the upper quartile over about so many places of what is left
/// after planes and straight steps along rows and columns, by the mask 1 -2 1, -2 4 -2, 1 -2 1 (Immerkaer, Fast noise
/// variance estimation, 1996). Texture makes it too large, never too small. 0 where the image is below 3 x 3 px.
double image_noise(const Image& image, int places = 4000);

/// Of a colour filter every other pixel is a measured green one: what is interpolated is the smoother. Log of how much
/// rougher the pixels of which u + v is even are than the others, within `reach` px across and down.
double measure_chequer(const Image& image, const Eigen::Vector2i& centre, int reach);

}  // namespace handsight
