// SPDX-License-Identifier: Apache-2.0
// Two effects that are to be distinguished, as --between names them: "a,b".
#pragma once

#include <string>

#include "diagnosis/planning/planning.h"

namespace handsight::cli {

/// InputError where the text is not two effects without values.
CompetingEffects competing(const std::string& text, const Session& session);

}  // namespace handsight::cli
