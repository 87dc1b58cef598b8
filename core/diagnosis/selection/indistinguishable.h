// SPDX-License-Identifier: Apache-2.0
// What could do the same to the measurements as a cause that is in the model.
#pragma once

#include "diagnosis/space/model_space.h"

namespace handsight {

/// Ids of the other names of which one alone, with numbers that robots have, imitates what this name of the model
/// (into ModelSpace::names) does to the measurements, the rest of the model taking up what it can, so nearly that the
/// odds against it stay below twenty to one. Empty where it does nothing that could be seen.
std::vector<std::string> indistinguishable_from(const ModelSpace& all, std::size_t name);

/// Ids of the other names of the model that would do the same where they are, were their numbers up to ten times what
/// is usual: a zero is a turn of the next link's frame. Only what sizes are usual, which is a guess, tells them apart.
std::vector<std::string> told_by_size_from(const ModelSpace& all, std::size_t name);

}  // namespace handsight
