// SPDX-License-Identifier: Apache-2.0
// The calibrated robot as a model of MuJoCo (MJCF).
#pragma once

#include "base/message.h"
#include "export/rigid/described_robot.h"

namespace handsight {

/// Bodies, joints (hinge and slide, radians, limits), inertials, shapes and meshes, an equality for each joint that
/// follows others, gravity. A link called "world" is called "world_link": MuJoCo keeps that name for itself. Meshes are
/// named relative to `out_folder`; those that MuJoCo 2.2 does not open (Collada, STL as text) and those that are not
/// there are left out, and `notes` says so.
std::string mjcf_file(const DescribedRobot& robot, const Vector3& gravity, const std::filesystem::path& out_folder,
                      std::vector<Message>& notes);

}  // namespace handsight
