// SPDX-License-Identifier: Apache-2.0
// A process that works on a session as fast as it can until it is killed, and says what it has done.
#pragma once

#include <cstdio>

#include "document/document.h"

namespace handsight::test {

/// Action number n: observation n mod count gets the decision and the reason "action n".
inline app::Edit numbered_action(const app::Document& document, int n) {
  const auto& observations = document.session().observations;
  const Observation& o = observations[static_cast<std::size_t>(n) % observations.size()];
  EditableState after = read_state(o);
  after.decision = Decision::excluded;
  after.reason = verbatim("action " + std::to_string(n));
  return document.make_edit("action " + QString::number(n), {{o.id, after}});
}

/// --write-until-killed SESSION: acts, saves now and then; after each action that has returned prints its number.
inline int write_until_killed(int argc, char** argv) {
  app::Document document;
  document.open(argv[argc - 1]);
  for (int n = document.undo_stack().index() + 1;; ++n) {
    document.perform(numbered_action(document, n));
    std::printf("%d\n", n);
    std::fflush(stdout);
    if (n % 7 == 0) document.save();
  }
}

}  // namespace handsight::test
