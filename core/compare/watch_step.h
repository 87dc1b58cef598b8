// SPDX-License-Identifier: Apache-2.0
// What a ChangeWatch says after each observation.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "effects/effect.h"

namespace handsight {

/// By how much something would have changed if it alone had.
struct WatchedChange {
  std::string what, where;  // as in WatchStep
  std::vector<EffectTerm> terms;
  Eigen::VectorXd sigma;
};

/// What is said after one more observation.
struct WatchStep {
  double ln_e_value = 0;  // ln of the e-value: evidence that something has changed, at some time so far
  bool changed = false;   // an e-value of 1000 or more has been reached, now or before
  std::string what;       // id of the likeliest change, as compare names it
  std::string where;      // joint or marker; empty: it has no place
  std::vector<std::string> indistinguishable_from;  // other ids that explain it nearly as well (odds below 20)
  std::vector<EffectTerm> terms;                    // with its size
  Eigen::VectorXd sigma;                            // of the numbers that are no choices, in their order
  Message text;                                     // "The camera turned by ... on its mount"
  std::vector<WatchedChange> each;                  // of all changes, from when the likeliest may have come
};

struct WatchOptions {
  double chance = 1e-3;     // of ever saying that something has changed where nothing has
  std::size_t window = 60;  // observations back to which a change may have come (and the very first one)
};

}  // namespace handsight
