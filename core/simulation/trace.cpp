// SPDX-License-Identifier: Apache-2.0
#include "simulation/trace.h"

#include <algorithm>
#include <cmath>

#include "simulation/hand.h"
#include "targets/pattern.h"

namespace handsight {

namespace {

constexpr double nearest_depth = 0.01;  // m: nothing nearer is seen

Item item_from(const Solid& solid, const Rigid& root_from_frame, const Rigid& camera_from_root) {
  Item item;
  item.kind = solid.kind == SolidKind::box ? Item::Kind::box : Item::Kind::capsule;
  const Rigid root_from_item = root_from_frame * solid.frame_from_solid;
  item.item_from_camera = inverse(camera_from_root * root_from_item);
  item.root_from_item = root_from_item.rotation;
  item.half_size = solid.half_size;
  item.sphere_center = camera_from_root * root_from_item.translation;
  item.sphere_radius =
      solid.kind == SolidKind::box ? solid.half_size.norm() : solid.half_size.x() + solid.half_size.z();
  item.light = solid.grey;
  item.mottle = solid.mottle;
  item.texels = solid.texels;
  return item;
}

Item item_from(const Plate& plate, const Rigid& root_from_frame, const Rigid& camera_from_root) {
  Item item;
  item.kind = Item::Kind::plate;
  const Rigid root_from_item = root_from_frame * plate.frame_from_plate;
  item.item_from_camera = inverse(camera_from_root * root_from_item);
  item.root_from_item = root_from_item.rotation;
  item.half_size = {plate.half_size.x(), plate.half_size.y(), 0};
  item.sphere_center = camera_from_root * root_from_item.translation;
  item.sphere_radius = plate.half_size.norm();
  item.pattern = plate.pattern;
  item.columns = plate.columns;
  item.rows = plate.rows;
  item.cell = plate.cell;
  item.dark = plate.dark;
  item.light = plate.light;
  item.print = plate.print.get();
  item.print_middle = plate.print_middle;
  return item;
}

Plate plate_from(const MarkerPlate& marker) {
  Plate plate;
  plate.frame_from_plate = tcp_from_plate(marker);
  plate.half_size = Vector2::Constant(half_side(marker));
  plate.pattern = SurfacePattern::chess;
  plate.cell = marker.cell;
  plate.dark = marker.black;
  plate.light = marker.white;
  return plate;
}

Solid pedestal_under(const MarkerPlate& marker) {
  Solid solid;
  const Matrix3 axes = tcp_from_plate(marker).rotation;
  // The label is paper: its underside stands 0.3 mm above the block, so that neither cuts through the other.
  solid.frame_from_solid = {axes, marker.center - (marker.pedestal / 2 + 0.0003) * axes.col(2)};
  const double side = half_side(marker) + 0.0015;
  solid.half_size = {side, side, marker.pedestal / 2};
  solid.grey = 92;
  return solid;
}

/// Nearest depth in (nearest_depth, hit.depth) where the ray o + t d enters the box.
void hit_box(const Vector3& half, const Vector3& o, const Vector3& d, int index, Hit& hit) {
  double enter = -1e30, leave = 1e30;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / d[axis];  // infinite where parallel: the comparisons below still hold
    double near = (-half[axis] - o[axis]) * inverse, far = (half[axis] - o[axis]) * inverse;
    int side = 2 * axis;
    if (near > far) {
      std::swap(near, far);
      ++side;
    }
    if (near > enter) {
      enter = near;
      face = side;
    }
    if (far < leave) leave = far;
  }
  if (!(enter < leave) || !(enter > nearest_depth) || !(enter < hit.depth)) return;
  hit = {enter, index, face, false};
}

void hit_sphere(double z, double radius, const Vector3& o, const Vector3& d, int index, Hit& hit) {
  const Vector3 from_center(o.x(), o.y(), o.z() - z);
  const double a = d.squaredNorm(), b = from_center.dot(d), c = from_center.squaredNorm() - radius * radius;
  const double root = b * b - a * c;
  if (root < 0) return;
  const double depth = (-b - std::sqrt(root)) / a;
  if (depth > nearest_depth && depth < hit.depth) hit = {depth, index, 0, false};
}

void hit_capsule(const Vector3& half, const Vector3& o, const Vector3& d, int index, Hit& hit) {
  const double radius = half.x();
  const double a = d.x() * d.x() + d.y() * d.y(), b = o.x() * d.x() + o.y() * d.y();
  const double c = o.x() * o.x() + o.y() * o.y() - radius * radius;
  const double root = b * b - a * c;
  if (root < 0) return;  // beside the infinite cylinder, so beside the caps too
  const double depth = (-b - std::sqrt(root)) / a;
  const double z = o.z() + depth * d.z();
  if (std::abs(z) <= half.z()) {
    if (depth > nearest_depth && depth < hit.depth) hit = {depth, index, 0, false};
    return;
  }
  hit_sphere(half.z(), radius, o, d, index, hit);
  hit_sphere(-half.z(), radius, o, d, index, hit);
}

/// Part of a plate's pattern and whether it is dark.
void find_part(const Item& item, double x, double y, Hit& hit) {
  if (item.print) {
    hit.dark = (*item.print)(item.print_middle.x() + x, item.print_middle.y() - y);
    hit.part = hit.dark ? 1 : 0;
    return;
  }
  const int column = static_cast<int>(std::floor(x / item.cell + 0.5 * item.columns));
  const int row = static_cast<int>(std::floor(y / item.cell + 0.5 * item.rows));
  hit.part = 0;
  hit.dark = false;
  if (item.pattern == SurfacePattern::plain || column < 0 || row < 0 || column >= item.columns || row >= item.rows)
    return;
  const double in_column = x / item.cell + 0.5 * item.columns - column - 0.5;
  const double in_row = y / item.cell + 0.5 * item.rows - row - 0.5;
  const int part = 1 + row * item.columns + column;
  if (item.pattern == SurfacePattern::chess) {
    hit.part = part;
    hit.dark = (row + column) % 2 == 0;
  } else if (item.pattern == SurfacePattern::dots ? in_column * in_column + in_row * in_row < 0.08
                                                  : std::abs(in_row) < 0.17) {
    hit.part = item.pattern == SurfacePattern::dots ? part : 1 + row;
    hit.dark = true;
  }
}

void hit_plate(const Item& item, const Vector3& o, const Vector3& d, int index, Hit& hit) {
  const double depth = -o.z() / d.z();
  if (!(depth > nearest_depth) || !(depth < hit.depth)) return;
  const double x = o.x() + depth * d.x(), y = o.y() + depth * d.y();
  if (std::abs(x) > item.half_size.x() || std::abs(y) > item.half_size.y()) return;
  hit.depth = depth;
  hit.item = index;
  if (o.z() > 0) {
    find_part(item, x, y, hit);
  } else {  // the bare back of the paper
    hit.part = 0xFFFF;
    hit.dark = false;
  }
}

void hit_room(const SceneView& view, const Vector3& direction, Hit& hit) {
  const Vector3 d = view.root_from_camera.rotation * direction;
  const Vector3& o = view.root_from_camera.translation;
  double leave = 1e30;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double wall = d[axis] > 0 ? view.scene->room_upper[axis] : view.scene->room_lower[axis];
    const double far = (wall - o[axis]) / d[axis];
    if (d[axis] == 0 || far >= leave) continue;
    leave = far;
    face = 2 * axis + (d[axis] > 0);
  }
  if (leave > nearest_depth && leave < hit.depth) hit = {leave, Hit::room, face, false};
}

void hit_item(const SceneView& view, int index, const Vector3& direction, Hit& hit) {
  const Item& item = view.items[static_cast<std::size_t>(index)];
  const Vector3& o = item.item_from_camera.translation;
  const Vector3 d = item.item_from_camera.rotation * direction;
  switch (item.kind) {
    case Item::Kind::box:
      return hit_box(item.half_size, o, d, index, hit);
    case Item::Kind::capsule:
      return hit_capsule(item.half_size, o, d, index, hit);
    case Item::Kind::plate:
      return hit_plate(item, o, d, index, hit);
  }
}

double soft_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double light_at(const Light& light, const Vector3& x_in_root, const Vector3& normal) {
  const double lambert = light.ambient + (1 - light.ambient) * std::max(0.0, normal.dot(light.direction));
  const double gradient = std::clamp(1 + light.gradient.dot(x_in_root - light.center), 0.5, 1.25);
  if (light.shadow_depth == 0) return lambert * gradient;
  const double across = std::abs(light.shadow_normal.dot(x_in_root - light.center) - light.shadow_offset);
  const double shade = 1 - soft_step((across - light.shadow_half_width) / light.shadow_edge + 0.5);
  return lambert * gradient * (1 - light.shadow_depth * shade);
}

/// On a flat face the texture lies in the face; on round things it is a slanted projection, continuous everywhere.
double texture_on_face(const Texture& texture, const Vector3& x, int axis, double texels) {
  const double shift = 37.0 * axis;  // the faces of one box must not continue each other
  return texture.at(texels * x[(axis + 1) % 3] + shift, texels * x[(axis + 2) % 3] - shift);
}

double texture_on_curve(const Texture& texture, const Vector3& x, double texels) {
  return texture.at(texels * (x.x() + 0.61 * x.z()), texels * (x.y() + 0.83 * x.z()));
}

constexpr double wall_grey[6] = {126, 148, 138, 120, 84, 170};

}  // namespace

SceneView make_view(const Scene& scene, const Rigid& root_from_camera, const Rigid& root_from_tcp) {
  SceneView view;
  view.scene = &scene;
  view.root_from_camera = root_from_camera;
  const Rigid camera_from_root = inverse(root_from_camera), root_from_root;
  for (std::size_t m = 0; m < scene.markers.size(); ++m) {
    view.items.push_back(item_from(plate_from(scene.markers[m]), root_from_tcp, camera_from_root));
    view.items.back().marker = static_cast<int>(m);
  }
  for (const MarkerPlate& marker : scene.markers)
    view.items.push_back(item_from(pedestal_under(marker), root_from_tcp, camera_from_root));
  for (const Plate& plate : scene.hand_plates) view.items.push_back(item_from(plate, root_from_tcp, camera_from_root));
  for (const Solid& solid : scene.hand) view.items.push_back(item_from(solid, root_from_tcp, camera_from_root));
  for (Item& item : view.items) item.of_hand = true;
  for (const Plate& plate : scene.plates) view.items.push_back(item_from(plate, root_from_root, camera_from_root));
  for (const Solid& solid : scene.solids) view.items.push_back(item_from(solid, root_from_root, camera_from_root));
  return view;
}

Hit trace(const SceneView& view, const Vector3& direction, std::span<const std::uint16_t> items) {
  Hit hit;
  for (const std::uint16_t index : items) hit_item(view, index, direction, hit);
  hit_room(view, direction, hit);
  return hit;
}

Hit trace(const SceneView& view, const Vector3& direction) {
  Hit hit;
  for (std::size_t i = 0; i < view.items.size(); ++i) hit_item(view, static_cast<int>(i), direction, hit);
  hit_room(view, direction, hit);
  return hit;
}

Vector3 normal_in_root(const SceneView& view, const Vector3& direction, const Hit& hit) {
  Vector3 normal = Vector3::Zero();
  if (hit.item == Hit::room) {
    normal[hit.part / 2] = hit.part % 2 ? -1 : 1;
    return normal;
  }
  const Item& item = view.items[static_cast<std::size_t>(hit.item)];
  if (item.kind == Item::Kind::box) {
    return hit.part % 2 ? item.root_from_item.col(hit.part / 2) : Vector3(-item.root_from_item.col(hit.part / 2));
  }
  if (item.kind == Item::Kind::plate) {
    const bool front = item.item_from_camera.translation.z() > 0;
    return front ? item.root_from_item.col(2) : Vector3(-item.root_from_item.col(2));
  }
  const Vector3 x = item.item_from_camera * Vector3(hit.depth * direction);
  const Vector3 nearest(0, 0, std::clamp(x.z(), -item.half_size.z(), item.half_size.z()));
  return item.root_from_item * (x - nearest) / item.half_size.x();
}

double grey_at(const SceneView& view, const Vector3& direction, const Hit& hit) {
  if (hit.item == Hit::nothing) return 0;
  const Vector3 x_in_camera = hit.depth * direction;
  const Vector3 x_in_root = view.root_from_camera * x_in_camera;
  double grey;
  if (hit.item == Hit::room) {
    grey = wall_grey[hit.part] + 26 * texture_on_face(view.scene->texture, x_in_root, hit.part / 2, 70);
  } else {
    const Item& item = view.items[static_cast<std::size_t>(hit.item)];
    grey = hit.dark ? item.dark : item.light;
    if (item.mottle > 0) {
      const Vector3 x_in_item = item.item_from_camera * x_in_camera;
      const Texture& texture = view.scene->texture;
      grey +=
          item.mottle * (item.kind == Item::Kind::box ? texture_on_face(texture, x_in_item, hit.part / 2, item.texels)
                                                      : texture_on_curve(texture, x_in_item, item.texels));
    }
  }
  return grey * light_at(view.scene->light, x_in_root, normal_in_root(view, direction, hit));
}

}  // namespace handsight
