// SPDX-License-Identifier: Apache-2.0
// What could do the same to the measurements as a cause that is in the model.
#pragma once

#include "diagnosis/selection/model_space.h"

namespace handsight {

/// Ids of the other names of which one alone, with numbers that robots have, imitates what this name of the model
/// (into ModelSpace::names) does to the measurements, the rest of the model taking up what it can, so nearly that the
/// odds against it stay below twenty to one. Empty where it does nothing that could be seen.
std::vector<std::string> indistinguishable_from(const ModelSpace& all, std::size_t name);

}  // namespace handsight
