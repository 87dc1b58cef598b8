// SPDX-License-Identifier: Apache-2.0
// Where targets stand in rendered images, and what of them is truly in view.
#pragma once

#include <numeric>
#include <optional>
#include <random>
#include <string>

#include "fixtures/drawn.h"
#include "fixtures/target_images.h"

namespace handsight::fixtures {

struct Scene {
  TargetView view;
  std::vector<Rigid> pieces;
  bool is_hard = false;  // motion or glare: only wrong numbers count
};

inline double uniform(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution(from, to)(random);
}

inline Target target_of(const std::string& kind) {
  Target t;
  if (kind == "chessboard") return {.kind = TargetKind::chessboard, .columns = 9, .rows = 6, .square = 0.025};
  if (kind == "charuco")
    t = {.kind = TargetKind::charuco,
         .columns = 8,
         .rows = 6,
         .square = 0.03,
         .tag = 0.022,
         .dictionary = "DICT_5X5_100"};
  if (kind == "charuco_old")
    t = {.kind = TargetKind::charuco,
         .columns = 7,
         .rows = 6,
         .square = 0.03,
         .tag = 0.022,
         .dictionary = "DICT_4X4_50",
         .old_layout = true};
  if (kind == "aprilgrid")
    t = {.kind = TargetKind::aprilgrid,
         .columns = 6,
         .rows = 4,
         .tag = 0.03,
         .spacing = 0.3,
         .dictionary = "tag36h11",
         .border = 2};
  if (kind == "tags") t = {.kind = TargetKind::tags, .tag = 0.05, .dictionary = "DICT_5X5_100", .ids = {3, 7, 9, 40}};
  if (kind == "apriltags") t = {.kind = TargetKind::tags, .tag = 0.05, .dictionary = "tag36h11", .ids = {3, 7, 9, 40}};
  return t;
}

inline double module_of(const Target& t) {
  if (t.kind == TargetKind::chessboard) return t.square / 3;  // squares of 12 px
  return t.tag / (find_dictionary(t.dictionary)->bits + 2 * t.border);
}

inline Camera camera() {
  return {.width = 640,
          .height = 480,
          .fx = 620,
          .fy = 622,
          .cx = 322,
          .cy = 236,
          .k1 = -0.18,
          .k2 = 0.06,
          .p1 = 4e-4,
          .p2 = -3e-4};
}

inline Rigid placed(std::mt19937_64& random, const Vector2& centre_in_target, double module, double least_module,
                    const Camera& c, double spread) {
  const double tilt = uniform(random, 0, 60) * M_PI / 180, about = uniform(random, 0, 2 * M_PI),
               roll = uniform(random, -M_PI, M_PI);
  Rigid r;
  r.rotation = rotation_from_vector<double>(Vector3(std::cos(about), std::sin(about), 0) * tilt) *
               rotation_from_vector<double>(Vector3(0, 0, roll));
  // The module is shortened by the tilt: at least about so many px at the centre.
  const double size = least_module * std::exp(uniform(random, 0.0, 1.0));
  const double depth = c.fx * module / size * (0.35 + 0.65 * std::cos(tilt));
  const Vector2 aside = fixture::drawn_2([&] { return uniform(random, -0.5, 0.5); });
  const Vector2 pixel(c.cx + spread * aside.x() * c.width, c.cy + spread * aside.y() * c.height);
  const Vector3 centre(depth * (pixel.x() - c.cx) / c.fx, depth * (pixel.y() - c.cy) / c.fy, depth);
  r.translation = centre - r.rotation * Vector3(centre_in_target.x(), centre_in_target.y(), 0);
  return r;
}

inline std::vector<Vector2> blob(std::mt19937_64& random, const Vector2& centre, double radius) {
  std::vector<Vector2> polygon;
  const int count = 3 + static_cast<int>(random() % 3);
  const double first = uniform(random, 0, 6);
  for (int i = 0; i < count; ++i)
    polygon.push_back(centre +
                      radius * Vector2(std::cos(first + 2 * M_PI * i / count), std::sin(first + 2 * M_PI * i / count)));
  return polygon;
}

inline Scene scene_of(const Target& target, std::mt19937_64& random, double least_module) {
  Scene s;
  TargetView& v = s.view;
  v.camera = camera();
  v.blur = uniform(random, 0.4, 2.0);
  v.noise = uniform(random, 0, 8);
  v.black = uniform(random, 15, 60);
  v.white = uniform(random, 140, 230);
  v.slope_x = uniform(random, -0.3, 0.3), v.slope_y = uniform(random, -0.3, 0.3);
  v.seed = random();
  for (int i = 0; i < 6; ++i) {
    const double radius = uniform(random, 10, 120);
    const Vector2 middle{uniform(random, 0, 640), uniform(random, 0, 480)};
    v.clutter.push_back(blob(random, middle, radius));
    v.clutter_greys.push_back(uniform(random, 10, 240));
  }
  const PrintedPattern pattern = pattern_of(target);
  const Vector2 centre = pattern.outline.top_left + 0.5 * pattern.outline.size;
  const int how = static_cast<int>(random() % 4);  // whole or nearly, partly outside, half covered, hard
  const bool must_be_whole = target.kind == TargetKind::chessboard;
  v.camera_from_target =
      placed(random, centre, module_of(target), least_module, v.camera, how == 1 && !must_be_whole ? 1.0 : 0.3);
  if (target.kind == TargetKind::tags)
    for (std::size_t i = 0; i < target.ids.size(); ++i)
      s.pieces.push_back(placed(random, centre, module_of(target), least_module, v.camera, 0.9));
  if (how == 2 && !must_be_whole) {
    const double angle = uniform(random, 0, 2 * M_PI);
    const Vector2 normal(std::cos(angle), std::sin(angle)), side(-normal.y(), normal.x()),
        at = Vector2(320, 240) + fixture::drawn_2([&] { return uniform(random, -60, 60); });
    v.covers.push_back(
        {at - 900 * side, at + 900 * side, at + 900 * side + 900 * normal, at - 900 * side + 900 * normal});
    v.cover_greys.push_back(uniform(random, 20, 220));
  }
  if (how == 3) {
    s.is_hard = true;
    if (random() % 2)
      v.motion = uniform(random, 0.5, 4), v.motion_angle = uniform(random, 0, M_PI);
    else {
      const double y = uniform(random, 100, 380), x = uniform(random, 100, 540);
      v.glare = Vector2(x, y), v.glare_radius = uniform(random, 10, 80);
    }
  }
  return s;
}

/// Inside one of the convex covers, or nearer to it than the margin.
inline bool is_covered(const TargetView& v, const Vector2& pixel, double margin) {
  for (const auto& polygon : v.covers) {
    const Vector2 p = polygon[1] - polygon[0], q = polygon[2] - polygon[0];
    const double sign = p.x() * q.y() - p.y() * q.x() > 0 ? 1 : -1;
    double inside = 1e300;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2 a = polygon[i], d = (polygon[(i + 1) % polygon.size()] - a).normalized();
      inside = std::min(inside, sign * (d.x() * (pixel - a).y() - d.y() * (pixel - a).x()));
    }
    if (inside > -margin) return true;
  }
  return false;
}

struct Truth {
  std::vector<Vector2> pixels;
  std::vector<bool> in_view;
  int tags_in_view = 0;
};

inline bool is_seen(const Scene& s, const Rigid& r, const Vector3& x, double margin, Vector2* at = nullptr) {
  const Vector3 p = r * x;
  if (!(p.z() > 0.01) || !is_visible(s.view.camera, p, margin)) return false;
  const Vector2 pixel = project(s.view.camera, p);
  if (at) *at = pixel;
  return !is_covered(s.view, pixel, margin);
}

inline bool is_hidden_by_later(const Scene& s, const Target& t, std::size_t piece, const Vector2& pixel,
                               double margin) {
  for (std::size_t other = piece + 1; other < s.pieces.size(); ++other) {
    const Rigid& r = s.pieces[other];
    Matrix3 m;
    m << r.rotation.leftCols<2>(), r.translation;
    const auto ray = undistort(s.view.camera, pixel);
    if (!ray) continue;
    const Vector3 x = m.inverse() * ray->homogeneous();
    const double slack = margin * r.translation.z() / s.view.camera.fx * 2;
    if (x.z() > 0 && std::abs(x.x() / x.z()) < 0.63 * t.tag + slack && std::abs(x.y() / x.z()) < 0.63 * t.tag + slack)
      return true;
  }
  return false;
}

inline Truth load_truth(const PreparedTarget& target, const Scene& s, double least_module) {
  Truth truth;
  const Target& t = target.target;
  const double module = module_of(t);
  for (const TargetPoint& point : target.points) {
    const Rigid& r = s.pieces.empty() ? s.view.camera_from_target : s.pieces[static_cast<std::size_t>(point.piece)];
    Vector2 pixel(-1e9, -1e9);
    bool seen = is_seen(s, r, point.position, 8, &pixel);
    if ((r * point.position).z() > 0.01) pixel = project(s.view.camera, Vector3(r * point.position));
    // The smallest size of a module here.
    Eigen::Matrix2d slope;
    for (int i = 0; i < 2; ++i)
      slope.col(i) = project(s.view.camera, Vector3(r * (point.position + module * Vector3::Unit(i)))) - pixel;
    seen = seen && slope.jacobiSvd().singularValues()(1) >= least_module;
    truth.pixels.push_back(pixel);
    truth.in_view.push_back(seen);
  }
  std::vector<bool> whole;
  for (const PlacedTag& tag : target.tags) {
    const Rigid& r = s.pieces.empty() ? s.view.camera_from_target : s.pieces[static_cast<std::size_t>(tag.piece)];
    bool seen = true;
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j) {
        const Vector2 place = tag.top_left + t.tag * Vector2(-0.1 + 0.3 * i, -0.1 + 0.3 * j);
        Vector2 pixel;
        seen = seen && is_seen(s, r, Vector3(place.x(), place.y(), 0), 3, &pixel) &&
               !is_hidden_by_later(s, t, static_cast<std::size_t>(tag.piece), pixel, 3);
      }
    whole.push_back(seen);
    truth.tags_in_view += seen;
  }
  for (std::size_t i = 0; t.kind == TargetKind::tags && i < truth.in_view.size(); i += 4) {
    const bool all =
        whole[i / 4] && truth.in_view[i] && truth.in_view[i + 1] && truth.in_view[i + 2] && truth.in_view[i + 3];
    for (std::size_t k = 0; k < 4; ++k) truth.in_view[i + k] = all;
  }
  return truth;
}

}  // namespace handsight::fixtures
