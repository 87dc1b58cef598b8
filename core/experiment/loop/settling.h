// SPDX-License-Identifier: Apache-2.0
// When it is settled what is missing, by one diagnosis after another.
#pragma once

#include "experiment/loop/knowledge.h"

namespace handsight {

class Settling {
 public:
  /// `odds` that are asked for.
  explicit Settling(double odds) : odds_(odds) {}

  /// Does this diagnosis, which comes after those before it, settle the cause? By the odds in two diagnoses in a row,
  /// all but a name from least_for_none observations on; a name by fifty times the odds at once.
  bool is_settled_by(const Knowledge& known);

 private:
  double odds_;
  std::optional<SettledCause> before_;  // what the diagnosis before told
};

}  // namespace handsight
