// SPDX-License-Identifier: Apache-2.0
// Rays from one camera into a scene: what they hit and how bright it is.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "simulation/scene_parts.h"

namespace handsight {

/// One thing of the scene as the camera sees it.
struct Item {
  enum class Kind { box, capsule, plate };
  Kind kind = Kind::box;
  Rigid item_from_camera;
  Matrix3 root_from_item = Matrix3::Identity();  // rotation
  Vector3 half_size = Vector3::Zero();           // m; a plate's z is 0
  Vector3 sphere_center = Vector3::Zero();       // camera frame, m: the ball that holds it
  double sphere_radius = 0;
  SurfacePattern pattern = SurfacePattern::plain;
  int columns = 0, rows = 0;
  double cell = 1;
  double dark = 0, light = 0;  // grey levels; solids and plain plates: `light`
  double mottle = 0, texels = 0;
  int marker = -1;  // index of the marker that it is
  const BlackAt* print = nullptr;
  Vector2 print_middle = Vector2::Zero();  // m

  /// Are its edges what is measured?
  bool is_measured() const { return marker >= 0 || print; }
  bool of_hand = false;
};

struct SceneView {
  const Scene* scene = nullptr;
  Rigid root_from_camera;
  std::vector<Item> items;
};

/// What a ray hits. Rays are (x', y', 1) in the camera frame, so that `depth` is the camera's z, m.
struct Hit {
  static constexpr int room = -1, nothing = -2;
  double depth = std::numeric_limits<double>::infinity();
  int item = nothing;
  int part = 0;  // face of a box or of the room; 0 or the number of a cell, dot or line of a plate
  bool dark = false;

  /// Equal for places with no edge between them.
  std::uint32_t key() const { return static_cast<std::uint32_t>(item + 2) << 16 | static_cast<std::uint32_t>(part); }
};

SceneView make_view(const Scene& scene, const Rigid& root_from_camera, const Rigid& root_from_tcp);

/// The nearest hit among the items named, or the room.
Hit trace(const SceneView& view, const Vector3& direction, std::span<const std::uint16_t> items);

/// The nearest hit among all items, or the room.
Hit trace(const SceneView& view, const Vector3& direction);

/// Unit normal at a hit (root frame), toward the camera's side. The hit is not `nothing`.
Vector3 normal_in_root(const SceneView& view, const Vector3& direction, const Hit& hit);

/// Grey level at a hit, 0 to 255 and beyond where light is strong; 0 for nothing.
double grey_at(const SceneView& view, const Vector3& direction, const Hit& hit);

}  // namespace handsight
