// SPDX-License-Identifier: Apache-2.0
// Which reading of a table's turns is right: the one by which its motions are those of the other table. Internal to
// convert.
#pragma once

#include "base/message.h"
#include "convert/brought.h"

namespace handsight {

/// Can the turns be read in several ways?
bool is_open(const NamedPoses& poses);

/// Settles both; they are paired row by row. What was chosen and by what is said in the notes. InputError where nobody
/// said what the turns are and several readings serve, none does, or nothing can be tried.
void choose_turns(NamedPoses& flange, NamedPoses& target, bool eye_in_hand, std::vector<Message>& notes);

/// The same where nothing can be held against it: what is usual for its columns. InputError where nothing is.
void take_usual_turns(NamedPoses& poses, std::vector<Message>& notes);

}  // namespace handsight
