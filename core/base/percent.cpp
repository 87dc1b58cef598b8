// SPDX-License-Identifier: Apache-2.0
#include "base/percent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

constexpr double nothing_lacking = 99.95;

}  // namespace

std::string whole_percent(double share) {
  const double percent = 100 * share;
  if (percent >= 99.5 && percent < nothing_lacking) return fmt::format("{:.1f}", percent);
  return fmt::format("{:.0f}", percent);
}

std::string two_digit_percent(double share) {
  const double percent = 100 * share;
  if (percent >= 99 && percent < nothing_lacking) return fmt::format("{:.1f}", percent);
  if (!(percent > 0) || percent >= 10) return fmt::format("{:.0f}", percent);
  const int places = std::clamp(1 - static_cast<int>(std::floor(std::log10(percent))), 1, 6);
  return fmt::format("{:.{}f}", percent, places);
}

}  // namespace handsight
