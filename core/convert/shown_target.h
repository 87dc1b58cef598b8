// SPDX-License-Identifier: Apache-2.0
// What images show where no target was named, in the words that name it.
#pragma once

#include "base/message.h"
#include "session/find_images.h"

namespace handsight {

/// "The images show one: say what with --target "chessboard columns=9 rows=6 square=?mm", ..."; empty where
/// nothing is found in them.
Message shown_target_text(const std::vector<InstantImages>& images);

}  // namespace handsight
