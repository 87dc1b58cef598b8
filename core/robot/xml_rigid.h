// SPDX-License-Identifier: Apache-2.0
// Vectors and rigid motions as XML attributes: xyz (m) and rpy (rad, XYZ fixed angles).
#pragma once

#include "base/xml.h"
#include "geometry/rigid.h"

namespace handsight {

/// Three finite numbers.
std::optional<Vector3> find_vector(const XmlNode& node, const char* attribute);

/// The motion of xyz="" rpy=""; what is missing is zero.
Rigid read_rigid(const XmlNode& node);

/// Sets xyz and rpy. The angles read back to the same rotation within rounding.
void write_rigid(tinyxml2::XMLElement& element, const Rigid& motion);

}  // namespace handsight
