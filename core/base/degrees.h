// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace handsight {

/// Degrees of one radian.
inline constexpr double degrees = 57.29577951308232;

}  // namespace handsight
