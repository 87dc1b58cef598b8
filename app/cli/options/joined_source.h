// SPDX-License-Identifier: Apache-2.0
// Several sessions as one, as a command is given them.
#pragma once

#include <string>
#include <vector>

#include "estimation/fit/joined_collection.h"

namespace handsight::cli {

/// The collection that paths make: nothing shared but the robot, and the rigs and bodies of these lists ("A,B", the
/// paths as given or their last parts). InputError names a list that names none of them.
Collection gather_collection(const std::vector<std::string>& paths, const std::vector<std::string>& same_rig,
                             const std::vector<std::string>& same_body);

}  // namespace handsight::cli
