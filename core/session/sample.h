// SPDX-License-Identifier: Apache-2.0
// Parts of long sessions: a few thousand observations decide what a hundred thousand would.
#pragma once

#include "session/session.h"

namespace handsight {

/// A part of a session, and what it left.
struct Sample {
  Session session;            // with the observations that were taken, each with its place in the whole
  std::vector<int> taken;     // into the whole session's observations, in order of time
  std::vector<int> left_out;  // the used ones that were not taken
};

/// Every so manyth of the used observations in order of time, `size` of them, the first and the last among them.
/// Nothing where there are no more than `most`.
std::optional<Sample> take_sample(const Session& session, int most, int size);

/// The session with these observations alone, each with its place in the whole.
Session take_part(const Session& session, const std::vector<int>& observations);

}  // namespace handsight
