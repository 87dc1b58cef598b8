// SPDX-License-Identifier: Apache-2.0
// A target in an image: its points by number.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "print/target.h"
#include "targets/tag_reading.h"
#include "vision/image/image.h"

namespace handsight {

/// A point of the target as the image shows it.
struct TargetPixel {
  int number = 0;              // of `target_points`
  Vector2 pixel;               // px
  Eigen::Matrix2d covariance;  // px^2
};

/// What was found. A wrong number is worse than none: what does not agree with the rest is left out and counted.
struct TargetSighting {
  std::vector<TargetPixel> points;  // by number, ascending
  int dropped_points = 0;           // far from where the plane of the others has them, or not of their shape
  int dropped_tags = 0;             // read, but not where the other tags of the board have them, or twice
  std::string reason;               // why there are no points; empty where there are
};

/// A target with what its detection needs of it, worked out once.
struct PreparedTarget {
  Target target;
  std::vector<TargetPoint> points;
  std::vector<PlacedTag> tags;
  std::map<int, std::vector<TagPattern>> patterns;  // by the border's width in modules: one for each of `tags`
  std::map<int, TagReader> readers;                 // the same; a grid is looked for with 1 and with 2
};
PreparedTarget prepare(const Target& target);

/// Partly seen boards count, as soon as two of their tags agree; a chessboard must be whole. X-corners are refined by
/// the project's own detector, other corners of tags by `fit_tag`. A chessboard that looks the same turned by half a
/// turn is numbered so that its rows run to the right in the image.
TargetSighting detect_target(const Image& image, const PreparedTarget& target);

}  // namespace handsight
