// SPDX-License-Identifier: Apache-2.0
// Whether the tags of an ArUco grid lie in the image as the grid's description has them.
#pragma once

#include "targets/found_target.h"

namespace handsight {

/// Each tag, extended as a plane, says where its neighbours of the same row and column are; a lens bends little over so
/// short a way. False where most of those that were seen, three at least, are elsewhere: another number of columns,
/// another first tag. True of what is no such grid.
bool lies_as_described(const TargetSighting& sighting, const PreparedTarget& target);

}  // namespace handsight
