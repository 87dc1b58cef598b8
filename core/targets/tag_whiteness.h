// SPDX-License-Identifier: Apache-2.0
// How white a tag looks at a place once the lens has blurred it.
#pragma once

#include "geometry/rigid.h"
#include "print/dictionary.h"

namespace handsight {

/// From 0 to 1, with its changes by the place (per module).
struct Whiteness {
  double value = 1, by_x = 0, by_y = 0;
};

/// At a place of the tag (modules from its top left corner) with the blur's sigmas along its axes, in modules. Blur
/// that is round in the image is oblong and askew in the tag's coordinates: `correlation`. The integral of the askew
/// normal density over modules is that of the upright one and Mehler's series of products.
Whiteness whiteness(const TagPattern& pattern, const Vector2& place, double sigma_x, double sigma_y,
                    double correlation);

}  // namespace handsight
