// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "diagnosis/verdict/diagnosis_result.h"
#include "effects/effect.h"

namespace handsight {

/// Where the names of a model begin among its estimated terms: after the session's own, `own` of them, and what is
/// there a little at each joint beside these (background.h).
inline std::size_t begin_of_names(const std::vector<EffectTerm>& estimated, std::size_t own) {
  std::size_t first = own;
  while (first < estimated.size() && is_small(estimated[first])) ++first;
  return first;
}

/// The place of an estimated term of a model among the terms of its fit: those that are held come before.
inline std::size_t term_of_fit(const Diagnosis& model, std::size_t estimated) {
  return model.model_options.effects.size() + estimated;
}

}  // namespace handsight
