// SPDX-License-Identifier: Apache-2.0
#include "model/model.h"

#include <algorithm>

#include "base/bounds.h"
#include "effects/own_effect.h"

namespace handsight {
namespace {

std::string reported(const ModelEffect& e) { return e.place.empty() ? e.id : e.id + ":" + e.place; }

const Effect& known_effect(const ModelEffect& e, const Chain& chain, const OwnEffects& own) {
  const Effect* effect = find_effect(e.id, own);
  if (!effect) (void)effect_terms(e.id, chain, own);  // throws: it lists what is known
  check(effect != nullptr, "an effect {} that is not known was not refused", e.id);
  if (effect_places(*effect, chain).empty()) (void)effect_terms(e.id, chain, own);  // throws: where it may sit
  return *effect;
}

void require_values(const ModelEffect& e, const Effect& effect) {
  if (effect.scope == EffectScope::session && !e.place.empty())
    throw InputError(message("Effect \"{}\" sits at no joint; leave its place empty.", reported(e)));
  const std::size_t count = effect.parameters.size();
  if (!e.values.empty() && e.values.size() != count)
    throw InputError(message("Effect \"{}\" has {} values; expected {}, one for each parameter, or none.", reported(e),
                             e.values.size(), count));
  if (!e.held.empty() && e.held.size() != count)
    throw InputError(message("Effect \"{}\" says of {} parameters whether they are held; expected {}, or none.",
                             reported(e), e.held.size(), count));
  for (const double value : e.values)
    if (!bounds::effect_value.hold(value))
      throw InputError(message("Effect \"{}\" has the value {:g}; expected one from {:g} to {:g}.", reported(e), value,
                               bounds::effect_value.lowest, bounds::effect_value.highest));
}

EffectTerm term_for(const ModelEffect& e, const Session& session, const Chain& chain, const OwnEffects& own) {
  const Effect& effect = known_effect(e, chain, own);
  require_values(e, effect);
  std::vector<EffectTerm> terms;
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    add_effect_number(e.id, e.place, effect.parameters[p].name, e.values.empty() ? 0.0 : e.values[p], session.robot,
                      terms, own);
  if (const int needed = count_markers(terms); needed > session.marker_count)
    throw InputError(
        message("Effect \"{}\": the session has the markers 0 to {}.", reported(e), session.marker_count - 1));
  terms.front().held.assign(e.held.begin(), e.held.end());
  return terms.front();
}

ModelEffect effect_for(const EffectTerm& term, const Robot& robot, bool is_estimated) {
  const Effect& effect = term_effect(term);
  return {term.id,
          place_name(effect, term.place, robot),
          term.values,
          is_estimated,
          std::vector<bool>(term.held.begin(), term.held.end()),
          effect.definition};
}

}  // namespace

ModelTerms list_terms(const Model& model, const Session& session) {
  const Chain chain = make_chain(session);
  OwnEffects own = list_own_effects(session, chain);
  for (const ModelEffect& e : model.effects)
    if (e.formula && !find_effect(e.id, own))
      own.push_back(own_effect(*e.formula, session.robot, chain.rig.value_or(make_rig(StereoRig{}))));
  ModelTerms terms;
  for (const ModelEffect& e : model.effects)
    (e.is_estimated ? terms.estimated : terms.held).push_back(term_for(e, session, chain, own));
  return terms;
}

Model make_model(const ModelTerms& terms, const Robot& robot) {
  Model model;
  for (const EffectTerm& term : terms.held) model.effects.push_back(effect_for(term, robot, false));
  for (const EffectTerm& term : terms.estimated) model.effects.push_back(effect_for(term, robot, true));
  return model;
}

}  // namespace handsight
