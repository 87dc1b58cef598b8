// SPDX-License-Identifier: Apache-2.0
// Several sessions of one robot as one: what belongs to the robot is shared, mounts and bodies where that is said.
#pragma once

#include "session/session.h"

namespace handsight {

/// One of the sessions, and what it shares with others.
struct JoinedMember {
  Session session;
  std::string title = {};  // what it is called; unique
  std::string rig =
      {};  // members with the same name have the same cameras or tracker at the same place; empty: its own
  std::string body = {};              // members with the same name have the same body on the same TCP; empty: its own
  std::vector<std::string> own = {};  // SessionPart::own
  /// The noise of one coordinate of its sensor (px, m); absent: as declared, or not known.
  std::optional<double> noise = {};
};

/// One session of them all. Observations come part after part: ids and times go on from part to part, markers, cameras,
/// mounts and joints are numbered through (SessionPart says how), and each observation knows its place in its own
/// session. Residuals of all count by their sensors' noise: where these are known and differ, or sensors differ in
/// kind, every sighting is given its sigma in the unit of the first part's cameras (px), or of its tracker (m). `file`
/// is the collection's; absent: the first session's. A single member comes back as it is. InputError names what the
/// members cannot have in common: robots that differ (with both values), gravity, a shared rig with other cameras, a
/// shared body with other markers or on another TCP, more than max_cameras cameras together, poses or noise of which
/// nothing is known beside another kind of sensor.
Session joined(const std::vector<JoinedMember>& members, const std::string& title,
               const std::filesystem::path& file = {});

/// The touches of one body of a joined session as a session of touches again, with their fixtures; nothing where it
/// touched none.
std::optional<Session> touches_of_body(const Session& joined, int body);

/// One part of a joined session by itself again: as it was, but for joints of other parts, which stand still.
Session part_session(const Session& joined, int part);

/// Throws InputError with what differs first between two robots, and both values, where they are not one: links with
/// their masses, joints with their kinds, places, axes and springs. Meshes and limits may differ.
void require_same_robot(const Session& a, const Session& b);

}  // namespace handsight
