// SPDX-License-Identifier: Apache-2.0
// Who carries what: the sensor on a stand and the target on the hand, the other way round, or both on the robot.
#pragma once

#include <string>

#include "base/message.h"
#include "chain/chain.h"

namespace handsight {

enum class Arrangement {
  sensor_stands,   // the robot carries the target: "eye on a stand"
  sensor_on_hand,  // the robot carries the sensor, the target stands: "eye in hand"
  both_move,       // each is moved by joints of its own, as with a head that watches an arm
  nothing_moves,   // no measured joint moves one against the other
};

Arrangement find_arrangement(const Chain& chain);

/// One plain sentence about the session: "The camera on base sees a board that the robot moves on tool0."
Message arrangement_sentence(const Session& session, const Chain& chain);

/// What there is to do with it, for people who set up a session: one sentence each.
std::string advice_on(Arrangement arrangement);

}  // namespace handsight
