// SPDX-License-Identifier: Apache-2.0
// Surfaces of links from Collada files (.dae), of which many robots' visible shapes are.
#pragma once

#include <string>
#include <string_view>

#include "robot/mesh_types.h"

namespace handsight {

/// The triangles of a Collada text where its scene puts them (all its geometries where it has none), in m by its unit:
/// <triangles>, <polylist> and <polygons> as fans. Colours, normals and lines are passed over. `up_axis` is not looked
/// at: URDF's meshes are in the link's frame as they stand, whatever it says. InputError names the line of what is
/// wrong; `file` is what sentences call it.
Mesh parse_collada(std::string_view text, const std::string& file);

}  // namespace handsight
