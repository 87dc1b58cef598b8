// SPDX-License-Identifier: Apache-2.0
// A robot as simple solids that cover its links, and which of them need not be watched against each other.
#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "robot/mesh_types.h"
#include "session/session.h"

namespace handsight {

enum class RobotSolidKind { box, capsule, cylinder, sphere };

/// A solid on a link. `size`, m: box half lengths; capsule and cylinder radius, 0, half length along z (of a capsule
/// between its balls' middles); sphere radius.
struct RobotSolid {
  RobotSolidKind kind = RobotSolidKind::box;
  int link = 0;
  Rigid link_from_solid;
  Vector3 size = Vector3::Zero();

  /// m: the ball about its middle that holds it.
  double reach() const;
};

struct RobotSolids {
  std::vector<RobotSolid> solids;
  std::set<std::pair<std::string, std::string>> never_watched;  // pairs of links that an SRDF file leaves out
  std::vector<Message> notes;                                   // a sentence each
};

/// Boxes that together hold every triangle of a mesh: halves of halves along the longest side, as long as that saves
/// space, at most 8.
std::vector<RobotSolid> make_boxes(const Mesh& mesh, const Vector3& scale, int link, const Rigid& link_from_mesh);

/// Of the URDF's <collision> shapes, else its <visual> ones; a link that has none is a limb (a capsule) from its frame
/// to those of the joints on it, of a radius of 40 mm, 0.35 of the length of short ones, and a last one such a ball.
/// Beside the robot's file an SRDF file
/// (*.srdf) is read. A mesh that cannot be found or read counts as none, with a note.
RobotSolids robot_solids(const Session& session);

}  // namespace handsight
