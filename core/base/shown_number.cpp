// SPDX-License-Identifier: Apache-2.0
#include "base/shown_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace handsight {

std::string shown_number(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  constexpr int most = 12;
  const int wanted = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  const int decimals = std::clamp(wanted, 0, most);
  // 9.96 to two digits is 10, which has one decimal less.
  const double rounded = std::round(std::abs(value) * std::pow(10, decimals)) / std::pow(10, decimals);
  const bool has_grown = rounded > 0 && digits - 1 - static_cast<int>(std::floor(std::log10(rounded))) < wanted;
  return fmt::format("{:.{}f}", value, std::max(decimals - (has_grown ? 1 : 0), 0));
}

}  // namespace handsight
