// SPDX-License-Identifier: Apache-2.0
#include "base/letters.h"

#include <cctype>

namespace handsight {

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string trimmed(std::string_view text, std::string_view around) {
  const std::size_t begin = text.find_first_not_of(around);
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(around) - begin + 1));
}

}  // namespace handsight
