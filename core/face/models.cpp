// SPDX-License-Identifier: Apache-2.0
// Models from what users write and from what was found.
#include <algorithm>

#include "diagnosis/ranking/refitting.h"
#include "effects/own_effect.h"
#include "handsight/improve.h"

namespace handsight {

Model named_model(const Session& session, const std::vector<std::string>& effects) {
  const Chain chain = make_chain(session);
  const OwnEffects own = list_own_effects(session, chain);
  ModelTerms terms;
  for (const std::string& text : effects) {
    if (text.find('=') != std::string::npos) {
      add_effect_value(text, session.robot, terms.held, own);
      continue;
    }
    const std::vector<EffectTerm> named = effect_terms(text, chain, own);
    if (const int needed = count_markers(named); needed > session.marker_count)
      throw InputError(message("Effect \"{}\": the session has the markers 0 to {}.", text, session.marker_count - 1));
    const std::vector<EffectTerm> chosen = best_choices(session, named);
    terms.estimated.insert(terms.estimated.end(), chosen.begin(), chosen.end());
  }
  Model model = make_model(terms, session.robot);
  (void)list_terms(model, session);  // throws where a value is beyond all bounds
  return model;
}

Model make_model(const Fit& fit) {
  ModelTerms terms;
  for (const FittedEffect& e : fit.effects) {
    const bool moved = std::any_of(e.sigmas.begin(), e.sigmas.end(), [](double sigma) { return sigma > 0; });
    (moved ? terms.estimated : terms.held).push_back(e.term);
  }
  return make_model(terms, fit.problem.source->chain.robot);
}

Model make_model(const Improvement& improvement) { return make_model(improvement.last.model.fit); }

Model with_candidate(const Model& model, const DiagnosisCandidate& candidate, const Session& session) {
  if (candidate.terms.empty())
    throw InputError(
        "This candidate is a curve without a name that could not be written down; choose one that has terms.");
  ModelTerms terms = list_terms(model, session);
  terms.estimated.insert(terms.estimated.end(), candidate.terms.begin(), candidate.terms.end());
  return make_model(terms, session.robot);
}

}  // namespace handsight
