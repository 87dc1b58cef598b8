// SPDX-License-Identifier: Apache-2.0
// The models of cameras, each in a place of its own: what its numbers are, how it projects, and how that changes.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "camera/camera.h"

namespace handsight {

/// One number of a model: unit "px" or "1", and how much it may well differ from what is written on the camera (a
/// share of the focal length for the focal lengths, 1 for the others).
struct LensNumber {
  std::string_view name, unit;
  double prior_sigma_of = 1;
};

/// An image point with its derivatives: by the point in the camera's frame (px/m) and by the model's numbers.
struct LensProjection {
  Vector2 pixel = Vector2::Zero();
  Matrix23 by_point = Matrix23::Zero();
  Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor, 2, 16> by_numbers;
};

/// A model. Its first four numbers are fx fy cx cy; all distortion is 0 where the others are.
struct LensModel {
  std::string_view name, title;
  std::span<const LensNumber> numbers;
  /// Image point of a point in the camera's frame; defined for z > 0 and, for models of wide lenses, beyond.
  void (*project)(std::span<const double> numbers, const Vector3& x_in_camera, LensProjection& projection);
  /// Does the lens see the point, and does the distortion not fold there?
  bool (*sees)(std::span<const double> numbers, const Vector3& x_in_camera);
};

/// All models; brown first. A new one is a file of its own and a line here.
std::span<const LensModel* const> lens_models();

/// By name; null where there is none.
const LensModel* find_lens_model(std::string_view name);

/// A camera of any model.
struct Lens {
  const LensModel* model = nullptr;
  int width = 0, height = 0;
  std::vector<double> numbers;
};

Vector2 project(const Lens& lens, const Vector3& x_in_camera);

/// Direction (of length 1, in the camera's frame) of an image point: the model undone by Newton's method to 1e-10 px.
/// Nothing where it cannot be undone.
std::optional<Vector3> lift(const Lens& lens, const Vector2& pixel);

/// The same camera as the struct that the rest of the program uses; nothing where the model has terms that it lacks.
std::optional<Camera> look_up_camera(const Lens& lens);
Lens make_lens(const Camera& camera);  // skew is not among a lens's numbers and is left out

extern const LensModel brown_lens;     // fx fy cx cy k1 k2 p1 p2 k3
extern const LensModel rational_lens;  // the same, k4 k5 k6
extern const LensModel fisheye_lens;   // fx fy cx cy k1 k2 k3 k4

}  // namespace handsight
