// SPDX-License-Identifier: Apache-2.0
/// @file
/// Adding what is missing until the model agrees with the measurements or nothing that is known helps.
#pragma once

#include "diagnosis/selection/improvement.h"
#include "handsight/diagnose.h"

namespace handsight {

/// Adds, exchanges and removes effects, as long as the error on observations that were not fitted falls. The effects of
/// `model` stay. Improvement::steps tells what was done, Improvement::last.model.fit is the last fit,
/// Improvement::inclusion_probabilities how likely each effect is. What the options say of effects is not read: the
/// model says it. Takes seconds to minutes; ImprovementOptions::on_progress hears how far it is and can stop it. Throws
/// InputError as fit().
Improvement improve(const Session& session, const Model& model, const ImprovementOptions& options = {});

/// The model that an improvement ended with, with the values found.
Model make_model(const Improvement& improvement);

}  // namespace handsight
