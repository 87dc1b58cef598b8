// SPDX-License-Identifier: Apache-2.0
// What is there a little at each joint, as in every robot, beside the names of a model.
#pragma once

#include "diagnosis/selection/improvement_result.h"

namespace handsight {

/// The model with zeros, geometry, springs or eccentricities that are there a little at each joint that has no name of
/// that kind (spreading.h). No causes are told of them: each alone says too little, together they bring the hand
/// nearer. They come beside a name that is larger than usual, or a target of another size, where that is likelier, with
/// the size that is likeliest, and where the held-out error falls and the error elsewhere does not rise. They stand
/// before the names.
ModelChange add_background(const Session& session, const ImprovementOptions& options, const Diagnosis& model);

}  // namespace handsight
