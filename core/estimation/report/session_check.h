// SPDX-License-Identifier: Apache-2.0
// Everything that a session needs, looked at before work begins.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "session/session.h"

namespace handsight {

/// Sentences for people.
struct SessionCheck {
  std::vector<Message> contents;  // what is there
  std::vector<Message> warnings;  // works, but ought to be looked at
  std::vector<Message> problems;  // would not work
};

/// Reads every image; poses every observation; compares measured torques with the moments of gravity of the nominal
/// robot (a joint is named where they differ by more than 20 % of their size, root mean square, and by more than 2 N
/// m).
SessionCheck check_session(const Session& session);

}  // namespace handsight
