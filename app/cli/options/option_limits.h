// SPDX-License-Identifier: Apache-2.0
// What effects may stand in options: those that have a place.
#pragma once

#include <vector>

#include "effects/effect.h"

namespace handsight::cli {

/// InputError where a term sits at a marker that the session does not have, or has a value beyond all bounds.
void check_terms(const std::vector<EffectTerm>& terms, int marker_count);

}  // namespace handsight::cli
