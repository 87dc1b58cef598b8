// SPDX-License-Identifier: Apache-2.0
#include "option_limits.h"

#include <fmt/format.h>

#include "base/bounds.h"
#include "base/error.h"

namespace handsight::cli {

void check_terms(const std::vector<EffectTerm>& terms, int marker_count) {
  if (const int needed = count_markers(terms); needed > marker_count)
    throw InputError(
        message("An effect is named at marker {}; the session has the markers 0 to {}.", needed - 1, marker_count - 1));
  for (const EffectTerm& term : terms)
    for (const double value : term.values)
      if (!bounds::effect_value.hold(value))
        throw InputError(message("An effect {} has the value {:g}; expected one from {:g} to {:g}.", term.id, value,
                                 bounds::effect_value.lowest, bounds::effect_value.highest));
}

}  // namespace handsight::cli
