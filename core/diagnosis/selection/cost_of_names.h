// SPDX-License-Identifier: Apache-2.0
// What the names of a model cost, whatever the measurements say.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnosis/evidence/candidates.h"

namespace handsight {

/// At how many places each effect could sit, by id. `candidates`: all of a model without names.
std::map<std::string, int> places_of_effects(const Candidates& candidates);

/// ln of the odds against the names of these terms, `cost_of_a_name` each, and of the ways in which they could have sat
/// at so many places.
double cost_of_names(const std::vector<EffectTerm>& terms, const std::map<std::string, int>& places,
                     double cost_of_a_name);

}  // namespace handsight
