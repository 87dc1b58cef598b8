// SPDX-License-Identifier: Apache-2.0
#include "geometry/angle_kinds.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"

namespace handsight {
namespace {

struct Named {
  const char* name;
  NamedAngleKind kind;
};

const std::vector<Named>& all_named() {
  static const std::vector<Named> all{
      {"rotation_vector", {AngleKind::rotation_vector, false}},
      {"rpy", {AngleKind::rpy, false}},
      {"abc", {AngleKind::zyx, true}},
      {"wpr", {AngleKind::rpy, true}},
      {"oat", {AngleKind::zyz, true}},
      {"staubli", {AngleKind::moving_xyz, true}},
      {"quaternion_xyzw", {AngleKind::quaternion_xyzw, false}},
      {"quaternion_wxyz", {AngleKind::quaternion_wxyz, false}},
      {"zyx", {AngleKind::zyx, false}},
      {"zyz", {AngleKind::zyz, false}},
      {"moving_xyz", {AngleKind::moving_xyz, false}},
      {"kuka", {AngleKind::zyx, true}},
      {"fanuc", {AngleKind::rpy, true}},
      {"kawasaki", {AngleKind::zyz, true}},
      {"abb", {AngleKind::quaternion_wxyz, false}},
      {"ur", {AngleKind::rotation_vector, false}},
      {"yaskawa", {AngleKind::rpy, true}},
      {"mitsubishi", {AngleKind::rpy, true}},
      {"doosan", {AngleKind::zyz, true}},
      {"epson", {AngleKind::zyx, true}},
      {"xyzw", {AngleKind::quaternion_xyzw, false}},
      {"wxyz", {AngleKind::quaternion_wxyz, false}},
  };
  return all;
}

Matrix3 about(int axis, double angle) { return rotation_from_vector<double>(Vector3(angle * Vector3::Unit(axis))); }

Matrix3 of_quaternion(double w, double x, double y, double z) {
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

}  // namespace

const std::vector<std::string>& angle_kind_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Named& named : all_named()) list.emplace_back(named.name);
    return list;
  }();
  return names;
}

NamedAngleKind named_angle_kind(const std::string& name) {
  for (const Named& named : all_named())
    if (name == named.name) return named.kind;
  throw InputError(message("--angles {}: is no way to tell a rotation; expected one of: {}.", in_quotes(name),
                           fmt::join(angle_kind_names(), " ")));
}

const char* angle_kind_name(AngleKind kind) {
  switch (kind) {
    case AngleKind::quaternion_xyzw:
      return "quaternion_xyzw";
    case AngleKind::quaternion_wxyz:
      return "quaternion_wxyz";
    case AngleKind::rotation_vector:
      return "rotation_vector";
    case AngleKind::rpy:
      return "rpy";
    case AngleKind::zyx:
      return "zyx";
    case AngleKind::zyz:
      return "zyz";
    case AngleKind::moving_xyz:
      return "moving_xyz";
    case AngleKind::matrix:
      return "matrix";
  }
  return "";
}

const char* angle_kind_text(AngleKind kind) {
  switch (kind) {
    case AngleKind::quaternion_xyzw:
      return "quaternions with w last";
    case AngleKind::quaternion_wxyz:
      return "quaternions with w first";
    case AngleKind::rotation_vector:
      return "rotation vectors (axis times angle)";
    case AngleKind::rpy:
      return "roll, pitch, yaw (turns about the fixed axes x, y, z)";
    case AngleKind::zyx:
      return "turns about z, then the new y, then the new x (A B C of KUKA)";
    case AngleKind::zyz:
      return "turns about z, then the new y, then the new z (O A T of Kawasaki)";
    case AngleKind::moving_xyz:
      return "turns about x, then the new y, then the new z (RX RY RZ of Staubli)";
    case AngleKind::matrix:
      return "matrices";
  }
  return "";
}

std::size_t angle_count(AngleKind kind) {
  if (kind == AngleKind::matrix) return 9;
  return kind == AngleKind::quaternion_xyzw || kind == AngleKind::quaternion_wxyz ? 4 : 3;
}

Matrix3 rotation_by(AngleKind kind, const std::vector<double>& n) {
  check(n.size() == angle_count(kind), "{} numbers for a rotation of kind {}", n.size(), angle_kind_name(kind));
  switch (kind) {
    case AngleKind::quaternion_xyzw:
      return of_quaternion(n[3], n[0], n[1], n[2]);
    case AngleKind::quaternion_wxyz:
      return of_quaternion(n[0], n[1], n[2], n[3]);
    case AngleKind::rotation_vector:
      return rotation_from_vector<double>(Vector3(n[0], n[1], n[2]));
    case AngleKind::rpy:
      return rotation_from_rpy({n[0], n[1], n[2]});
    case AngleKind::zyx:
      return about(2, n[0]) * about(1, n[1]) * about(0, n[2]);
    case AngleKind::zyz:
      return about(2, n[0]) * about(1, n[1]) * about(2, n[2]);
    case AngleKind::moving_xyz:
      return about(0, n[0]) * about(1, n[1]) * about(2, n[2]);
    case AngleKind::matrix:
      return nearest_rotation((Matrix3() << n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]).finished());
  }
  return Matrix3::Identity();
}

}  // namespace handsight
