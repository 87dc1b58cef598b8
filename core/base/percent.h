// SPDX-License-Identifier: Apache-2.0
// Shares and probabilities as percentages for people: never with an exponent, and 100 only where nothing is lacking.
#pragma once

#include <string>

namespace handsight {

/// Of a share from 0 to 1, without the sign: "0", "7", "64"; from 99.5 on with one more digit, and "100" from 99.95 on.
std::string whole_percent(double share);

/// The same to two digits where it is small: "0.12", "5.3", "64".
std::string two_digit_percent(double share);

}  // namespace handsight
