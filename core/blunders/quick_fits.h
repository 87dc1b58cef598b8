// SPDX-License-Identifier: Apache-2.0
// What a reading of a session leaves once it is fitted, as it is and with the robot's geometry free.
#pragma once

#include <optional>

#include "geometry/rigid.h"
#include "session/session.h"

namespace handsight {

struct Left {
  double rms = 1e300;   // px or m, of one coordinate
  bool is_lost = true;  // more than few robots explain, or none that anybody should use
};

/// A quick fit of a small session (seen_points.h) from this mount.
Left left_by_plain(const Session& small, const std::optional<Rigid>& mount);

/// The same with offsets of all joints estimated, and with all numbers of the robot's geometry too. Of a robot that is
/// known by its poses only as left_by_plain.
Left left_by_offsets(const Session& small, const std::optional<Rigid>& mount);
Left left_by_geometry(const Session& small, const std::optional<Rigid>& mount);

}  // namespace handsight
