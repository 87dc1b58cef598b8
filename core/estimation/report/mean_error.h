// SPDX-License-Identifier: Apache-2.0
// The error of parts of a session as one.
#pragma once

#include "estimation/report/error_summary.h"

namespace handsight {

/// Root mean squares of parts as that of all together, each weighing as much as it has observations.
class MeanError {
 public:
  void add(const ErrorSummary& part, double weight);
  ErrorSummary all() const;

 private:
  double weight_ = 0, hand_ = 0, pixel_ = 0, metre_ = 0, mean_ = 0, largest_ = 0;
  bool has_pixel_ = false, has_metre_ = false, has_hand_ = false;
};

}  // namespace handsight
