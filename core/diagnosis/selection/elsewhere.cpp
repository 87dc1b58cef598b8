// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/elsewhere.h"

#include <fmt/format.h>

#include "diagnosis/verdict/explanation.h"

namespace handsight {

static constexpr double most_elsewhere = 1.02;  // times the error before: chance of where regions end

std::string worse_elsewhere(const Diagnosis& before, Diagnosis& after) {
  const auto size = [](const ErrorSummary& e) { return e.rms_pixel ? e.rms_pixel : e.rms_m; };
  after.report.held_out_region = region_error(after);
  const ErrorSummary was = region_error(before), &is = after.report.held_out_region;
  if (!size(was) || !size(is) || *size(is) <= most_elsewhere * *size(was)) return "";
  return fmt::format("where a whole region of poses is held out, the error rises from {} to {}", error_text(was),
                     error_text(is));
}

}  // namespace handsight
