// SPDX-License-Identifier: Apache-2.0
// What may stand in options: numbers within bounds, effects that have a place.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "base/bounds.h"
#include "effects/effect.h"

namespace handsight::cli {

/// For an option's numbers: finite and within bounds. (CLI11's own checks let NaN through.)
CLI::Validator within(double lowest, double highest);
CLI::Validator within(const Bounds& bounds);

/// InputError where a term sits at a marker that the session does not have, or has a value beyond all bounds.
void check_terms(const std::vector<EffectTerm>& terms, int marker_count);

}  // namespace handsight::cli
