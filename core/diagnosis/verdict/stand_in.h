// SPDX-License-Identifier: Apache-2.0
// What is in a model and no robot is built like: it stands in for another cause.
#pragma once

#include <string>
#include <vector>

#include "estimation/fit/fit_result.h"

namespace handsight {

/// What is in the model and larger than robots are built, or a spring that pushes back.
struct StandIn {
  std::string id;
  std::vector<std::string> where;  // the places whose numbers are so
  bool pushes_back = false;
  bool is_everywhere = true;  // false: it is in the model at other places too, and there robots are built so
};

/// Usual sizes: what is larger stands in for something else. Beyond the widest that a prior has (evidence.h): zeros set
/// by eye and links printed at home are many times what is usual, and true.
inline constexpr double largest_built = 30;

/// Usual sizes (prior sigmas) up to which a number is plausible.
inline constexpr double largest_plausible = 3;

/// Up to where a number of a term is built, in its own unit: largest_built times what is usual, and of a spring what
/// bends by 3 degrees under the heaviest load that its joint can have: light arms have soft bearings and series
/// springs. A target may be four times as large as its description says: that was typed or printed wrong.
double find_largest_built(const EffectTerm& term, std::size_t parameter, const Chain& chain);

/// Is every number of the terms within largest_plausible?
bool is_plausible(const std::vector<EffectTerm>& terms, const Chain& chain);

/// Is a number of the term that a fit moves larger than robots are built?
bool is_too_large(const EffectTerm& term, const Chain& chain);

/// Of what the fit estimates (not what the user holds), an entry an effect.
std::vector<StandIn> stand_ins(const Fit& fit);

}  // namespace handsight
