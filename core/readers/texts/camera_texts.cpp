// SPDX-License-Identifier: Apache-2.0
#include "readers/texts/camera_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/letters.h"
#include "base/numbers.h"
#include "readers/texts/cells.h"

namespace handsight {
namespace {

constexpr std::size_t longest_text = 2000;  // bytes

bool is_matrix(const std::vector<double>& n) {
  return n.size() == 9 && n[0] > 1 && n[4] > 1 && n[3] == 0 && n[6] == 0 && n[7] == 0 && n[8] == 1;
}

/// OpenCV's counts of a lens's numbers.
bool is_lens(const std::vector<double>& n) {
  return n.size() == 4 || n.size() == 5 || n.size() == 8 || n.size() == 12 || n.size() == 14;
}

}  // namespace

std::optional<std::string> camera_entries(const std::string& text, const std::string& name) {
  if (text.size() > longest_text) return std::nullopt;
  std::string plain = text;
  std::replace_if(
      plain.begin(), plain.end(),
      [](char c) { return std::string_view("[](),;\r\n\t").find(c) != std::string_view::npos; }, ' ');
  const auto numbers = parse_numbers(plain);
  if (!numbers) return std::nullopt;
  if (is_matrix(*numbers)) return fmt::format("K: [{}]\n", fmt::join(*numbers, ", "));
  const std::string small = lower_case(name);
  const bool says_lens =
      (small.find("dist") != std::string::npos && small.find("distan") == std::string::npos) || small == "d";
  return says_lens && is_lens(*numbers) ? std::optional(fmt::format("D: [{}]\n", fmt::join(*numbers, ", ")))
                                        : std::nullopt;
}

}  // namespace handsight
