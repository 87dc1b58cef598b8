// SPDX-License-Identifier: Apache-2.0
// Maps from a plane to the image: homographies, alone and with a lens that bends straight lines.
#pragma once

#include <optional>
#include <vector>

#include "targets/quads.h"

namespace handsight {

/// x in px of a place of the plane: (h x) / its third number.
inline Vector2 mapped(const Matrix3& homography, const Vector2& place) {
  return (homography * place.homogeneous()).hnormalized();
}

/// The homography that carries the square (0, 0), (side, 0), (side, side), (0, side) to the quad's corners. Singular
/// where three corners lie on a line.
Matrix3 homography_from_quad(const Quad& quad, double side);

/// A place of the plane and where the image shows it.
struct PlacePixel {
  Vector2 place, pixel;
};

/// The homography with the least algebraic error (Hartley's) to at least four pairs; places of the first pair's side
/// have a positive third number. Nothing where the points leave more than one answer.
std::optional<Matrix3> linear_homography(const std::vector<PlacePixel>& points);

/// A homography followed by a radial distortion about the image's centre: enough for the points of a board to be
/// distinguished from their neighbours, not to calibrate with.
struct PlaneMap {
  Matrix3 homography = Matrix3::Identity();  // to px from the centre, in units of `scale`
  double k1 = 0, k2 = 0;
  Vector2 centre = Vector2::Zero();  // px
  double scale = 1;                  // px
};

/// Where the image shows a place; nothing behind the camera, and where the distortion would fold the image.
std::optional<Vector2> mapped(const PlaneMap& map, const Vector2& place);

/// px by m: how the image moves with the place, by differences of `step`. Nothing where `mapped` has nothing.
std::optional<Eigen::Matrix2d> mapped_slope(const PlaneMap& map, const Vector2& place, double step);

/// The map with the least robust (Cauchy) distances to at least four points in an image of this size; distortion is
/// estimated from 12 points on, with little belief in much of it. Nothing where the points lie on a line.
std::optional<PlaneMap> fit_plane_map(const std::vector<PlacePixel>& points, int width, int height);

}  // namespace handsight
