// SPDX-License-Identifier: Apache-2.0
// Several sessions as one, as a command is given them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "session/collection.h"

namespace handsight::cli {

/// Opens one of the sessions by its path.
using OpenOne = std::function<Session(const std::string& path)>;

/// All sessions of a collection as one; each is opened by `open`. Where noise is not declared it is learned.
Session joined_of(const Collection& collection, const OpenOne& open);

/// The collection that paths make: nothing shared but the robot, and the rigs and bodies of these lists ("A,B", the
/// paths as given or their last parts). InputError names a list that names none of them.
Collection collection_of(const std::vector<std::string>& paths, const std::vector<std::string>& same_rig,
                         const std::vector<std::string>& same_body);

}  // namespace handsight::cli
