// SPDX-License-Identifier: Apache-2.0
// A candidate's cheap check with the real robot as a number: predicted by the model before it is measured, and what the
// measured one says of the candidate.
#pragma once

#include <optional>
#include <string>

#include "base/message.h"
#include "diagnosis/verdict/diagnosis_result.h"

namespace handsight {

/// Predicts what the check of a named candidate reads (Effect::check_reads): the candidate's part alone, on top of the
/// model as it is; sigma from the covariance of the candidate's numbers. Where a pose is needed, that of the used
/// observation in which it shows most. Absent where nothing would show.
std::optional<CheckPrediction> predicted_check(const Diagnosis& model, const DiagnosisCandidate& candidate);

/// "Hang 1 kg on the hand: it should sag 1.40 +- 0.20 mm further (pose 37)."
Message prediction_text(const CheckPrediction& prediction);

/// What was measured, in the prediction's unit, against the prediction.
struct CheckAnswer {
  bool is_inside = false;         // within two sigma, of prediction and measurement together
  double sigmas = 0;              // how many lie between the two
  bool could_be_nothing = false;  // within two sigma of the measurement of 0: without the candidate it would read that
  Message text;                   // a sentence or two: inside or outside, how far, what it says of the candidate
};
CheckAnswer answer_check(const CheckPrediction& prediction, double measured, double measured_sigma);

}  // namespace handsight
