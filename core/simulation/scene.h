// SPDX-License-Identifier: Apache-2.0
// What the simulated cameras look at: a textured hand with chess labels in a room with things in it.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/hand.h"
#include "simulation/scene_parts.h"

namespace handsight {

/// Where the scene is needed, root frame (m). The root's z axis is taken to point up.
struct Workspace {
  Vector3 camera = Vector3(0, 0, 1.2);
  Vector3 hand = Vector3(0.6, 0, 0.9);  // the middle of where the hand will be
  double reach = 0.25;                  // m: how far from there the TCP may go
};

struct SceneOptions {
  std::uint64_t seed = 1;
  Workspace workspace;
  int distractor_corners = 24;  // X-corners that are no markers, on walls, table and boxes
  bool shadow = true;
  Vector3 fingers = Vector3::UnitZ();  // TCP frame: where the fingers point
};

/// A room, things in it, and a hand built to carry the markers: the palm lies under their mean plane, and each marker
/// stands on a flat facet of its own. `scene.markers[i].center` may be moved by millimetres afterwards: the label takes
/// its pedestal along.
Scene make_scene(const std::vector<MarkerPlate>& markers, const SceneOptions& options);

}  // namespace handsight
