// SPDX-License-Identifier: Apache-2.0
#include "base/image_names.h"

#include <algorithm>
#include <regex>
#include <set>

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// Digits of a fraction, cut or filled up to so many.
std::string filled(std::string digits, std::size_t count) {
  digits.resize(count, '0');
  return digits;
}

NamedMoment moment_of(const std::smatch& found, const std::string& digits) {
  const auto begin = static_cast<std::size_t>(found.position(1));
  return {std::stoll(digits), begin, begin + static_cast<std::size_t>(found.length(1))};
}

std::vector<std::string> list_parts(const fs::path& folder) {
  std::vector<std::string> parts;
  for (const fs::path& part : folder.lexically_normal())
    if (!part.empty()) parts.push_back(part.string());
  std::reverse(parts.begin(), parts.end());
  return parts;
}

}  // namespace

std::optional<NamedMoment> moment_in_name(const std::string& name) {
  if (name.size() > 300) return std::nullopt;
  static const std::regex date(
      "(?:^|[^0-9])(((?:19|20)[0-9]{2})[-_.]?(0[1-9]|1[0-2])[-_.]?(0[1-9]|[12][0-9]|3[01])[-_. tT]{0,3}"
      "([01][0-9]|2[0-3])[-_.:hH]?([0-5][0-9])[-_.:mM]?([0-5][0-9])(?:[-_.,]?([0-9]{1,9}))?)(?![0-9])");
  static const std::regex seconds("(?:^|[^0-9])((1[0-9]{9})\\.([0-9]{3,9}))(?![0-9])");
  std::smatch found;
  if (std::regex_search(name, found, date)) {
    std::string digits;
    for (std::size_t i = 2; i <= 7; ++i) digits += found.str(i);
    return moment_of(found, digits + filled(found.str(8), 4));
  }
  if (std::regex_search(name, found, seconds)) return moment_of(found, found.str(2) + filled(found.str(3), 6));
  return std::nullopt;
}

std::vector<std::string> telling_names(const std::vector<fs::path>& folders) {
  std::vector<std::vector<std::string>> parts;
  std::size_t deepest = 0;
  for (const fs::path& folder : folders) {
    parts.push_back(list_parts(folder));
    deepest = std::max(deepest, parts.back().size());
  }
  std::vector<std::string> names;
  for (std::size_t level = 0; level < deepest; ++level) {
    names.clear();
    std::set<std::string> once;
    for (const auto& p : parts) {
      names.push_back(level < p.size() ? p[level] : "");
      once.insert(names.back());
    }
    if (once.size() == folders.size() && !once.contains("")) return names;
  }
  names.clear();
  for (const auto& p : parts) names.push_back(p.empty() ? "" : p.front());
  return names;
}

}  // namespace handsight
