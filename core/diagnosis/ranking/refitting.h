// SPDX-License-Identifier: Apache-2.0
// A candidate fitted in full, and what that says of its evidence.
#pragma once

#include <optional>

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/outliers/snooping.h"
#include "diagnosis/ranking/ranking.h"

namespace handsight {

struct Refit {
  Fit fit;
  FitOptions options;
  std::size_t added = 0;       // terms at the end of fit.effects
  double ln_bayes_factor = 0;  // against the model without them, at the minimum, repeatability profiled out
};

/// The evidence of a model for all that it estimates, which is the same for everything that is added to it.
double compute_ln_evidence(const CleanFit& model, const NoiseModel& noise_model);

/// Adds terms to a model and fits everything from there, on the same points. `ln_before`: compute_ln_evidence() the
/// model, where it is known. A fit that is stopped has no factor.
Refit refit_with(const CleanFit& model, const FitOptions& model_options, const std::vector<EffectTerm>& added,
                 const NoiseModel& noise_model, std::optional<double> ln_before = std::nullopt);

/// ln of the evidence of a fit, up to a constant that all fits of the same points share; the effects from `first_new`
/// (an effect column) on with a mixture of prior sigmas. The best over the repeatabilities, which is given too.
struct FitEvidence {
  double ln_evidence = 0;
  Repeatability repeatability;
};
FitEvidence fit_evidence(const Fit& fit, Eigen::Index first_new, const NoiseModel& noise_model);

/// Where a term has an observation from which on it acts, the one among the neighbours of its own that suits best.
std::vector<EffectTerm> with_settled_orders(const CleanFit& model, const std::vector<EffectTerm>& terms,
                                            const NoiseModel& noise_model);

/// The same among all observations.
std::vector<EffectTerm> with_best_orders(const CleanFit& model, const std::vector<EffectTerm>& terms,
                                         const NoiseModel& noise_model);

/// Does any further named effect of the catalogue pass the threshold once these are in the model?
bool further_effect_passes(const Refit& refit, double threshold);

/// The share of what `a` does to the measurements (at its estimate) that `b` can imitate with plausible numbers. `all`
/// is the score of every candidate's columns together.
double imitated_share(const Score& all, const RankedEffect& a, const RankedEffect& b);

/// Terms whose choices (an observation from which on they act, a form) are those that suit the session best, every
/// other choice compared with the model without them.
std::vector<EffectTerm> best_choices(const Session& session, const std::vector<EffectTerm>& terms);

}  // namespace handsight
