// SPDX-License-Identifier: Apache-2.0
// What a bundle adds up, as Ceres asks for it.
#pragma once

#include <ceres/ceres.h>

#include <array>
#include <memory>

#include "camera_calibration/bundle_parts.h"

namespace handsight {

/// A motion as Ceres sees it: translation, rotation vector.
using Six = std::array<double, 6>;
Six make_six(const Rigid& motion);
Rigid make_rigid(const double* six);

/// What the last block of an image's cost is: nothing, the bend of the board, or the place of its one point.
enum class ShapeBlock { none, bend, point };

/// Some points of one image: residuals in px, each point by its own weight, by the lens's numbers, the target's pose,
/// the camera's placement (but for the first camera) and the target's shape.
std::unique_ptr<ceres::CostFunction> image_cost(const BoardImages& images, int camera, const LensModel& model,
                                                std::vector<TargetPixel> points, std::vector<double> weights,
                                                ShapeBlock shape);

/// weight * (the point's place - where it is described), by the point's place.
std::unique_ptr<ceres::CostFunction> place_cost(const Vector3& described, const Vector3& weight);

}  // namespace handsight
