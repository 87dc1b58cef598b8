// SPDX-License-Identifier: Apache-2.0
#include "robot/xml_rigid.h"

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"

namespace handsight {

std::optional<Vector3> find_vector(const XmlNode& node, const char* attribute, const Bounds& within) {
  const auto numbers = find_numbers(node, attribute, 3, within);
  if (!numbers) return std::nullopt;
  return Vector3(numbers->data());
}

Rigid read_rigid(const XmlNode& node, const Bounds& xyz_within) {
  return {rotation_from_rpy(find_vector(node, "rpy", bounds::joint).value_or(Vector3::Zero())),
          find_vector(node, "xyz", xyz_within).value_or(Vector3::Zero())};
}

Rigid read_pose(const XmlNode& node) {
  Rigid motion = read_rigid(node);
  motion.translation = Vector3(required_numbers(node, "xyz", 3, bounds::length).data());
  const auto numbers = find_numbers(node, "quaternion", 4);
  if (!numbers) return motion;
  if (node.element->Attribute("rpy")) refuse(node, "has both quaternion and rpy, expected one of the two.");
  const Eigen::Quaterniond q((*numbers)[3], (*numbers)[0], (*numbers)[1], (*numbers)[2]);
  if (std::abs(q.norm() - 1) > 0.01)
    refuse(node, message("has a quaternion of length {:.4g}, expected \"x y z w\" of length 1.", q.norm()));
  motion.rotation = q.normalized().toRotationMatrix();
  return motion;
}

void write_pose(tinyxml2::XMLElement& element, const Rigid& motion) {
  const Eigen::Quaterniond q(motion.rotation);
  const double numbers[] = {q.x(), q.y(), q.z(), q.w()};
  element.SetAttribute("xyz", format_numbers({motion.translation.data(), 3}).c_str());
  element.SetAttribute("quaternion", format_numbers(numbers).c_str());
}

void write_rigid(tinyxml2::XMLElement& element, const Rigid& motion) {
  const Vector3 angles = rpy_from_rotation(motion.rotation);
  element.SetAttribute("xyz", format_numbers({motion.translation.data(), 3}).c_str());
  element.SetAttribute("rpy", format_numbers({angles.data(), 3}).c_str());
}

}  // namespace handsight
