// SPDX-License-Identifier: Apache-2.0
// The rivals that no list of places is: zeros, geometry, springs and eccentricities that are there a little at each
// joint, as in every robot. Together they may do what one name at one place does.
#pragma once

#include <vector>

#include "diagnosis/selection/model_space.h"

namespace handsight {

/// For each name of a model space, how probable it is that the name is not there at all, because others are there a
/// little at each of their places: weighed against the model as it is, the model with such others beside it, and this
/// name a little at each of its own places. 0 for names that are not in the model.
std::vector<double> find_shares_of_small_causes(const ModelSpace& all);

}  // namespace handsight
