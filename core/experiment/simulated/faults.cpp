// SPDX-License-Identifier: Apache-2.0
#include "experiment/simulated/faults.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {

const std::vector<FaultKind>& fault_kinds() {
  static const std::vector<FaultKind> kinds = {
      {"dies", "ends without an answer to a move"},
      {"dies_at_hello", "ends before it has said hello"},
      {"dies_at_look", "ends without an answer to a look"},
      {"hangs", "never answers a move"},
      {"hangs_at_look", "never answers a look"},
      {"lies", "says that it stands where it was sent, and looks from elsewhere"},
      {"elsewhere", "arrives 2 degrees from where it was sent"},
      {"nonsense", "answers a move with what is no JSON"},
      {"wrong_id", "repeats the id of another message"},
      {"too_few_joints", "answers with a joint too few"},
      {"not_a_number", "answers with a position that is no number"},
      {"no_position", "does not say where it stands"},
      {"endless", "answers with a line that does not end"},
      {"closes", "closes its output and goes on"},
      {"no_image", "names images that are not there"},
      {"refuses", "refuses every move"},
      {"blind", "sees nothing"}};
  return kinds;
}

Fault parse_fault(const std::string& text) {
  Fault fault;
  const auto at = text.find('@');
  fault.name = text.substr(0, at);
  std::string names;
  bool is_known = false;
  for (const FaultKind& kind : fault_kinds()) {
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
    is_known = is_known || fault.name == kind.name;
  }
  if (!is_known) throw InputError(message("--fault {}: expected one of {}.", in_quotes(text), names));
  if (at == std::string::npos) return fault;
  const auto from = parse_integer(text.substr(at + 1));
  if (!from || *from < 1 || *from > 100000)
    throw InputError(message("--fault {}: expected the number of a move after the @, from 1 on.", in_quotes(text)));
  fault.from_move = static_cast<int>(*from);
  return fault;
}

}  // namespace handsight
