// SPDX-License-Identifier: Apache-2.0
// Checks, error attributions, predictions and corrections as JSON: what the command line writes and the Python module
// gives.
#pragma once

#include "correct/correction.h"
#include "diagnosis/attribution/error_attribution.h"
#include "estimation/report/prediction.h"
#include "estimation/report/session_check.h"
#include "json_values.h"

namespace handsight::cli {

Json check_json(const Session& session, const SessionCheck& check);

/// Shares of what exceeds the noise, 0 to 1: `cameras`, `body`, `robot`.
Json attribution_json(const ErrorAttribution& attribution);

/// `rotation_is_observed`: false: rotations have no sigma.
Json prediction_json(const TcpPrediction& prediction, bool rotation_is_observed);

Json correction_json(const Eigen::VectorXd& commanded, const Correction& correction);

/// The joints' values that observation states were made from, in the order of Chain::joints.
Eigen::VectorXd commanded_position(const ObservationState& states);

}  // namespace handsight::cli
