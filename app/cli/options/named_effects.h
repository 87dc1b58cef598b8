// SPDX-License-Identifier: Apache-2.0
// Effects as users name them: ID, ID:PLACE+PLACE, ID:PLACE.NUMBER=VALUE.
#pragma once

#include <string>
#include <vector>

#include "effects/effect.h"
#include "session/session.h"

namespace handsight::cli {

/// Effects as users name them: those with values are held, the others estimated; where one has a choice (an observation
/// from which on it acts), the one that suits the session best.
void add_effects(const std::vector<std::string>& texts, const Session& session, std::vector<EffectTerm>& held,
                 std::vector<EffectTerm>& estimated);

}  // namespace handsight::cli
