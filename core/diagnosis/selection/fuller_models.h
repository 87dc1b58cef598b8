// SPDX-License-Identifier: Apache-2.0
// The other way round: every place at once, and those that show nothing leave. Names that come one after another take
// the places that show beside what is in the model by then; where a spring is missing among them, others stand in for
// it, so far from what is true that no single addition leads back.
#pragma once

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// The names of a model and those that may be there too (`certainty`: of the model), each everywhere that it can sit,
/// fitted from nothing; then what shows nothing goes, by and by. Taken where it is clearly likelier and predicts as
/// well as what stands, or predicts clearly better, both within the poses and elsewhere. Nothing that follows time
/// comes in.
ModelChange seek_fuller_model(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                              const InclusionProbabilities& certainty);

}  // namespace handsight
