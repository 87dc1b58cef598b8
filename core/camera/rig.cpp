// SPDX-License-Identifier: Apache-2.0
#include "camera/rig.h"

#include <Eigen/Cholesky>
#include <array>

#include "base/error.h"

namespace handsight {
namespace {

struct LinearStart {
  Vector3 in_first;
  double width = 0;  // squared sine of the angle between the rays
};

/// Bouguet's, thesis (4.14-4.15), of two views.
std::optional<LinearStart> linear_start(const View& a, const View& b, const Vector2& a_normalised,
                                        const Vector2& b_normalised) {
  const Rigid first_from_a = inverse(*a.camera_from_first);
  const Rigid b_from_a = *b.camera_from_first * first_from_a;
  const Vector3 a_ray = a_normalised.homogeneous(), b_ray = b_normalised.homogeneous();
  Eigen::Matrix<double, 3, 2> rays;
  rays << -(b_from_a.rotation * a_ray), b_ray;
  const Eigen::Matrix2d normal = rays.transpose() * rays;
  // Parallel rays: the determinant is (product of squared lengths) * sin^2 of the angle between them.
  const double width = normal.determinant() / (normal(0, 0) * normal(1, 1));
  if (!(width >= 1e-14)) return std::nullopt;
  const Vector2 depths = normal.inverse() * (rays.transpose() * b_from_a.translation);
  if (!(depths.x() > 0 && depths.y() > 0)) return std::nullopt;
  return LinearStart{first_from_a * Vector3(depths.x() * a_ray), width};
}

std::optional<Vector3> widest_start(std::span<const View> views) {
  std::array<Vector2, max_cameras> normalised;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto point = undistort(*views[i].camera, views[i].pixel);
    if (!point) return std::nullopt;
    normalised[i] = *point;
  }
  std::optional<LinearStart> best;
  for (std::size_t a = 0; a < views.size(); ++a)
    for (std::size_t b = a + 1; b < views.size(); ++b)
      if (const auto start = linear_start(views[a], views[b], normalised[a], normalised[b]))
        if (!best || start->width > best->width) best = start;
  return best ? std::optional(best->in_first) : std::nullopt;
}

bool is_before_all(std::span<const View> views, const Vector3& in_first) {
  for (const View& v : views)
    if (!((*v.camera_from_first * in_first).z() > 0)) return false;
  return true;
}

}  // namespace

std::optional<SeenPoint> triangulate(std::span<const View> views) {
  if (views.size() < 2 || views.size() > max_cameras) return std::nullopt;
  const auto start = widest_start(views);
  if (!start) return std::nullopt;
  std::array<Eigen::Matrix2d, max_cameras> weights;
  for (std::size_t i = 0; i < views.size(); ++i) weights[i] = views[i].covariance.inverse();
  SeenPoint result{*start, Matrix3::Zero()};
  Matrix3 information;
  for (int iteration = 0; iteration < 10; ++iteration) {
    information.setZero();
    Vector3 gradient = Vector3::Zero();
    for (std::size_t i = 0; i < views.size(); ++i) {
      const View& v = views[i];
      const Vector3 in_camera = *v.camera_from_first * result.point;
      if (!(in_camera.z() > 0)) return std::nullopt;
      Matrix23 by_camera_point;
      const Vector2 error = v.pixel - project(*v.camera, in_camera, by_camera_point);
      const Matrix23 by_point = by_camera_point * v.camera_from_first->rotation;
      information += by_point.transpose() * weights[i] * by_point;
      gradient += by_point.transpose() * weights[i] * error;
    }
    const Vector3 step = information.ldlt().solve(gradient);
    result.point += step;
    if (!(step.norm() < 10 * start->norm())) return std::nullopt;
    if (step.norm() < 1e-12 * result.point.norm()) break;
  }
  if (!is_before_all(views, result.point)) return std::nullopt;
  result.covariance = information.inverse();
  return result;
}

Rig make_rig(const StereoRig& stereo) {
  Rig rig;
  rig.cameras.push_back(RigCamera{"left", stereo.left, Rigid()});
  rig.cameras.push_back(RigCamera{"right", stereo.right, stereo.right_from_left});
  return rig;
}

StereoRig make_stereo(const Rig& rig) {
  check(rig.count() >= 2, "a pair of cameras from a rig of {}", rig.count());
  return {rig.at(0).camera, rig.at(1).camera, rig.at(1).camera_from_first};
}

bool is_left_and_right(const Rig& rig) { return is_pair(rig) && rig.at(0).name == "left" && rig.at(1).name == "right"; }

std::vector<std::string> camera_names(const Rig& rig) {
  std::vector<std::string> names;
  for (const RigCamera& c : rig.cameras) names.push_back(c.name);
  return names;
}

Message listed_names(const Rig& rig) { return joined(verbatim(camera_names(rig)), ", ", " and "); }

const char* cameras_that_must_see(const std::optional<Rig>& rig) {
  if (!rig || is_pair(*rig)) return "both cameras";
  return rig->count() == 1 ? "the camera" : "two of the cameras";
}

int find_camera(const Rig& rig, const std::string& name) {
  for (int c = 0; c < rig.count(); ++c)
    if (rig.at(c).name == name) return c;
  return -1;
}

std::span<const CameraNumber, camera_number_count> camera_numbers(const Camera&) {
  static constexpr CameraNumber brown[camera_number_count] = {
      {"fx", "px", 2.5, 5e-3, &Camera::fx}, {"fy", "px", 2.5, 5e-3, &Camera::fy}, {"cx", "px", 4, 0, &Camera::cx},
      {"cy", "px", 4, 0, &Camera::cy},      {"k1", "1", 0.03, 0, &Camera::k1},    {"k2", "1", 0.03, 0, &Camera::k2},
      {"p1", "1", 1e-3, 0, &Camera::p1},    {"p2", "1", 1e-3, 0, &Camera::p2}};
  return brown;
}

}  // namespace handsight
