// SPDX-License-Identifier: Apache-2.0
// Numbers in formulas that the program writes: of at most four digits, so that people can read them. What is computed
// beside a formula uses the number as it is written.
#pragma once

#include <fmt/format.h>

#include <string>

#include "base/numbers.h"

namespace handsight {

inline std::string short_number(double x) { return fmt::format("{:.4g}", x); }
inline double shortened_number(double x) { return parse_number(short_number(x)).value_or(x); }

}  // namespace handsight
