// SPDX-License-Identifier: Apache-2.0
// What drivers do wrong, on demand.
#pragma once

#include <string>
#include <vector>

namespace handsight {

struct FaultKind {
  const char* name;
  const char* what;  // for people
};

/// All that handsight-driver-simulated can do wrong.
const std::vector<FaultKind>& fault_kinds();

/// "hangs@3": from the third move on; without a number from the second one.
struct Fault {
  std::string name;
  int from_move = 2;
};

/// InputError lists the kinds where the name is none.
Fault parse_fault(const std::string& text);

}  // namespace handsight
