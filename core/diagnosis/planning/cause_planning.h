// SPDX-License-Identifier: Apache-2.0
// The poses that are expected to say most about what a model lacks, while it is not known what that is.
#pragma once

#include "diagnosis/planning/planning.h"

namespace handsight {

/// Up to options.count poses, in the order in which they are to be taken (`between` is not read). Every effect of the
/// catalogue at every place, and none of them, is a hypothesis with the odds that the measurements so far give it; a
/// pose is worth what its measurement is expected to say about which of them is true and about the model's own
/// numbers: Borth's total entropy, the first by distances of Bhattacharyya between the hypotheses' predictions
/// (docs/method.md, "Next poses"). Not of touches. InputError as of plan().
std::vector<Eigen::VectorXd> plan_for_causes(const Session& session, const PlanOptions& options);

}  // namespace handsight
