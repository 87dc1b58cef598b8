// SPDX-License-Identifier: Apache-2.0
// Where a search ends depends on its way. So one name is left out of its end, and the search goes on from there, which
// often ends elsewhere (Schrimpf, Schneider, Stamm-Wilbrandt and Dueck 2000, ruin and recreate); or it begins again
// with another name.
#pragma once

#include "diagnosis/selection/model_walk.h"

namespace handsight {

/// Has it names of which one could stand in for another, and is more left than noise? Scatter from pose to pose may be
/// what the right names would explain. `first`: into the estimated terms, of those that were added.
bool is_worth_seeking(const Diagnosis& end, std::size_t first);

/// Goes on from the end of a walk that explains not everything: where it began with terms that were given, the names
/// come beside them at which the search ends without; then one name after another is left out of it, the least
/// certain first; then the search begins again with one after another of the names that it lacks. An end that is
/// clearly likelier, or as likely with a clearly lower held-out error, stands in the place of the last, where its error
/// elsewhere is no larger. But for the first only while rows times models stay within a budget, which sessions of many
/// rows have spent before, or, where it is to be thorough, while models are left.
void regrow(const Session& session, const ImprovementOptions& options, ModelWalk& walk);

}  // namespace handsight
