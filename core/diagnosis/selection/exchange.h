// SPDX-License-Identifier: Apache-2.0
// A name that was given early may have stood in for another, which shows once the rest is in the model.
#pragma once

#include "diagnosis/verdict/diagnosis_result.h"
#include "effects/effect.h"
#include "estimation/fit/fit_options.h"

namespace handsight {

/// Another effect that does better in the place of one of the model's.
struct Exchange {
  std::string id;
  std::vector<EffectTerm> terms;  // of it, at the full fit
  FitOptions options;             // the model with it, at its answer
};

/// Looks for one in the place of the estimated terms from `first` to `last`: ranked without them, and by the evidence
/// of the full fits clearly above what they reach. `goes_on` is asked at every iteration; false gives nothing.
std::optional<Exchange> better_name(const Diagnosis& model, std::size_t first, std::size_t last,
                                    const std::function<bool()>& goes_on);

}  // namespace handsight
