// SPDX-License-Identifier: Apache-2.0
// Robots of MuJoCo (MJCF) as URDF.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"

namespace handsight {

/// Is this text the file of a MuJoCo model?
bool is_mjcf(const std::string& text);

/// The model's bodies as links (the root is "world"), its hinges and slides as joints, its sites as links without
/// weight. Where a joint does not stand in its body's origin, or a body has several, links without weight lie between.
/// Free and ball joints stand still. `notes` says so, and what else a URDF has no word for. InputError where it is
/// wrong. Geoms that a URDF can say are drawn.
std::string urdf_of_mjcf(const std::filesystem::path& path, const std::string& file, std::vector<Message>& notes);

}  // namespace handsight
