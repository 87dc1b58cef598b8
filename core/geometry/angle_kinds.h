// SPDX-License-Identifier: Apache-2.0
// How a table's three or four numbers tell a rotation: every maker has a way of its own.
#pragma once

#include <string>
#include <vector>

#include "geometry/rigid.h"

namespace handsight {

enum class AngleKind {
  quaternion_xyzw,
  quaternion_wxyz,
  rotation_vector,  // axis times angle: UR, solvePnP, ViSP
  rpy,              // turns about the fixed axes x, y, z: ROS, Fanuc (W P R), Yaskawa, Mitsubishi (A B C)
  zyx,              // about z, then the new y, then the new x: KUKA (A B C), Epson (U V W)
  zyz,              // about z, the new y, the new z: Kawasaki (O A T), Doosan (A B C), Comau
  moving_xyz,       // about x, the new y, the new z: Staubli
  matrix,           // nine numbers, row by row
};

/// What a name stands for ("rotation_vector", "rpy", "abc", "wpr", "oat", "staubli" ...), and whether who calls it so
/// writes degrees where nothing says otherwise. InputError with all the names where it is none.
struct NamedAngleKind {
  AngleKind kind = AngleKind::rpy;
  bool usually_degrees = false;
};
NamedAngleKind named_angle_kind(const std::string& name);

/// The names, those first that are shown to people.
const std::vector<std::string>& angle_kind_names();

/// The name by which --angles takes it.
const char* angle_kind_name(AngleKind kind);

/// "rotation vectors (axis times angle)".
const char* angle_kind_text(AngleKind kind);

/// How many numbers it has: 3, 4 or 9.
std::size_t angle_count(AngleKind kind);

/// The rotation of so many numbers, angles in rad. A quaternion is made of length one, a matrix the nearest rotation.
Matrix3 rotation_by(AngleKind kind, const std::vector<double>& numbers);

}  // namespace handsight
