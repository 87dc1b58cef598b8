// SPDX-License-Identifier: Apache-2.0
// What was done here and what another program wrote meanwhile, to one session: put together where the two do not
// collide. Labels and the decision of an observation are two parts, each as a whole.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "session/edit.h"

namespace handsight {

/// What was done here, net, from the session as it was read or written to the one as it is; what came is reported as it
/// is now. What has gone is not given: here nothing can be removed but what was added.
SessionEdit own_changes(const Session& base, const Session& now);

/// The same of a list of actions, some of them undone again: `forward` false.
struct DoneEdit {
  SessionEdit edit;
  bool forward = true;
};
SessionEdit own_changes(const std::vector<DoneEdit>& done);

/// Where both have changed the same to something else.
struct Collision {
  enum class What {
    labels,    // markers of an observation
    decision,  // whether it counts, and why
    gone,      // changed here, removed there
    session,   // cameras, markers or joints are others there: nothing of here can be put into it
  };
  What what = What::labels;
  std::int64_t id = 0;  // of the observation; not of `session`
  Observation mine, theirs;
};

struct Merge {
  Session session;                    // the other program's, with what was done here where that does not collide
  std::vector<Collision> collisions;  // there it is as the other program has it
  int kept = 0;                       // observations that are as they were made here
  /// Numbers of observations that came to both with the same number, here and as they now are: not the same ones.
  std::vector<std::pair<std::int64_t, std::int64_t>> renumbered;
  int lost = 0;  // observations changed here that are gone there, of which no more is known than that
};

/// Puts the changes into what another program wrote. `here`: the session they were made in; null where it is no longer
/// known: changes are then taken as ones of a session like theirs.
Merge merged(const SessionEdit& own, const Session* here, Session theirs);

/// The session with one collision decided for what was done here. Not for What::session.
void take_mine(const Collision& collision, Session& session);

/// What makes one session of the other, where it can be said: observations that changed their labels or decision,
/// and new ones. Nothing where more differs.
std::optional<SessionEdit> edit_between(const Session& from, const Session& to);

}  // namespace handsight
