// SPDX-License-Identifier: Apache-2.0
#include "named_effects.h"

#include <algorithm>
#include <string_view>

#include "diagnosis/ranking/refitting.h"
#include "effects/own_effect.h"
#include "effects/part_effects.h"
#include "option_limits.h"

namespace handsight::cli {
namespace {

/// "a,b" as "a" and "b". A comma before anything that is no effect belongs to a name.
std::vector<std::string> apart(const std::vector<std::string>& texts, const OwnEffects& own) {
  std::vector<std::string> all;
  for (const std::string& text : texts) {
    std::string_view left = text;
    bool is_first = true;
    while (is_first || !left.empty()) {
      const std::size_t end = std::min(left.find(','), left.size());
      const std::string part(left.substr(0, end));
      if (is_first || find_effect(part.substr(0, part.find(':')), own))
        all.push_back(part);
      else
        all.back() += "," + part;
      left.remove_prefix(std::min(end + 1, left.size()));
      is_first = false;
    }
  }
  return all;
}

}  // namespace

void add_effects(const std::vector<std::string>& texts, const Session& session, std::vector<EffectTerm>& held,
                 std::vector<EffectTerm>& estimated) {
  const Chain chain = make_chain(session);
  const OwnEffects own = list_own_effects(session, chain);
  for (const std::string& text : apart(texts, own)) {
    if (text.find('=') != std::string::npos) {
      add_effect_value(text, session.robot, held, own);
      continue;
    }
    const std::vector<EffectTerm> named = effect_terms(text, chain, own);
    check_terms(named, session.marker_count);
    const std::vector<EffectTerm> terms = best_choices(session, named);
    estimated.insert(estimated.end(), terms.begin(), terms.end());
  }
  if (const std::vector<EffectTerm> of_parts = own_terms(chain, own); !of_parts.empty())
    estimated.insert(estimated.end(), of_parts.begin(), of_parts.end());
  check_terms(held, session.marker_count);
  check_terms(estimated, session.marker_count);
}

}  // namespace handsight::cli
