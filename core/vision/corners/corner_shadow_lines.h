// SPDX-License-Identifier: Apache-2.0
// Where shadows' edges run across an image, as the corners tell that were fitted beside them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vision/corners/corner_shape.h"

namespace handsight {

/// A shadow's edge that should run near a place.
struct NearShadow {
  ShadowEdge edge;          // as seen from there
  bool is_certain = false;  // several corners agree on it
};

class ShadowLines {
 public:
  /// A corner that was fitted beside a shadow's edge.
  void add(const CornerModel& beside);
  int size() const { return static_cast<int>(seen_.size()); }

  /// The edges that may run near `position` (px), as seen from there, the likelier first: that on which several corners
  /// nearest to it agree, then that which the nearest saw, if it is another. Those more than `farthest` px away are
  /// left out, and all where none of those that were added after the first `since` is near enough to tell anything.
  std::vector<NearShadow> near(const Eigen::Vector2d& position, double farthest, int since = 0) const;

 private:
  struct Seen {
    ShadowEdge edge;             // from where it was seen
    Eigen::Vector2d from, foot;  // px, from where, and the nearest point of the edge
    Eigen::Vector2d normal;      // from the corner to the edge
    int agree = 0;               // others that saw the same
  };
  static bool agree(const Seen& a, const Seen& b);
  // The edge that `one` saw and those that agree with it, as it runs near the position.
  ShadowEdge edge_at(const Eigen::Vector2d& position, const Seen& one) const;

  std::vector<Seen> seen_;
};

}  // namespace handsight
