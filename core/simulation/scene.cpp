// SPDX-License-Identifier: Apache-2.0
// The room about the hand: table, boxes, cupboards, and what is stuck to them.
#include "simulation/scene.h"

#include <algorithm>
#include <cmath>

#include "simulation/random.h"
#include "simulation/trace.h"

namespace handsight {

namespace {

/// The directions in which things stand behind the hand, seen from the camera.
struct Outlook {
  Vector3 forward, across;  // horizontal unit vectors
  double table = 0;         // m, height of the table top
};

Outlook outlook_of(const Workspace& w) {
  Outlook o;
  Vector3 forward = w.hand - w.camera;
  forward.z() = 0;
  o.forward = forward.norm() > 0.05 ? Vector3(forward.normalized()) : Vector3::UnitX();
  o.across = Vector3::UnitZ().cross(o.forward);
  o.table = std::min(w.hand.z() - w.reach - 0.12, w.camera.z() - 0.3);
  return o;
}

Matrix3 upright(const Outlook& o, double turn) {
  Matrix3 axes;
  axes << o.forward, o.across, Vector3::UnitZ();
  return rotation_about(Vector3::UnitZ(), turn) * axes;
}

Solid standing_box(const Outlook& o, const Vector3& foot, const Vector3& half_size, double turn, double grey) {
  Solid solid;
  solid.frame_from_solid = {upright(o, turn), foot + Vector3(0, 0, half_size.z())};
  solid.half_size = half_size;
  solid.grey = grey;
  solid.mottle = 9;
  solid.texels = 260;
  return solid;
}

/// Nothing stands between the camera and the hand: all of it is beyond the hand's reach or below the table top.
void add_furniture(const Workspace& w, const Outlook& o, Random& random, Scene& scene) {
  const Vector3 below_hand(w.hand.x(), w.hand.y(), o.table);
  const double beyond = w.reach + 0.05;
  const double depth = beyond + 0.35;  // half the table, along the view
  scene.solids.push_back(
      standing_box(o, below_hand + 0.3 * o.forward - Vector3(0, 0, 0.04), {depth, 0.85, 0.02}, 0, 150));
  for (int i = 0; i < 6; ++i) {
    Vector3 half;  // drawn one by one: the order of a call's arguments is the compiler's
    half.z() = random.uniform(0.03, 0.11);
    half.y() = random.uniform(0.03, 0.1);
    half.x() = random.uniform(0.03, 0.07);
    const double far = beyond + half.head<2>().norm() + random.uniform(0, 0.25);
    const Vector3 foot = below_hand + far * o.forward + random.uniform(-0.65, 0.65) * o.across;
    const double grey = random.uniform(70, 165), turn = random.uniform(-0.6, 0.6);
    scene.solids.push_back(standing_box(o, foot, half, turn, grey));
  }
  for (int i = 0; i < 3; ++i) {
    const double high = random.uniform(0.45, 0.85), wide = random.uniform(0.2, 0.35);
    const Vector3 half(0.2, wide, high);
    const double far = beyond + 0.5 + half.head<2>().norm() + random.uniform(0, 0.3);
    Vector3 foot = below_hand + far * o.forward + (i - 1 + random.uniform(-0.25, 0.25)) * 0.95 * o.across;
    foot.z() = scene.room_lower.z();
    const double grey = random.uniform(85, 160), turn = random.uniform(-0.1, 0.1);
    scene.solids.push_back(standing_box(o, foot, half, turn, grey));
  }
}

void set_room(const Workspace& w, const Outlook& o, Random& random, Scene& scene) {
  for (int axis = 0; axis < 2; ++axis) {
    scene.room_lower[axis] = std::min(w.camera[axis], w.hand[axis]) - w.reach - random.uniform(1.5, 2.1);
    scene.room_upper[axis] = std::max(w.camera[axis], w.hand[axis]) + w.reach + random.uniform(1.5, 2.1);
  }
  scene.room_lower.z() = o.table - 0.74;
  scene.room_upper.z() = std::max(w.camera.z(), w.hand.z()) + w.reach + 1.4;
}

void set_light(const Workspace& w, bool shadow, Random& random, Light& light) {
  const Vector3 to_camera = (w.camera - w.hand).normalized();
  const double sideways = random.uniform(-0.6, 0.6), askew = random.uniform(-0.4, 0.4);
  light.direction = (to_camera + Vector3(askew, sideways, 0.8)).normalized();
  light.ambient = 0.6;
  const Vector3 brighter_toward = random.gaussian3().normalized();
  light.gradient = random.uniform(0.15, 0.35) * brighter_toward;
  light.center = w.hand;
  // The band's plane leans a little against the line of sight: it crosses hand and background alike, wide and soft.
  const Vector3 aside = to_camera.unitOrthogonal();
  const double roll = random.uniform(0, 2 * M_PI), lean = random.uniform(0.25, 0.6);
  light.shadow_normal = (rotation_about(to_camera, roll) * aside + lean * to_camera).normalized();
  light.shadow_offset = random.uniform(-0.1, 0.1);
  light.shadow_half_width = random.uniform(0.03, 0.09);
  light.shadow_edge = random.uniform(0.06, 0.1);
  const double depth = random.uniform(0.2, 0.35);
  light.shadow_depth = shadow ? depth : 0;
}

/// Sticks a plate to what the ray from the camera meets, turned at random; false where it does not lie flat on one
/// face, is seen too flat, or would touch another plate. The plate's sizes are given for a metre's distance.
bool stick(Scene& scene, const Workspace& w, const Vector3& direction, Random& random, Plate plate) {
  const SceneView view = make_view(scene, {Matrix3::Identity(), w.camera}, {Matrix3::Identity(), w.hand});
  const Hit hit = trace(view, direction);
  if (hit.item == Hit::nothing) return false;
  if (hit.item != Hit::room && view.items[static_cast<std::size_t>(hit.item)].kind != Item::Kind::box) return false;
  const Vector3 normal = normal_in_root(view, direction, hit);
  if (-normal.dot(direction.normalized()) < 0.4) return false;
  const double distance = hit.depth * direction.norm();
  plate.half_size *= distance;
  plate.cell *= distance;
  // Things hang straight, more or less; on the table they lie anyhow.
  const double turn = std::abs(normal.z()) > 0.9 ? random.uniform(0, 2 * M_PI) : random.uniform(-0.5, 0.5);
  const Matrix3 axes = axes_from(normal, std::abs(normal.z()) > 0.9 ? Vector3::UnitX() : Vector3::UnitZ());
  plate.frame_from_plate = {rotation_about(normal, turn) * axes, w.camera + hit.depth * direction + 0.002 * normal};
  const double radius = plate.half_size.norm();
  for (const Plate& other : scene.plates) {
    const Vector3 apart = other.frame_from_plate.translation - plate.frame_from_plate.translation;
    if (apart.norm() < 1.02 * (radius + other.half_size.norm())) return false;
  }
  for (const double x : {-1.05, 1.05})
    for (const double y : {-1.05, 1.05}) {
      const Vector3 corner(x * plate.half_size.x(), y * plate.half_size.y(), -0.002);
      const Vector3 to_corner = plate.frame_from_plate * corner - w.camera;
      const Hit there = trace(view, to_corner);
      if (there.item != hit.item || there.part != hit.part) return false;
    }
  scene.plates.push_back(plate);
  return true;
}

/// Toward a place near the hand as the camera sees it, or toward one of the things that stand about.
Vector3 glance(const Scene& scene, const Workspace& w, const Outlook& o, Random& random, double spread) {
  if (random.uniform() < 0.35) {
    const Solid& solid = scene.solids[static_cast<std::size_t>(random.integer(static_cast<int>(scene.solids.size())))];
    Vector3 place = solid.half_size;
    for (int axis = 0; axis < 3; ++axis) place[axis] *= random.uniform(-1, 1);
    return solid.frame_from_solid * place - w.camera;
  }
  const Vector3 forward = (w.hand - w.camera).normalized();
  const Vector3 up = o.across.cross(forward).norm() > 0.1 ? Vector3(forward.cross(o.across)) : Vector3::UnitZ();
  const double aside = random.uniform(-0.62, 0.62), upward = random.uniform(-0.47, 0.47);
  return forward + spread * (aside * o.across + upward * up);
}

/// A chess pattern with at most `most` inner corners; sizes for a metre's distance.
Plate chess_plate(int most, Random& random) {
  constexpr int sizes[][2] = {{2, 2}, {3, 2}, {3, 3}, {4, 3}};
  const int* size = sizes[random.integer(4)];
  if ((size[0] - 1) * (size[1] - 1) > most) size = sizes[0];
  Plate plate;
  plate.pattern = SurfacePattern::chess;
  plate.columns = size[0];
  plate.rows = size[1];
  plate.cell = random.uniform(0.015, 0.028);
  plate.half_size = Vector2(plate.columns + 0.7, plate.rows + 0.7) * plate.cell / 2;
  plate.dark = random.uniform(30, 70);
  plate.light = random.uniform(165, 215);
  return plate;
}

/// A print without X-corners: a dark or light sheet, dots or lines.
Plate other_plate(Random& random) {
  Plate plate;
  const int kind = random.integer(3);
  plate.pattern = kind == 0 ? SurfacePattern::plain : kind == 1 ? SurfacePattern::dots : SurfacePattern::lines;
  plate.columns = kind == 1 ? 2 + random.integer(5) : 1;
  plate.rows = 2 + random.integer(5);
  plate.cell = kind == 1 ? random.uniform(0.012, 0.024) : random.uniform(0.01, 0.02);
  plate.half_size = kind == 1 ? Vector2(plate.columns + 0.8, plate.rows + 0.8) * plate.cell / 2
                              : Vector2(random.uniform(0.02, 0.1), (plate.rows + 0.8) * plate.cell / 2);
  if (kind == 2) plate.columns = std::max(1, static_cast<int>(2 * plate.half_size.x() / plate.cell - 0.8));
  plate.dark = random.uniform(40, 90);
  plate.light = kind == 0 ? random.uniform(60, 190) : random.uniform(150, 205);
  return plate;
}

}  // namespace

Scene make_scene(const std::vector<MarkerPlate>& markers, const SceneOptions& options) {
  Random random(options.seed);
  const Workspace& w = options.workspace;
  Scene scene;
  scene.texture = make_texture(random.word());
  const Outlook outlook = outlook_of(w);
  set_room(w, outlook, random, scene);
  set_light(w, options.shadow, random, scene.light);
  add_furniture(w, outlook, random, scene);
  int wanted = options.distractor_corners, prints = 9;
  // Where the view is crowded the search widens; a scene too full for all is left with fewer.
  for (int attempt = 0; attempt < 6000 && (wanted > 0 || prints > 0); ++attempt) {
    const bool chess = wanted > 0 && (prints == 0 || random.uniform() < 0.6);
    const Plate plate = chess ? chess_plate(wanted, random) : other_plate(random);
    if (!stick(scene, w, glance(scene, w, outlook, random, 1 + attempt / 1500.0), random, plate)) continue;
    if (chess)
      wanted -= (plate.columns - 1) * (plate.rows - 1);
    else
      --prints;
  }
  // The hand comes last: what is stuck to the room must not be stuck to it.
  if (markers.empty()) return scene;
  scene.markers = markers;
  const Hand hand = build_hand(markers, options.fingers);
  for (std::size_t m = 0; m < markers.size(); ++m) scene.markers[m].pedestal = hand.pedestals[m];
  scene.hand = hand.solids;
  scene.hand_plates = hand.plates;
  return scene;
}

}  // namespace handsight
