// SPDX-License-Identifier: Apache-2.0
// The hand as the sensor's link sees it. Where joints carry both, as with cameras on a head, what bends below both is
// not measured: errors of the hand against the floor are another matter than those that a measurement can contradict.
#pragma once

#include "estimation/report/prediction.h"

namespace handsight {

struct SeenHand {
  Rigid nominal, predicted;              // root_from_hand, the link of the sensor where the nominal robot has it
  Matrix3 covariance = Matrix3::Zero();  // m^2, root axes, of the predicted position
};

/// Where the sensor's link stands, the numbers of predict_tcp. Each number of the model is taken by the secant over its
/// sigma, as there.
SeenHand seen_hand(const ObservationState& states, const PredictionModel& model);

}  // namespace handsight
