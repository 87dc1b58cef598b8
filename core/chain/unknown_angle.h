// SPDX-License-Identifier: Apache-2.0
// The variance of an angle of which nothing is known.
#pragma once

#include <numbers>

namespace handsight {

/// rad^2: of an angle of which nothing is known.
inline constexpr double unknown_angle_variance = std::numbers::pi * std::numbers::pi / 3;

}  // namespace handsight
