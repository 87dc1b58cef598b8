// SPDX-License-Identifier: Apache-2.0
// Where a search ends depends on its way. So one name is left out of its end, and the search goes on from there, which
// often ends elsewhere (Schrimpf, Schneider, Stamm-Wilbrandt and Dueck 2000, ruin and recreate).
#pragma once

#include "diagnosis/selection/model_walk.h"

namespace handsight {

/// Goes on from the end of a walk that explains not everything: one name after another is left out of it, the least
/// certain first. An end that is clearly likelier, or as likely with a clearly lower held-out error, stands in the
/// place of the last, where its error elsewhere is no larger. Only while rows times models stay within a budget, which
/// sessions of many rows have spent before, or, where it is to be thorough, while models are left.
void regrow(const Session& session, const ImprovementOptions& options, ModelWalk& walk);

}  // namespace handsight
