// SPDX-License-Identifier: Apache-2.0
// Numbers in sentences for people.
#pragma once

#include <string>

namespace handsight {

/// To so many significant digits, never with an exponent: 0.019, 49, 1200 (a whole number keeps all its digits). A
/// number that is not finite: "-".
std::string shown_number(double value, int digits = 2);

}  // namespace handsight
