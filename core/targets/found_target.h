// SPDX-License-Identifier: Apache-2.0
// A target as its detection needs it, and what was found of it in an image.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "base/message.h"
#include "print/target.h"
#include "targets/tag_reading.h"

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
  Message reason;                   // why there are no points; empty where there are
  std::vector<int> repeated;        // numbers of single tags that are there several times, which are left out
};

/// A target with what its detection needs of it, worked out once.
struct PreparedTarget {
  Target target;
  std::vector<TargetPoint> points;
  std::vector<PlacedTag> tags;
  std::map<int, std::vector<TagPattern>> patterns;  // by the border's width in modules: one for each of `tags`
  std::map<int, TagReader> readers;                 // the same; a grid is looked for with 1 and with 2
};

}  // namespace handsight
