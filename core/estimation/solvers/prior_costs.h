// SPDX-License-Identifier: Apache-2.0
// Everything that is known beside the sightings, as residuals of Ceres.
#pragma once

#include "estimation/solvers/tried_place.h"

namespace handsight {

/// What is known of the distances of mounts and of their places.
void add_mount_priors(TriedPlace& place, ceres::Problem& squares);

/// The priors of effects, of the cameras by their images, of the robot's size and of the markers' shape.
void add_priors(TriedPlace& place, ceres::Problem& squares);

}  // namespace handsight
