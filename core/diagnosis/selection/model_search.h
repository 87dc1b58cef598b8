// SPDX-License-Identifier: Apache-2.0
// A name at many places may stand in for several names together, which no exchange of one for one shows.
#pragma once

#include "diagnosis/selection/inclusion_probability.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// Other names, or other places of the same, that explain what the model's names explain.
struct ModelAlternative {
  std::vector<std::string> gone, come;  // effect ids
  FitOptions options;                   // the model with them, at its answer
  double ln_gained = 0;                 // evidence against the model that stands, with what either costs to choose
};

/// Looks for some in the place of all estimated terms from `first` on, curves and what begins at some observation
/// beside them untouched. To first order at the model's answer, one unit after another comes in, what then says nothing
/// any more goes, and every name counts `Diagnosis::threshold`. What comes of it is fitted in full, and has to be
/// clearly likelier than what stands. `goes_on` is asked now and then; false gives nothing.
std::optional<ModelAlternative> search_models(const Diagnosis& model, std::size_t first,
                                              const std::function<bool()>& goes_on);

/// The same, but to first order at the answer of `fuller`: a fit of the model's points with all of its names, and its
/// curves or none of them, and more.
std::optional<ModelAlternative> search_models_about(const Diagnosis& model, const Fit& fuller, std::size_t first,
                                                    const std::function<bool()>& goes_on);

/// The likeliest choice of names of a model, where that is another than its own, fitted in full: where it is likelier
/// then, too. `inclusion_probabilities`: of the model, from `first` on.
std::optional<ModelAlternative> fit_likeliest(const Diagnosis& model, std::size_t first,
                                              const InclusionProbabilities& inclusion_probabilities,
                                              const std::function<bool()>& goes_on);

}  // namespace handsight
