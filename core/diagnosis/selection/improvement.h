// SPDX-License-Identifier: Apache-2.0
// Add what is missing, refit, look again, until the model is adequate or nothing that is known helps.
#pragma once

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// add_best until nothing is left to add, names and curves by their evidence beside each other: what the others make
/// needless goes, curves are looked for again after every change, and in the end other names for all.
Improvement improve(const Session& session, const ImprovementOptions& options = {});

}  // namespace handsight
