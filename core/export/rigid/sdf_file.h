// SPDX-License-Identifier: Apache-2.0
// The calibrated robot as SDFormat 1.7 (Gazebo).
#pragma once

#include "base/message.h"
#include "export/rigid/described_robot.h"

namespace handsight {

/// One model, its root fixed to the world; links posed by the joints that carry them, which are posed in their parents.
/// Links without mass that no joint moves are frames. A link called "world" is called "world_link", a joint that is
/// called as a link gets
/// "_joint" after its name. SDFormat 1.7 has no
/// joint that follows others; `notes` names those.
std::string sdf_file(const DescribedRobot& robot, const std::filesystem::path& out_folder, std::vector<Message>& notes);

}  // namespace handsight
