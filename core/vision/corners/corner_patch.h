// SPDX-License-Identifier: Apache-2.0
// The pixels round a corner beside what the model of corner_shape.h says of them: the inner loop of its fit.
#pragma once

#include <Eigen/Core>
#include <array>

#include "vision/corners/corner_shape.h"
#include "vision/image/image.h"

namespace handsight {

// What is known of every corner beforehand, with a shadow's edge beside it or not.
constexpr double shade_sigma = 0.003;  // 1/px: light that changes by 30 % over 100 px is no surprise
constexpr double least_noise = 0.3;    // grey levels: rounding to whole ones alone makes 0.29

constexpr int most_patch_radius = 10;   // px
constexpr int most_patch_pixels = 464;  // in a disc of most_patch_radius + 2, in whole groups

/// A disc of pixels, nearest first, with residuals and derivatives, all times the weight. Odd parameters (position,
/// shade) and even ones (edges, blur, level, half contrast) have derivatives of opposite parity, so over a disc round
/// the corner their products vanish and the normal equations fall into two blocks.
struct CornerPatch {
  using Row = std::array<float, most_patch_pixels>;
  Eigen::Vector2i centre{0, 0};  // px, the central pixel
  int gathered = -1;             // px, radius of the disc whose pixels are there
  int count = 0;                 // pixels that take part
  int padded = 0;                // pixels in whole groups; those beyond `count` have no weight
  bool is_clipped = false;       // some may be as bright or as dark as the sensor tells
  alignas(64) Row value, weight, residual;
  alignas(64) std::array<Row, 4> odd;     // by position u, v; shade u, v
  alignas(64) std::array<Row, 5> even;    // by edge 1, edge 2, blur, level, half contrast
  alignas(64) std::array<Row, 4> shadow;  // by direction, distance, depth, softness, where the model has a shadow
};

/// Pixels in the disc of `radius` px, 1 to most_patch_radius + 2; its four outermost ones do not belong to it.
int pixels_in_disc(int radius);

/// The pixel that a position (px) lies in; whether the disc of `radius` px round one is inside of the image.
inline Eigen::Vector2i nearest_pixel(const Eigen::Vector2d& position) {
  return (position.array() + 0.5).floor().cast<int>();
}
inline bool is_inside(const Image& image, const Eigen::Vector2i& centre, int radius) {
  return centre.x() >= radius && centre.y() >= radius && centre.x() + radius < image.width &&
         centre.y() + radius < image.height;
}

/// px from the central pixel, of the pixel with this number.
Eigen::Vector2i offset_of_pixel(int number);

/// px from the central pixel, of all pixels in their order; beyond the last one very far.
const float* pixel_columns();
const float* pixel_rows();

/// Makes the disc of `radius` px take part, which must be inside of the image; reads only what is not there yet,
/// so that one patch serves one image only.
void gather(const Image& image, const Eigen::Vector2i& centre, int radius, CornerPatch& patch);

/// What a shadow's edge shares with the corner's own may be left out for a first look, in a third of the time.
enum class Sharing { all, of_corner };

/// Residuals and derivatives of the pixels from number `begin` (a multiple of 16) on, up to `end`. The weight is 1 in
/// the disc of `radius` px and falls to 0 at radius + 1/2: a hard rim would jump as the position moves. A shadow's edge
/// stays where it is as the position moves. How the angles and widths change what edges share beside it is left out of
/// the derivatives.
void evaluate(const CornerModel& model, double radius, int begin, int end, CornerPatch& patch,
              Sharing sharing = Sharing::all);

/// The residuals and the derivatives by the half contrast alone; others may be overwritten or not.
void evaluate_residuals(const CornerModel& model, double radius, int begin, int end, CornerPatch& patch);

/// Sums over the patch; the lower triangle of each block only.
struct PatchSums {
  std::array<float, 10> odd;  // products of the odd derivatives, row by row of the triangle
  std::array<float, 15> even;
  std::array<float, 4> odd_side;  // with the residual
  std::array<float, 5> even_side;
  float squares = 0, weights = 0;  // of the residual; of the weight's square
};
PatchSums sums(const CornerPatch& patch);

/// Sum of the squared weights.
float squared_weights(const CornerPatch& patch);

/// PatchSums::odd alone.
std::array<float, 10> odd_sums(const CornerPatch& patch);

}  // namespace handsight
