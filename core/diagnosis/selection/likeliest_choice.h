// SPDX-License-Identifier: Apache-2.0
// The choice of names that a model's own probabilities prefer.
#pragma once

#include "diagnosis/selection/model_posterior.h"
#include "diagnosis/selection/small_causes.h"

namespace handsight {

struct LikeliestChoice {
  Chosen chosen;
  double ln_of_small_causes = 0;  // by how much these leave it likelier than the model (ln), beside the evidence
};

/// Of no more units than the model has: what else may be there is added where the evidence asks for it, or a name is
/// likely by itself. By the probabilities that are told: names for which small causes may well stand are less likely
/// than their evidence says. `of_model`: those in the place of the model's names.
LikeliestChoice likeliest_choice(const ModelSpace& all, const OpenUnits& units, const Weights& weights,
                                 const std::vector<SmallCauses>& of_model);

}  // namespace handsight
