// SPDX-License-Identifier: Apache-2.0
// What a model may lack, as hypotheses that each predict new measurements.
#pragma once

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"

namespace handsight {

/// One effect at one place, were it true.
struct Suspect {
  std::size_t effect = 0;             // into Candidates::effects; those of one effect share its name
  Eigen::Index first = 0, count = 0;  // candidate columns; none: nothing is missing
  double probability = 0;             // by the measurements so far; the sum over all suspects is 1
  Eigen::VectorXd value;              // of its numbers, prior sigmas
  Eigen::MatrixXd information;        // about them, that of the prior included
};

/// The likeliest places of each effect, and that nothing is missing, which is last and has half of the prior. Effects
/// that begin at some moment are left out: no pose shows them better than another.
std::vector<Suspect> list_suspects(const Candidates& candidates, const WhitenedModel& model,
                                   const NoiseKnowledge& noise);

}  // namespace handsight
