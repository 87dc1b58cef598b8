// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/settling.h"

namespace handsight {
namespace {

constexpr double at_once = 50;  // times the odds: most that are wrong are just above them, at the first look that is

bool is_told(const Knowledge& known, double odds) {
  if (!known.settled) return false;
  const SettledCause& cause = *known.settled;
  if (!cause.id.empty()) return cause.odds >= odds;
  if (known.used < least_for_none) return false;
  return cause.follows ? cause.odds >= odds : known.diagnosis->verdict == Verdict::adequate && cause.odds >= 1;
}

bool is_same(const SettledCause& a, const SettledCause& b) {
  return a.id == b.id && a.where == b.where && a.follows.has_value() == b.follows.has_value();
}

}  // namespace

bool Settling::is_settled_by(const Knowledge& known) {
  if (!is_told(known, odds_)) {
    before_.reset();
    return false;
  }
  const SettledCause& cause = *known.settled;
  const bool is_again = before_ && is_same(*before_, cause);
  before_ = cause;
  return is_again || (!cause.id.empty() && cause.odds >= at_once * odds_);
}

}  // namespace handsight
