// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "effects/effect.h"

namespace handsight {

/// The unit of a number of an effect at a place. The catalogue speaks of joints that turn; what moves a sliding joint's
/// own position is in metres where theirs is in radians, per newton where theirs is per newton metre.
std::string unit_at(const Effect& effect, std::size_t parameter, int place, const Robot& robot);

/// The unit with a prefix under which a number of this size (in `unit`, positive) is between 1 and 1000, and what the
/// number is multiplied by for it: "urad/(N m)" and 1e6 of 1.5e-4 rad/(N m). Other units than those of angle, length
/// and time, and numbers of 1 and more, stay as they are.
std::pair<std::string, double> readable_unit(const std::string& unit, double size);

}  // namespace handsight
