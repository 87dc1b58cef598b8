// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "effects/effect.h"

namespace handsight {

/// The unit of a number of an effect at a place. The catalogue speaks of joints that turn; what moves a sliding joint's
/// own position is in metres where theirs is in radians, per newton where theirs is per newton metre.
std::string unit_at(const Effect& effect, std::size_t parameter, int place, const Robot& robot);

}  // namespace handsight
