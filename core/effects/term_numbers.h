// SPDX-License-Identifier: Apache-2.0
// The numbers of all terms of a model as one list, term after term: where each term's begin.
#pragma once

#include <Eigen/Core>

#include "effects/effect.h"

namespace handsight {

/// Where the numbers of each term begin, the first ones at `offset`; one entry more than terms: where the list ends.
inline std::vector<Eigen::Index> first_numbers(const std::vector<EffectTerm>& terms, Eigen::Index offset = 0) {
  std::vector<Eigen::Index> first{offset};
  for (const EffectTerm& term : terms) first.push_back(first.back() + static_cast<Eigen::Index>(term.values.size()));
  return first;
}

}  // namespace handsight
