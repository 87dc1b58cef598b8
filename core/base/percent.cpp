// SPDX-License-Identifier: Apache-2.0
#include "base/percent.h"

#include <fmt/format.h>

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
  if (percent >= 99) return whole_percent(share);
  return percent < 1e-4 ? "0" : fmt::format("{:.2g}", percent);  // within these there is no exponent
}

}  // namespace handsight
