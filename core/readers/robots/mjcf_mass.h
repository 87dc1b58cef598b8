// SPDX-License-Identifier: Apache-2.0
// Masses of a MuJoCo model's bodies.
#pragma once

#include <vector>

#include "readers/robots/mjcf_model.h"

namespace handsight::mjcf {

struct Mass {
  double kilograms = 0;
  Vector3 center = Vector3::Zero();  // m, in the body's frame
};

/// Of its <inertial>, else of its geoms by their mass or their volume and density (1000 kg/m^3 where none is given).
/// Of a mesh only a mass that is given counts, and it is taken to lie in the geom's place.
Mass read_mass(const Element& body, const std::vector<Element>& geoms);

/// What a geom's shape is: half lengths as MuJoCo has them, its place in the body.
struct MassShape {
  std::string kind;  // "sphere", "capsule", "cylinder", "ellipsoid", "box", "mesh", ...
  Vector3 size = Vector3::Zero();
  Rigid place;
};
MassShape make_shape(const Element& geom);

}  // namespace handsight::mjcf
