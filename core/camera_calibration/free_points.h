// SPDX-License-Identifier: Apache-2.0
// How firmly the points of a target are held to where they are described while they are estimated.
#pragma once

#include "camera_calibration/bundle_parts.h"

namespace handsight {

/// 1/m a coordinate, by number: the weights of place_cost. Points known within a sigma are all held by it. Points that
/// may be anywhere are held by what poses cannot tell from poses alone: of each piece two far points stay where they
/// are described and a third stays at its height, and the others are drawn to their places so weakly that only what no
/// image shows is settled by it.
std::vector<Vector3> place_weights(const BoardImages& images, const BundleOptions& options);

/// The points and poses moved and scaled together so that the points as a whole lie as they are described, in place and
/// size. Nothing in the images changes by it. Of targets of several pieces, and of points known within a sigma, only
/// the places are moved, not scaled.
void lay_on_description(const BoardImages& images, BundleResult& result);

}  // namespace handsight
