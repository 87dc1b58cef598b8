// SPDX-License-Identifier: Apache-2.0
// What touches cannot tell, in words.
#pragma once

#include <array>

#include "base/message.h"
#include "estimation/fit/fit_result.h"

namespace handsight {

/// Sentences for people, of a session of touches: what of the tip and of the fixtures no touch determines, and which
/// joints' zeros another place of tip or fixtures would hide. Empty where all of it is reported.
std::vector<Message> touch_unknown_texts(const Session& session, const Fit& fit);

/// Of the tip's place on the hand (x y z in the TCP's frame): what no touch tells. All false of other sessions.
std::array<bool, 3> undetermined_tip(const Session& session, const Fit& fit);

}  // namespace handsight
