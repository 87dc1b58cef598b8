// SPDX-License-Identifier: Apache-2.0
// A name at many places may stand in for several names together, which no exchange of one for one shows.
#pragma once

#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// Other names, or other places of the same, that explain what the model's names explain.
struct ModelAlternative {
  std::vector<std::string> gone, come;  // effect ids
  FitOptions options;                   // the model with them, at its answer
};

/// Looks for some in the place of all estimated terms from `first` on, curves and what begins at some observation
/// beside them untouched. To first order at the model's answer, one unit after another comes in, what then says nothing
/// any more goes, and every name counts `Diagnosis::threshold`. What comes of it is fitted in full, and has to be
/// clearly likelier than what stands. `goes_on` is asked now and then; false gives nothing.
std::optional<ModelAlternative> search_models(const Diagnosis& model, std::size_t first,
                                              const std::function<bool()>& goes_on);

}  // namespace handsight
