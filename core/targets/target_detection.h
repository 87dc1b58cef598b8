// SPDX-License-Identifier: Apache-2.0
// A target in an image: its points by number.
#pragma once

#include "targets/found_target.h"
#include "vision/image/image.h"

namespace handsight {

/// Works out what the detection of a target needs.
PreparedTarget prepare(const Target& target);

/// Partly seen boards count, as soon as two of their tags agree; a chessboard must be whole. X-corners are refined by
/// the project's own detector, other corners of tags by `fit_tag`. A chessboard that looks the same turned by half a
/// turn is numbered so that its rows run to the right in the image.
TargetSighting detect_target(const Image& image, const PreparedTarget& target);

}  // namespace handsight
