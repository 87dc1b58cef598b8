// SPDX-License-Identifier: Apache-2.0
// How many touches of each fixture it takes at least, by counting numbers.
#pragma once

#include <optional>
#include <vector>

#include "base/message.h"
#include "session/fixtures/fixture_kind.h"
#include "session/session.h"

namespace handsight {

/// The numbers of a fixture's small motion in its own frame (v, w) that mean something: not a plane's turn about its
/// normal.
std::vector<Eigen::Index> list_numbers(const FixtureKind& kind);

/// What is lacking, by counting alone, that the places of tip and fixtures could follow from touches.
struct LackingTouches {
  std::vector<int> of_fixture;  // touches more that its own place takes at least
  int numbers_of_tip = 0;       // that would still be lacking then
};

/// Of a session of touches by those of its observations that `counts` marks.
LackingTouches count_lacking(const Session& session, const std::vector<char>& counts);

/// Of each fixture that was touched, how many touches more it takes at least, the hand turned otherwise in each; all 0
/// where the numbers suffice.
std::vector<int> touches_lacking(const Session& session);

/// What to touch next, in words: nothing where the numbers suffice.
std::optional<Message> touches_lacking_text(const Session& session);

/// A fixture that nothing touches although where it stands would have to follow from touches: of a known distance,
/// whose other end it is, or because nothing says where it is. Nothing where there is none, or no touch at all.
std::optional<Message> untouched_text(const Session& session);

}  // namespace handsight
