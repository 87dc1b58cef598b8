// SPDX-License-Identifier: Apache-2.0
// What a scene is made of: labels, solids, plates, a room and its light.
#pragma once

#include <memory>
#include <vector>

#include "geometry/rigid.h"
#include "simulation/texture.h"

namespace handsight {

class BlackAt;

/// A label with one marker: 2 x 2 chess cells whose X-corner is `center`. Metres, in the TCP frame.
struct MarkerPlate {
  Vector3 center = Vector3::Zero();
  Vector3 normal = Vector3::UnitZ();  // unit, out of the hand
  Vector3 up = Vector3::UnitX();      // in-plane direction of the cells' edges; its part along `normal` is ignored
  double cell = 0.012;                // m, side of one chess cell
  double margin = 0.004;              // m, of white around the cells
  double pedestal = 0.012;            // m, depth of the block that carries the label; both move with `center`
  double black = 40, white = 205;     // grey levels in full light
};

/// Half the side of the label, m.
inline double half_side(const MarkerPlate& marker) { return marker.cell + marker.margin; }

enum class SolidKind { box, capsule };

/// A thing with a dull surface. A box has half_size along its axes; a capsule has radius half_size.x and reaches
/// half_size.z + radius along its z axis.
struct Solid {
  SolidKind kind = SolidKind::box;
  Rigid frame_from_solid;  // frame: TCP for the hand, root for what stands about
  Vector3 half_size = Vector3::Ones();
  double grey = 120;     // in full light
  double mottle = 8;     // grey levels, largest deviation of the texture
  double texels = 1200;  // texels of the texture per metre
};

enum class SurfacePattern { plain, chess, dots, lines, printed };

/// A flat thing, seen from both sides: the normal is z, columns run along x and rows along y. Chess patterns have a
/// white border where half_size exceeds the cells.
struct Plate {
  Rigid frame_from_plate;
  Vector2 half_size = {0.1, 0.1};  // m
  SurfacePattern pattern = SurfacePattern::plain;
  int columns = 2, rows = 2;
  double cell = 0.02;             // m: chess cell, or distance between dots or lines
  double dark = 50, light = 190;  // grey levels in full light
  /// Printed: what is black, in the frame of a target's piece, whose y runs down and whose `print_middle` (m) lies
  /// here.
  std::shared_ptr<const BlackAt> print = {};
  Vector2 print_middle = Vector2::Zero();
};

/// Uneven light, written in the root frame.
struct Light {
  Vector3 direction = Vector3::UnitZ();  // unit, toward the lamp
  double ambient = 0.6;                  // share of full light where the lamp does not reach
  Vector3 gradient = Vector3::Zero();    // 1/m: share of light gained per metre from `center`
  Vector3 center = Vector3::Zero();
  Vector3 shadow_normal = Vector3::UnitX();  // a shadow band: |normal . (x - center) - offset| < half_width
  double shadow_offset = 0, shadow_half_width = 0.05, shadow_edge = 0.04;  // m; edge: width of the soft border
  double shadow_depth = 0;  // share of the light that is lost in the band; 0: no shadow
};

/// The room is a box, axes along the root frame's, seen from inside.
struct Scene {
  std::vector<MarkerPlate> markers;  // in the TCP frame
  std::vector<Solid> hand;           // in the TCP frame
  std::vector<Plate> hand_plates;    // printed dots and lines, in the TCP frame
  std::vector<Solid> solids;         // in the root frame
  std::vector<Plate> plates;         // in the root frame: X-corners that are no markers, dots, lines, posters
  Vector3 room_lower = Vector3(-3, -3, -1), room_upper = Vector3(3, 3, 2);  // m
  Light light;
  Texture texture;
};

}  // namespace handsight
