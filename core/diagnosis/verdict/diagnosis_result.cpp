// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/diagnosis_result.h"

#include <fmt/format.h>

#include "effects/coupled_joint.h"

namespace handsight {

double held_out_error(const Diagnosis& d) {
  const ErrorSummary& e = d.report.held_out;
  return e.rms_pixel ? *e.rms_pixel : e.rms_m.value_or(0);
}

ErrorSummary region_error(const Diagnosis& d) {
  const ErrorSummary& e = d.report.held_out_region;
  const bool is_known = e.rms_pixel || e.rms_m;
  return is_known ? e : held_out_by_region(d.model.session, d.model.fit, d.model_options);
}

const char* verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::too_few_observations:
      return "too_few_observations";
    case Verdict::adequate:
      return "adequate";
    case Verdict::missing_effect:
      return "missing_effect";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

std::vector<std::string> list_places(const std::vector<EffectTerm>& terms, const Session& session) {
  return list_places(terms, make_chain(session));
}

std::vector<std::string> list_places(const std::vector<EffectTerm>& terms, const Chain& chain) {
  std::vector<std::string> places;
  for (const EffectTerm& term : terms) {
    const Effect& effect = term_effect(term);
    const std::string place = place_name(effect, term.place, chain.robot);
    if (!place.empty()) places.push_back(place);
    if (effect.id == "joint_coupling")
      if (const auto other = coupled_joint(chain, term))
        places.push_back(chain.robot.joints[static_cast<std::size_t>(*other)].name);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (effect.parameters[p].is_choice && effect.parameters[p].choices.empty())
        places.push_back(message("from observation {:g} on", term.values[p]));
  }
  return places;
}

}  // namespace handsight
