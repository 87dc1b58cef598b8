// SPDX-License-Identifier: Apache-2.0
// The camera model of docs/conventions.md: pinhole with skew, radial k1 k2 k3 and tangential p1 p2 as in OpenCV, its
// rational terms k4 k5 k6, or OpenCV's fisheye.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>

#include "geometry/rigid.h"

namespace handsight {

using Matrix23 = Eigen::Matrix<double, 2, 3>;

/// One camera: x right, y down, z forward. x' = x/z, y' = y/z, r2 = x'^2 + y'^2,
/// xd = x' (1 + k1 r2 + k2 r2^2 + k3 r2^3) + 2 p1 x' y' + p2 (r2 + 2 x'^2),
/// yd = y' (1 + ...) + p1 (r2 + 2 y'^2) + 2 p2 x' y'; u = fx xd + skew yd + cx, v = fy yd + cy (thesis 4.29-4.33,
/// with the third radial and the tangential terms added). Pixels; the centre of the top left pixel is (0, 0).
/// With k4 k5 k6 the radial factor is divided by 1 + k4 r2 + k5 r2^2 + k6 r2^3. Of a fisheye, t the angle to the axis:
/// xd = x' / r td, yd = y' / r td, td = t (1 + k1 t^2 + k2 t^4 + k3 t^6 + k4 t^8), no p1 p2 k5 k6; what is beside or
/// behind it (90 degrees and more) is not seen.
template <class T>
struct CameraT {
  int width = 0;
  int height = 0;
  T fx{}, fy{}, skew{}, cx{}, cy{}, k1{}, k2{}, p1{}, p2{}, k3{};
  bool is_fisheye = false;
  T k4{}, k5{}, k6{};
};
using Camera = CameraT<double>;

/// Brown's model without the rational terms.
template <class T>
bool is_plain(const CameraT<T>& c) {
  return !c.is_fisheye && c.k4 == T(0) && c.k5 == T(0) && c.k6 == T(0);
}

/// What normalised coordinates with this square of their length are multiplied by, tangential terms apart.
template <class T>
T radial_factor(const CameraT<T>& c, const T& r2) {
  if (c.is_fisheye) {
    using std::atan;
    using std::sqrt;
    if (r2 < T(1e-16)) return T(1);
    const T r = sqrt(r2), t = atan(r), t2 = t * t;
    return t / r * (T(1) + t2 * (c.k1 + t2 * (c.k2 + t2 * (c.k3 + t2 * c.k4))));
  }
  const T above = T(1) + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  return is_plain(c) ? above : above / (T(1) + r2 * (c.k4 + r2 * (c.k5 + r2 * c.k6)));
}

/// Image point (px) of a point in the camera's frame (m). Defined for every z != 0; ask `is_visible` first where
/// it matters.
template <class T>
Eigen::Matrix<T, 2, 1> project(const CameraT<T>& camera, const Vector3T<T>& x_in_camera) {
  const T x = x_in_camera.x() / x_in_camera.z();
  const T y = x_in_camera.y() / x_in_camera.z();
  const T r2 = x * x + y * y;
  const T radial = radial_factor(camera, r2);
  const T xd = x * radial + T(2) * camera.p1 * x * y + camera.p2 * (r2 + T(2) * x * x);
  const T yd = y * radial + camera.p1 * (r2 + T(2) * y * y) + T(2) * camera.p2 * x * y;
  return {camera.fx * xd + camera.skew * yd + camera.cx, camera.fy * yd + camera.cy};
}

/// `project` with its derivative by the point in the camera's frame (2 x 3, px/m).
Vector2 project(const Camera& camera, const Vector3& x_in_camera, Matrix23& pixel_by_point);

/// Derivative of the image point by (fx, fy, cx, cy, k1, k2, p1, p2), 2 x 8.
Eigen::Matrix<double, 2, 8> pixel_by_camera_numbers(const Camera& camera, const Vector3& x_in_camera);

/// The same two for residuals that must lead back from anywhere: `project` wherever the image could have the point, in
/// a cone that reaches 1.2 times as far as the image's corners. Beyond it, and behind the camera, the distance from the
/// axis in normalised coordinates grows with the angle t to the axis, as t0 + (1 + t0^2) (t - atan t0) with t0 the
/// cone's, and the distortion goes on as straight as it left the cone: continuous with its first derivatives by the
/// point everywhere but straight behind. Derivatives by the camera's numbers take the cone as it is.
Vector2 project_anywhere(const Camera& camera, const Vector3& x_in_camera, Matrix23& pixel_by_point);
Eigen::Matrix<double, 2, 8> pixel_by_camera_numbers_anywhere(const Camera& camera, const Vector3& x_in_camera);

/// In front of the camera, inside the image by `margin` px, and where the distortion is still one to one.
bool is_visible(const Camera& camera, const Vector3& x_in_camera, double margin = 0);

/// Normalised coordinates (x', y') of an image point: the distortion undone by Newton's method to 1e-12.
/// Nothing where the distortion cannot be undone there (the point lies outside its one-to-one region).
std::optional<Vector2> undistort(const Camera& camera, const Vector2& pixel);

/// Two cameras: X_right = right_from_left * X_left.
template <class T>
struct StereoRigT {
  CameraT<T> left, right;
  RigidT<T> right_from_left;
};
using StereoRig = StereoRigT<double>;

/// A triangulated point in the left camera's frame (m) and its covariance (m^2).
struct StereoPoint {
  Vector3 point;
  Matrix3 covariance;
  double epipolar_distance = 0;  // px: how far the two image points are from satisfying the epipolar constraint
};

/// Triangulation after Bouguet (thesis 4.12-4.15), then brought to the least reprojection error in both images.
/// The covariances are those of the image points (px^2). Nothing where the rays are parallel, where the point would
/// lie behind a camera, or where a distortion cannot be undone.
std::optional<StereoPoint> triangulate(const StereoRig& rig, const Vector2& left, const Vector2& right,
                                       const Eigen::Matrix2d& left_covariance = Eigen::Matrix2d::Identity(),
                                       const Eigen::Matrix2d& right_covariance = Eigen::Matrix2d::Identity());

/// Essential matrix [t]x R, X_right^T E X_left = 0 (thesis 4.49 with (4.12)'s T).
Matrix3 essential_matrix(const StereoRig& rig);

/// Thesis (4.50) as a distance in px: how far the pair of normalised points is from the epipolar constraint, to
/// first order (Sampson), with the mean focal length of the two cameras.
double epipolar_distance(const StereoRig& rig, const Matrix3& essential, const Vector2& left_normalised,
                         const Vector2& right_normalised);

}  // namespace handsight
