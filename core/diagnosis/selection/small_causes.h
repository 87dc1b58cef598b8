// SPDX-License-Identifier: Apache-2.0
// The rivals that no list of places is: zeros, geometry, springs and eccentricities that are there a little at each
// joint, as in every robot. Together they may do what one name at one place does.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/space/model_space.h"

namespace handsight {

/// What may stand in the place of a name of the model.
struct SmallCauses {
  /// How probable it is that the name is not there at all. No more than 0.95: what they are is a guess of many numbers.
  double share = 0;
  std::vector<std::string> names;  // what is there a little instead, where the odds are not below 1 to 20
};

/// For each name of a choice of a model space what may be there a little at each of its places instead: weighed against
/// the choice as it is, the choice with such others beside it, and this name a little at each of its own places.
/// Nothing for names that are not in it.
std::vector<SmallCauses> find_small_causes(const ModelSpace& all, const Chosen& chosen);

/// ln of the probability that none of the names has them in its place.
double ln_standing(const std::vector<SmallCauses>& causes);

}  // namespace handsight
