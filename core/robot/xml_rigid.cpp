// SPDX-License-Identifier: Apache-2.0
#include "robot/xml_rigid.h"

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

void write_rigid(tinyxml2::XMLElement& element, const Rigid& motion) {
  const Vector3 angles = rpy_from_rotation(motion.rotation);
  element.SetAttribute("xyz", format_numbers({motion.translation.data(), 3}).c_str());
  element.SetAttribute("rpy", format_numbers({angles.data(), 3}).c_str());
}

}  // namespace handsight
