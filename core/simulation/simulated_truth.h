// SPDX-License-Identifier: Apache-2.0
// A simulated session with what is true in it.
#pragma once

#include <vector>

#include "effects/effect.h"
#include "session/session.h"

namespace handsight {

/// An image point that is a wrong corner.
struct WrongCorner {
  std::int64_t id = 0;  // of the observation
  int marker = 0;
  int camera = 0;                 // of the rig
  Vector2 off = Vector2::Zero();  // px
};

/// What was simulated.
struct SimulatedSession {
  Session session;  // every marker labelled in every camera that sees it, by="import"
  std::vector<Vector3> markers_in_tcp;
  Vector3 normal_in_tcp = Vector3::UnitZ();  // the marker plane's outward normal
  std::vector<Vector3> normals_in_tcp;       // of each marker of a body of tags that look different ways; else empty
  Rigid mount_from_sensor;                   // the true one, before any effect
  std::optional<Rig> true_rig;               // with the effects on rig and cameras
  std::vector<EffectTerm> effects;
  double noise = 0;
  std::vector<WrongCorner> wrong_corners;
  /// Per observation, for rendering: where things truly were. Cameras but the first may have taken theirs later.
  std::vector<Rigid> root_from_tcp, root_from_sensor, later_root_from_tcp, later_root_from_sensor;
  std::vector<std::vector<Vector3>> markers;  // m, TCP frame, in this observation
};

}  // namespace handsight
