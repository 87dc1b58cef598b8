// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/mean_error.h"

#include <algorithm>
#include <cmath>

namespace handsight {

void MeanError::add(const ErrorSummary& part, double weight) {
  weight_ += weight;
  const auto square = [&](const std::optional<double>& v, double& sum) { sum += v ? weight * *v * *v : 0; };
  square(part.rms_pixel, pixel_);
  square(part.rms_m, metre_);
  square(part.hand_m, hand_);
  mean_ += part.mean_m ? weight * *part.mean_m : 0;
  largest_ = std::max(largest_, part.max_m.value_or(0));
  has_pixel_ = has_pixel_ || part.rms_pixel;
  has_metre_ = has_metre_ || part.rms_m;
  has_hand_ = has_hand_ || part.hand_m;
}

ErrorSummary MeanError::all() const {
  ErrorSummary e;
  if (has_pixel_) e.rms_pixel = std::sqrt(pixel_ / weight_);
  if (has_metre_) {
    e.rms_m = std::sqrt(metre_ / weight_);
    e.mean_m = mean_ / weight_;
    e.max_m = largest_;
  }
  if (has_hand_) e.hand_m = std::sqrt(hand_ / weight_);
  return e;
}

}  // namespace handsight
