// SPDX-License-Identifier: Apache-2.0
// Tables of motion capture as Motive (OptiTrack), Vicon's programs (Nexus, Tracker) and Qualisys's QTM export them:
// several lines of header, a column an axis of each rigid body or marker.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "readers/table.h"

namespace handsight {

struct MocapBody {
  std::string name;
  Table table;  // time and the columns of its pose, as `read_pose_table` has them
};

struct MocapTables {
  std::vector<MocapBody> bodies;
  Table markers;  // time and the columns of points, as `read_point_table` has them; no columns: there are none
  std::vector<Message> notes;
};

bool is_motive_csv(const std::string& text);
bool is_vicon_csv(const std::string& text);
bool is_qualisys_tsv(const std::string& text);

/// Rigid bodies (their turns as quaternions), or where there is none the markers. Markers of rigid bodies, and those
/// without a name, are left out, with a sentence. InputError where the file is not whole, or its turns are Euler
/// angles.
MocapTables read_motive_csv(const std::string& text, const std::string& file);

/// Sections "Objects" and "Segments" (rigid bodies), or "Trajectories" (markers); others are passed over.
MocapTables read_vicon_csv(const std::string& text, const std::string& file);

/// Rigid bodies ("6D", by their rotation matrices) or markers ("3D"); what QTM did not see (zeros) is missing. Lengths
/// are mm. InputError where the header does not go with the columns.
MocapTables read_qualisys_tsv(const std::string& text, const std::string& file);

/// That of these three which the text is; nothing: none.
std::optional<MocapTables> read_mocap(const std::string& text, const std::string& file);
bool is_mocap(const std::string& text);

}  // namespace handsight
