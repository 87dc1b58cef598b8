// SPDX-License-Identifier: Apache-2.0
// What stands for the variance of an angle or a length of which nothing is known.
#pragma once

#include <numbers>

namespace handsight {

/// rad^2: of an angle of which nothing is known.
inline constexpr double unknown_angle_variance = std::numbers::pi * std::numbers::pi / 3;

/// m: the sigma that stands for a length of which nothing is known.
inline constexpr double unknown_length = 10;

}  // namespace handsight
