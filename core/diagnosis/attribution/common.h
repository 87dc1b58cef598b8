// SPDX-License-Identifier: Apache-2.0
// What do these observations have in common? The variables in the order in which a range of them parts the chosen from
// the rest.
#pragma once

#include "base/message.h"
#include "diagnosis/curves/variables.h"

namespace handsight {

/// One variable's best range.
struct Common {
  std::size_t variable = 0;    // into the list given
  double low = 0, high = 0;    // of the variable; infinite where the range is open to that side
  int chosen = 0, others = 0;  // observations inside the range
  int all_chosen = 0, all_others = 0;
  double parted = 0;  // share of the chosen inside less share of the others inside: 1 parts them without exception
};

/// `is_chosen` per observation, as Variable::values. Best first; empty where all or none are chosen.
std::vector<Common> what_is_common(const std::vector<Variable>& variables, const std::vector<char>& is_chosen);

/// "All 14 have the angle of arm_4 above 1.20 rad; of the other 86 only 3."
Message common_text(const Common& common, const Variable& variable);

}  // namespace handsight
