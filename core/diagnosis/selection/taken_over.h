// SPDX-License-Identifier: Apache-2.0
// A large cause that leaves a model may come back as another name's numbers.
#pragma once

#include <vector>

#include "effects/effect.h"
#include "estimation/fit/fit_result.h"

namespace handsight {

/// Is a large cause, larger than usual in a number, taken over where it goes: does a name that was within what is usual
/// have numbers beyond it without `gone`, and describe the measurements as well (chi-squared grows by less than 20)?
/// Which of the two it is these do not say then, only usual sizes: the zero of one joint turns the links after it, and
/// so does a link that is built wrong by degrees.
bool is_taken_over(const std::vector<EffectTerm>& gone, const Fit& with, const Fit& without);

}  // namespace handsight
