// SPDX-License-Identifier: Apache-2.0
// What an improvement says in the end: what has names, what follows what and has none, and what each is worth.
#pragma once

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// Sets bill, shares and the last verdict with its reason, of an improvement whose inclusion_probabilities are set:
/// names that are less likely than not are told apart. `excess`: of the first model. `refused`: what the last model was
/// offered and did not take.
void conclude(std::optional<double> excess, const std::vector<RefusedStep>& refused, Improvement& improvement);

}  // namespace handsight
