// SPDX-License-Identifier: Apache-2.0
// One marker (thesis 4.2): the force at the TCP that pulls the springs of the arm toward the measured marker.
#pragma once

#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

struct OneMarkerOptions {
  int marker = 0;
  double default_stiffness = 1e4;  // N m/rad (N/m), of joints that declare none
  /// The marker in the TCP frame (m): the initial guess of thesis (4.45). Absent: from a fit of the session.
  std::optional<Vector3> marker_in_tcp;
};

/// Per observation. Vectors in the sensor's (first camera's) frame, m: commanded marker minus measured marker.
struct EffectiveMass {
  std::int64_t id = 0;
  double mass = 0;                   // kg: force = mass * 9.81 m/s^2 along the direction of the deviation before
  Vector3 before = Vector3::Zero();  // thesis (4.45)
  Vector3 after = Vector3::Zero();   // thesis (4.47) at the best mass
  /// What the springs can do at all: the angle (rad) between the deviation and the direction in which a force along it
  /// moves the marker. To first order |after| = |before| sin(angle).
  double angle = 0;
  double predicted_after = 0;  // m, |before| sin(angle)
};

struct OneMarkerResult {
  std::vector<EffectiveMass> observations;
  std::vector<std::int64_t> left_out;  // observations that do not show the marker as a point
  std::vector<std::string> joints;     // whose springs give way: of the TCP's chain, not of the mount's
  bool stiffness_is_assumed = false;   // some joint declares none
};

/// For every used observation that shows the marker as a point. Throws InputError where none does, or the marker or
/// its joints do not exist.
OneMarkerResult effective_masses(const Session& session, const OneMarkerOptions& options = {});

}  // namespace handsight
