// SPDX-License-Identifier: Apache-2.0
// A large cause that leaves a model may come back as another name's numbers.
#pragma once

#include <vector>

#include "effects/effect.h"
#include "estimation/fit/fit_options.h"
#include "estimation/fit/fit_result.h"

namespace handsight {

/// The same effect at the same place, whatever its numbers.
bool is_same_place(const EffectTerm& a, const EffectTerm& b);

/// Is a large cause, terms of `gone` that are larger than usual in a number, taken over where it leaves the model that
/// `with` has fitted: does a name that was within what is usual have numbers beyond it then, and describe the
/// measurements as well (chi-squared grows by less than 20)? Which of the two it is these do not say, only usual sizes:
/// the zero of one joint turns the links after it, and so does a link that is built wrong by degrees. `without`: fitted
/// without all of `gone`; where that has places of usual sizes too, the model without the large ones alone is asked.
bool is_taken_over(const std::vector<EffectTerm>& gone, const Session& session, const FitOptions& options,
                   const Fit& with, const Fit& without);

}  // namespace handsight
