// SPDX-License-Identifier: Apache-2.0
// How sure the names of a model are, what else may be there, and what that leaves open of its predictions: the average
// over models (Hoeting, Madigan, Raftery and Volinsky 1999, Bayesian model averaging).
#pragma once

#include "diagnosis/space/model_space.h"
#include "diagnosis/verdict/diagnosis_result.h"
#include "estimation/report/model_uncertainty.h"

namespace handsight {

/// A name of the catalogue, an own effect or a curve.
struct InclusionProbability {
  std::string id;
  std::vector<std::string> where;  // places that are likelier than not where it is there; else its likeliest
  double probability = 0;          // that it is there
  bool is_in_model = false;
  /// Of the model's: ids of what could do the same to the measurements on these poses.
  std::vector<std::string> indistinguishable_from = {};
};

/// A name that is not in the model and yet likely.
struct LikelyName {
  InclusionProbability name;
  std::vector<EffectTerm> estimated;  // the model's estimated terms, then its own, to first order
};

struct InclusionProbabilities {
  std::vector<InclusionProbability> names;  // of the model first, the surest first; others from `least_reported` on
  std::vector<LikelyName> likely;           // from `least_likely` on, the likeliest first
  /// The likeliest choice of no more units than the model has, in its ModelSpace with cost_of_a_name, small causes in
  /// the place of names reckoned with; and by how much these leave it likelier than the model (ln), beside the
  /// evidence.
  std::optional<Chosen> likeliest = {};
  double ln_of_small_causes = 0;
  ModelUncertainty model_uncertainty;

  static constexpr double least_reported = 0.05, least_likely = 0.8;
  /// ln: odds of 1 to 20, as often as trials with many small causes have them.
  static constexpr double cost_of_a_name = 3;
};

/// Of the estimated terms from `first` on, and of all of the catalogue that could stand beside or in the place of them.
/// To first order about the model's answer; each name has odds of 1 to 20 before the measurements, its places share
/// them, sizes are those of the evidence (others no larger than plausible). Names of the model are weighed against
/// zeros, geometry, springs and eccentricities of all joints, too (small_causes.h). What begins at some observation may
/// go, but does not come. `goes_on` is asked now and then; false gives nothing, and so does a fit with markers that are
/// held where no shape is known.
InclusionProbabilities inclusion_probabilities(const Diagnosis& model, std::size_t first,
                                               const std::function<bool()>& goes_on);

}  // namespace handsight
