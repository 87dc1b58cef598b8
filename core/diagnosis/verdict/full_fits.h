// SPDX-License-Identifier: Apache-2.0
// The candidates that lead a ranking, fitted in full: their numbers and their evidence at the minimum in place of the
// linear ones.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "diagnosis/ranking/refitting.h"
#include "diagnosis/verdict/diagnosis_options.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// What a diagnosis knows of a model to first order.
struct LinearSearch {
  NoiseModel noise_model;
  Candidates candidates;
  LinearModel model;
  std::vector<Variable> variables;
  Ranking ranking;
  double odds_of_unnamed = ln_odds_of_unnamed;
};

/// The ranked effect of that id, which must be one of them.
const RankedEffect& find_ranked(const Ranking& ranking, const std::string& id);

/// Best first.
void sort_candidates(std::vector<DiagnosisCandidate>& candidates);

/// Fits the best named effects and the best curve in full, side by side, and writes what comes of it into
/// `diagnosis`, whose candidates must be in order and are again; the fits of the named ones, by effect. `goes_on` is
/// asked at every iteration, never twice at a time; once it returns false all ends, and the candidates are unfinished.
std::map<std::string, Refit> fit_the_best_in_full(const Session& session, const DiagnosisOptions& options,
                                                  const LinearSearch& search, const std::function<bool()>& goes_on,
                                                  Diagnosis& diagnosis);

}  // namespace handsight
