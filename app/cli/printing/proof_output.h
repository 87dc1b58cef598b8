// SPDX-License-Identifier: Apache-2.0
// Proof plots for people, as JSON and as CSV.
#pragma once

#include "command.h"
#include "diagnosis/proof/proof.h"

namespace handsight::cli {

struct Proofs {
  std::vector<ProofPlot> model;                    // of the effects that the model estimates already
  std::vector<std::vector<ProofPlot>> candidates;  // as Diagnosis::candidates; empty where not worked out
};

/// Of the first candidate, and (`in_full`) of all others that pass the threshold.
Proofs make_proofs(const Session& session, const Diagnosis& diagnosis, bool in_full);

/// The sentences of the first candidate.
void print_proof(const Output& output, const Diagnosis& diagnosis, const Proofs& proofs);

/// Key `proof` of every candidate, and of the whole for the model's own effects. At most 200 points a plot, evenly
/// chosen; `points_in_all` says of how many.
void add_proof(const Proofs& proofs, Json& diagnosis);

/// All points.
std::string proof_csv(const Diagnosis& diagnosis, const Proofs& proofs);

}  // namespace handsight::cli
