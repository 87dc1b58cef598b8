// SPDX-License-Identifier: Apache-2.0
// How the flange's poses are to be read, by what images show of a target. Internal to convert.
#pragma once

#include "convert/brought.h"
#include "convert/conversion.h"

namespace handsight {

/// Finds the target in some of the images of the session that was written, and chooses the reading of the flange's
/// turns by it; where another one than the first is right the session's file is written anew. `flange` has a row an
/// observation. InputError as choose_turns.
void choose_turns_by_images(NamedPoses& flange, bool eye_in_hand, Conversion& conversion);

}  // namespace handsight
