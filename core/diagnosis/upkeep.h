// SPDX-License-Identifier: Apache-2.0
// What a change of a model asks for afterwards: what is no longer needed goes, what only stood in for something else is
// exchanged, curves are looked for again.
#pragma once

#include "diagnosis/improvement.h"

namespace handsight {

/// Times the held-out error: a rise that no digit shows. What explains the measurements as well with more plausible
/// numbers is no worse.
inline constexpr double as_good = 1 + 1e-4;

/// A model with these estimated terms, diagnosed unless its held-out error is above `most` (DiagnosisOptions).
Diagnosis diagnosed_from(const Session& session, const ImprovementOptions& options,
                         const std::vector<EffectTerm>& estimated, const std::optional<Unknowns>& start,
                         const std::optional<double>& most = std::nullopt);

/// The terms of one effect that stand together, from `first` on, end there.
std::size_t end_of_group(const std::vector<EffectTerm>& terms, std::size_t first);

/// Mends change.model, whose last step added its last group of terms; what goes and comes is told in that step. None of
/// it lifts the held-out error above `most`.
void keep_up(const Session& session, const ImprovementOptions& options, double most, ModelChange& change);

/// Looks for better names in the place of all that was added, the last too: once nothing is left to add, where the
/// model has grown beyond what keep_up looks through after every addition. False where all stays.
bool exchange_at_the_end(const Session& session, const ImprovementOptions& options, ModelChange& change);

}  // namespace handsight
