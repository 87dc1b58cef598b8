// SPDX-License-Identifier: Apache-2.0
// The sessions of a collection as one.
#pragma once

#include <functional>

#include "session/collection.h"
#include "session/joined.h"

namespace handsight {

/// Opens one of the sessions by its path.
using OpenOne = std::function<Session(const std::string& path)>;

/// All sessions of a collection with what they share; each is opened by `open`.
std::vector<JoinedMember> opened_members(const Collection& collection, const OpenOne& open);

/// The same; where noise is not declared it is learned.
std::vector<JoinedMember> list_members(const Collection& collection, const OpenOne& open);

/// The same as one session.
Session join_collection(const Collection& collection, const OpenOne& open);

}  // namespace handsight
