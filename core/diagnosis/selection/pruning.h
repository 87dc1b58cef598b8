// SPDX-License-Identifier: Apache-2.0
// What a change of a model asks for afterwards: what is no longer needed goes, what only stood in for something else is
// exchanged, curves are looked for again.
#pragma once

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// Times the held-out error: a rise that no digit shows. What explains the measurements as well with more plausible
/// numbers is no worse.
inline constexpr double as_good = 1 + 1e-4;

/// The same where the other names are clearly likelier: a rise in the third digit is chance.
inline constexpr double as_good_as_reported = 1 + 2e-3;

/// Clearly lower than the held-out error of a model that is as likely, times it.
inline constexpr double clearly_less = 0.95;

/// Clearly likelier: ln of a Bayes factor, odds of 20.
inline constexpr double clear_gain = 3;

/// ln of the evidence for one place more of an effect that is in the model.
inline constexpr double worth_a_place = 1;

/// The terms of one effect that stand together, from `first` on, end there.
std::size_t end_of_group(const std::vector<EffectTerm>& terms, std::size_t first);

/// Mends change.model, a model_from() whose last step added its last group of terms; what goes and comes is reported in
/// that step. None of it lifts the held-out error above `most`.
void prune(const Session& session, const ImprovementOptions& options, double most, ModelChange& change);

}  // namespace handsight
