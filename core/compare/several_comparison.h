// SPDX-License-Identifier: Apache-2.0
// Three sessions of one robot and more, or a collection: what is the same in all of them, and what has changed between
// which.
#pragma once

#include "compare/comparison_result.h"
#include "session/joined.h"

namespace handsight {

/// One thing at one place that is another in some sessions.
struct ChangeCandidate {
  std::string id;                          // Change::id
  std::string where;                       // joint or marker; empty: it has no place
  std::vector<std::string> before, after;  // titles; those after have what those before have not
  double probability = 0;  // among all that may have changed, and nothing having changed (as likely beforehand as all)
};

/// A change with its numbers: what sessions `after` have more than those before.
struct ChangeBetween {
  Change change;
  ChangeCandidate reported;
  std::vector<ChangeCandidate> alternatives;  // what it may be as well, more than 1 % likely, likeliest first
  Message text;                               // for people
  double hand_mean_m = 0, hand_max_m = 0;     // how far it moves the hand over the poses of the sessions concerned
};

/// What was asked and not found changed, beside the changes that were found.
struct SharedThing {
  std::string id;
  double probability_changed = 0;
  double ln_bayes_factor = 0;
};

struct SeveralComparison {
  ComparisonVerdict verdict = ComparisonVerdict::unchanged;  // several: more than one change
  Message sentence;                                          // for people
  std::vector<std::string> sessions;                         // titles, in order of time
  std::vector<std::vector<std::string>> rigs, bodies;        // sessions that have one in common, by their titles
  std::vector<ChangeBetween> changes;                        // in the order in which they were found
  std::vector<SharedThing> shared;
  double threshold = 0;  // ln of a Bayes factor that is no chance: 1 in 200 where nothing changed
  bool model_fits = true;
  std::vector<Message> notes;
};

/// Members are in order of time. Members with the same rig="" have one sensor at one place, with the same body="" one
/// body on the hand: whether these have changed is asked, and whether the joints' zeros, springs and the load have.
/// What a member has by itself is fitted by itself. `effects`: names ("joint_offset:a1") in the model of all,
/// estimated. InputError where there are fewer than two, or they are not of one robot, or nothing can be compared.
SeveralComparison compare(const std::vector<JoinedMember>& members, const std::vector<std::string>& effects = {},
                          const ComparisonProgress& progress = {});

}  // namespace handsight
