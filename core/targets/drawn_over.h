// SPDX-License-Identifier: Apache-2.0
// Was something drawn into an image before it was saved?
#pragma once

#include "vision/image/image.h"

namespace handsight {

/// Lines and numbers in pure colours (blue, green, red, ...) leave many pixels of exactly one grey level where a camera
/// leaves a few of each: two such colours, or one very often. Not seen where the image was compressed afterwards.
bool is_drawn_over(const Image& image);

}  // namespace handsight
