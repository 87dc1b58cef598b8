// SPDX-License-Identifier: Apache-2.0
// Effects bend the cost, and large ones of several kinds leave it more than one valley: a search from other sizes.
#pragma once

#include <optional>

#include "estimation/solvers/least_squares.h"

namespace handsight {

/// A start from which less is left than `found` leaves, priors included: the best end of a few searches whose effects
/// begin at draws of their prior sigmas (the same ones in every run). Nothing where `found` is the best.
std::optional<Unknowns> better_effects(const Problem& problem, const Solution& found, const SolveOptions& options);

}  // namespace handsight
