// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "effects/effect.h"

namespace handsight {

/// Where the names of a model begin among its estimated terms: after the session's own, `own` of them, and what is
/// there a little at each joint beside these (background.h).
inline std::size_t begin_of_names(const std::vector<EffectTerm>& estimated, std::size_t own) {
  std::size_t first = own;
  while (first < estimated.size() && is_small(estimated[first])) ++first;
  return first;
}

}  // namespace handsight
