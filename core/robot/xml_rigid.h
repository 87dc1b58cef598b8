// SPDX-License-Identifier: Apache-2.0
// Vectors and rigid motions as XML attributes: xyz (m) and rpy (rad, XYZ fixed angles).
#pragma once

#include "base/xml.h"
#include "geometry/rigid.h"

namespace handsight {

/// Three finite numbers within bounds.
std::optional<Vector3> find_vector(const XmlNode& node, const char* attribute, const Bounds& within);

/// The motion of xyz="" rpy=""; what is missing is zero.
Rigid read_rigid(const XmlNode& node, const Bounds& xyz_within = bounds::length);

/// The motion of xyz="" with quaternion="x y z w" (of length 1 within 1 %) or rpy=""; xyz must be there.
Rigid read_pose(const XmlNode& node);

/// Sets xyz and quaternion.
void write_pose(tinyxml2::XMLElement& element, const Rigid& motion);

/// Sets xyz and rpy. The angles read back to the same rotation within rounding.
void write_rigid(tinyxml2::XMLElement& element, const Rigid& motion);

}  // namespace handsight
