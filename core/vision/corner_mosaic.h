// SPDX-License-Identifier: Apache-2.0
// Images whose colours a sensor saw one a pixel: what was interpolated moves edges to and fro from pixel to pixel.
#pragma once

#include <optional>

#include "vision/corner_model.h"
#include "vision/image.h"

namespace handsight {

/// By how much the detail at pixels of even row plus column differs from that at the others, as a ratio of 1 or more:
/// interpolated pixels have less. Over some thousand places; 1 where the image is below 4 x 4 px.
double mosaic_ratio(const Image& image);

/// Above it colours were interpolated, bilinearly; edge-aware demosaicing leaves 1.07 and more, which is not always
/// told from chance.
constexpr double kLeastMosaicRatio = 1.1;

/// A part of an image, and where its top left pixel lies in the whole.
struct Part {
  Image image;
  Eigen::Vector2i origin{0, 0};
};

/// The pixels within `reach` px of one, smoothed by the mask 1 2 1, 2 4 2, 1 2 1, which takes away what has a period of
/// two pixels. Nothing where one of them or a neighbour leaves the image.
std::optional<Part> smoothed_part(const Image& image, const Eigen::Vector2i& centre, int reach);

}  // namespace handsight
