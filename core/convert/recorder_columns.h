// SPDX-License-Identifier: Apache-2.0
// Points of robot programs, and columns as two recorders name them: `rostopic echo -p` of ROS 1, and UR's RTDE.
#pragma once

#include "readers/table.h"

namespace handsight {

/// parse_table, and such columns get the names by which they are known: "%time" is time, "field.pose.position.x"
/// pose.position.x, "field.position0" the joint that "field.name0" names, actual_TCP_pose_0 to _5 (else
/// target_TCP_pose_) are x y z and a rotation vector.
std::optional<Table> parse_recorded_table(std::string_view text, const std::string& file,
                                          const std::vector<std::string>& names = {});

}  // namespace handsight
