// SPDX-License-Identifier: Apache-2.0
#include "camera/lens.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace handsight {
namespace {

constexpr std::array<const LensModel*, 3> models{&brown_lens, &rational_lens, &fisheye_lens};

/// Two directions square to a ray, to move it by.
Eigen::Matrix<double, 3, 2> beside(const Vector3& ray) {
  const Vector3 other = std::abs(ray.x()) < 0.7 ? Vector3::UnitX() : Vector3::UnitY();
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = ray.cross(other).normalized();
  basis.col(1) = ray.cross(basis.col(0));
  return basis;
}

}  // namespace

std::span<const LensModel* const> lens_models() { return models; }

const LensModel* find_lens_model(std::string_view name) {
  for (const LensModel* model : models)
    if (model->name == name) return model;
  return nullptr;
}

Vector2 project(const Lens& lens, const Vector3& x_in_camera) {
  LensProjection projection;
  lens.model->project(lens.numbers, x_in_camera, projection);
  return projection.pixel;
}

std::optional<Vector3> lift(const Lens& lens, const Vector2& pixel) {
  // From the axis outward: the distance from the centre over the focal length is the angle, roughly, in every model.
  const Vector2 start((pixel.x() - lens.numbers[2]) / lens.numbers[0], (pixel.y() - lens.numbers[3]) / lens.numbers[1]);
  const double angle = std::min(start.norm(), 1.2);
  Vector3 ray = Vector3::UnitZ();
  if (angle > 0) ray << std::sin(angle) * start.normalized(), std::cos(angle);
  LensProjection p;
  for (int iteration = 0; iteration < 60; ++iteration) {
    lens.model->project(lens.numbers, ray, p);
    const Vector2 error = pixel - p.pixel;
    if (error.norm() < 1e-10) break;
    const Eigen::Matrix<double, 3, 2> basis = beside(ray);
    const Eigen::Matrix2d slope = p.by_point * basis;
    Vector2 step = slope.inverse() * error;
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() > 0.2) step *= 0.2 / step.norm();
    ray = (ray + basis * step).normalized();
  }
  lens.model->project(lens.numbers, ray, p);
  if (!((pixel - p.pixel).norm() < 1e-7) || !lens.model->sees(lens.numbers, ray)) return std::nullopt;
  return ray;
}

std::optional<Camera> look_up_camera(const Lens& lens) {
  const auto& n = lens.numbers;
  Camera c{.width = lens.width,
           .height = lens.height,
           .fx = n[0],
           .fy = n[1],
           .cx = n[2],
           .cy = n[3],
           .k1 = n[4],
           .k2 = n[5]};
  if (lens.model == &fisheye_lens) {
    c.is_fisheye = true;
    c.k3 = n[6];
    c.k4 = n[7];
    return c;
  }
  if (lens.model != &brown_lens && lens.model != &rational_lens) return std::nullopt;
  c.p1 = n[6];
  c.p2 = n[7];
  c.k3 = n[8];
  if (lens.model == &rational_lens) {
    c.k4 = n[9];
    c.k5 = n[10];
    c.k6 = n[11];
  }
  return c;
}

Lens make_lens(const Camera& c) {
  if (c.is_fisheye) return {&fisheye_lens, c.width, c.height, {c.fx, c.fy, c.cx, c.cy, c.k1, c.k2, c.k3, c.k4}};
  if (!is_plain(c))
    return {
        &rational_lens, c.width, c.height, {c.fx, c.fy, c.cx, c.cy, c.k1, c.k2, c.p1, c.p2, c.k3, c.k4, c.k5, c.k6}};
  return {&brown_lens, c.width, c.height, {c.fx, c.fy, c.cx, c.cy, c.k1, c.k2, c.p1, c.p2, c.k3}};
}

}  // namespace handsight
