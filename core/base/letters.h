// SPDX-License-Identifier: Apache-2.0
// What is done with the letters of a text.
#pragma once

#include <string>
#include <string_view>

namespace handsight {

/// A to Z in lower case; other letters, bytes of UTF-8 among them, stay.
std::string lower_case(std::string text);

/// Without the blanks, tabs and carriage returns at its ends, or without what else is `around` it.
std::string trimmed(std::string_view text, std::string_view around = " \t\r");

}  // namespace handsight
