// SPDX-License-Identifier: Apache-2.0
#include "competing_effects.h"

#include "named_effects.h"

namespace handsight::cli {
namespace {

std::vector<EffectTerm> rival(const std::string& text, const Session& session) {
  if (text.find('=') != std::string::npos)
    throw InputError(
        message("--between: \"{}\" has a value; both effects are estimated, so write id or id:joint+joint.", text));
  std::vector<EffectTerm> held, estimated;
  add_effects({text}, session, held, estimated);
  return estimated;
}

}  // namespace

CompetingEffects competing(const std::string& text, const Session& session) {
  const auto comma = text.find(',');
  if (comma == std::string::npos || comma == 0 || comma + 1 == text.size() ||
      text.find(',', comma + 1) != std::string::npos)
    throw InputError(message(
        "--between \"{}\": expected two effects with a comma between, for example joint_scale,encoder_eccentricity.",
        text));
  CompetingEffects r;
  r.first_name = text.substr(0, comma);
  r.second_name = text.substr(comma + 1);
  r.first = rival(r.first_name, session);
  r.second = rival(r.second_name, session);
  return r;
}

}  // namespace handsight::cli
