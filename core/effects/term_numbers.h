// SPDX-License-Identifier: Apache-2.0
// The numbers of the terms of a model.
#pragma once

#include <Eigen/Core>

#include "effects/effect.h"

namespace handsight {

/// All numbers of a term at 0, choices as they are.
inline void clear_numbers(EffectTerm& term) {
  const std::vector<EffectParameter>& parameters = term_effect(term).parameters;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    if (!parameters[p].is_choice) term.values[p] = 0;
}

/// As one list, term after term. Where the numbers of each term begin, the first ones at `offset`; one entry more than
/// terms: where the list ends.
inline std::vector<Eigen::Index> first_numbers(const std::vector<EffectTerm>& terms, Eigen::Index offset = 0) {
  std::vector<Eigen::Index> first{offset};
  for (const EffectTerm& term : terms) first.push_back(first.back() + static_cast<Eigen::Index>(term.values.size()));
  return first;
}

}  // namespace handsight
