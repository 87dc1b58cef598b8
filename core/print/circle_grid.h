// SPDX-License-Identifier: Apache-2.0
// Grids of circles, as OpenCV and Kalibr have them. In a Target they are chessboards whose `dictionary` says how the
// circles stand ("symmetric": in columns; "asymmetric": every second row half a column to the right), whose `square` is
// OpenCV's unit (the step between circles; half of it along a row of an asymmetric grid) and whose `tag` is a circle's
// diameter. Points are the circles' middles, row by row; the frame has its origin in the first one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace handsight {

struct Target;
struct TargetPoint;

inline constexpr std::string_view circles_kind = "circles";

bool is_circle_grid(const Target& target);
bool is_asymmetric(const Target& target);

/// The circles' middles.
std::vector<TargetPoint> circle_points(const Target& target);

/// InputError with one sentence that begins with `where` unless circles can be so: they must not touch.
void check_circles(const Target& target, std::string_view where);

/// "asymmetric grid of 4 x 11 circles of 15 mm, unit 20 mm".
Message circles_description(const Target& target);

}  // namespace handsight
