// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/rare_causes.h"

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/posture_remainder.h"

namespace handsight {
namespace {

Message too_weak_text(const DiagnosisCandidate& c, double odds, double threshold) {
  if (is_change_between_sessions(c.terms.front()))
    return "what belongs to the robot seldom changes between sessions, and the evidence is too weak for that";
  return message("{} are rare, and its evidence of ln {:.1f} is below the ln {:.1f} that is asked of them",
                 slip_order(c.terms) ? "slips" : "drifts", c.ln_bayes_factor + odds, threshold + odds);
}

Message beside_posture_text(const DiagnosisCandidate& c, double odds, double threshold) {
  return message(
      "what follows the posture may explain as much: beside that its evidence is ln {:.1f}, below the "
      "ln {:.1f} that is asked of {}",
      c.ln_bayes_factor + odds, threshold + odds, slip_order(c.terms) ? "slips" : "drifts");
}

}  // namespace

void hold_back_rare_causes(Diagnosis& d) {
  for (DiagnosisCandidate& c : d.candidates) {
    if (c.unnamed) continue;
    const double odds = ln_odds_against(c.terms.front());
    if (odds <= 0 || c.ln_bayes_factor + odds < d.threshold) continue;
    if (c.ln_bayes_factor < d.threshold) {
      c.held_back = too_weak_text(c, odds, d.threshold);
    } else if (follows_time(c.terms.front())) {
      const Fit& fit = d.model.fit;
      const double beside = ln_factor_beside_posture(fit, c.terms, d.repeatability, noise_model(fit)) - odds;
      if (beside >= d.threshold) continue;
      c.ln_bayes_factor = beside;
      c.held_back = beside_posture_text(c, odds, d.threshold);
    }
  }
}

}  // namespace handsight
