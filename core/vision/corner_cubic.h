// SPDX-License-Identifier: Apache-2.0
// Does the image need a corner? Saddles of smooth texture look much like blurred corners, but a cubic polynomial, which
// knows of no edges and no plateaus, tells as much of them.
#pragma once

#include "vision/corner_model.h"
#include "vision/corner_patch.h"

namespace handsight {

/// The sum of squares that the best cubic polynomial of (u, v), 10 coefficients, leaves in the disc of `radius` px (4
/// to kMostPatchRadius) round the pixel of the model's position, over the sum that the model leaves: about 1 on smooth
/// texture, 10 and more on most corners. The disc must be inside of the image. `patch` is a workspace: empty, or filled
/// from the same image.
double cubic_over_model(const Image& image, const CornerModel& model, int radius, CornerPatch& patch);

}  // namespace handsight
