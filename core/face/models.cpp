// SPDX-License-Identifier: Apache-2.0
// Models from what users write and from what was found.
#include <algorithm>

#include "diagnosis/ranking/refitting.h"
#include "effects/own_effect.h"
#include "handsight/improve.h"

namespace handsight {

Model named_model(const Session& session, const std::vector<std::string>& effects) {
  const Chain chain = chain_of(session);
  const OwnEffects own = own_effects_of(session, chain);
  ModelTerms terms;
  for (const std::string& text : effects) {
    if (text.find('=') != std::string::npos) {
      add_effect_value(text, session.robot, terms.held, own);
      continue;
    }
    const std::vector<EffectTerm> named = effect_terms(text, chain, own);
    if (const int needed = markers_of(named); needed > session.marker_count)
      throw InputError(message("Effect \"{}\": the session has the markers 0 to {}.", text, session.marker_count - 1));
    const std::vector<EffectTerm> chosen = best_choices(session, named);
    terms.estimated.insert(terms.estimated.end(), chosen.begin(), chosen.end());
  }
  Model model = model_of(terms, session.robot);
  (void)terms_of(model, session);  // throws where a value is beyond all bounds
  return model;
}

Model model_of(const Fit& fit) {
  ModelTerms terms;
  for (const FittedEffect& e : fit.effects) {
    const bool moved = std::any_of(e.sigmas.begin(), e.sigmas.end(), [](double sigma) { return sigma > 0; });
    (moved ? terms.estimated : terms.held).push_back(e.term);
  }
  return model_of(terms, fit.problem.source->chain.robot);
}

Model model_of(const Improvement& improvement) { return model_of(improvement.last.model.fit); }

Model with_candidate(const Model& model, const DiagnosisCandidate& candidate, const Session& session) {
  if (candidate.terms.empty())
    throw InputError(
        "This candidate is a curve without a name that could not be written down; choose one that has terms.");
  ModelTerms terms = terms_of(model, session);
  terms.estimated.insert(terms.estimated.end(), candidate.terms.begin(), candidate.terms.end());
  return model_of(terms, session.robot);
}

}  // namespace handsight
