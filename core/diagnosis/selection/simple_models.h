// SPDX-License-Identifier: Apache-2.0
// The simplest models stay in the race to the end: one effect alone, everywhere that it can sit, may tell more than
// several names that were added one after another.
#pragma once

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// One effect alone, everywhere, in the place of all names of the model that were added: where that is clearly likelier
/// and predicts as well, or predicts clearly better, both within the poses and elsewhere. Nothing that follows time.
ModelChange seek_simpler_model(const Session& session, const ImprovementOptions& options, const Diagnosis& model);

}  // namespace handsight
