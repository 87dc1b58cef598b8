// SPDX-License-Identifier: Apache-2.0
// What more poses would bring.
#pragma once

#include "base/message.h"
#include "experiment/loop/choice.h"

namespace handsight {

/// A sentence: how well the body's place on the hand would be known after one more hour of the best poses, by the
/// information that twelve of them add. Empty where it cannot be predicted.
Message forecast(const Session& session, const ExperimentModel& model, const Knowledge& known, const Reach& reach,
                 double seconds_a_pose);

}  // namespace handsight
