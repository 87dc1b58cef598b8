// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/fuller_models.h"

#include <algorithm>
#include <set>

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/selection/model_search.h"
#include "diagnosis/space/model_space.h"
#include "diagnosis/verdict/stand_in.h"
#include "estimation/fit/fit.h"

namespace handsight {
namespace {

std::set<std::string> names_that_may_be(const std::vector<EffectTerm>& in_model,
                                        const InclusionProbabilities& certainty) {
  std::set<std::string> ids;
  for (const EffectTerm& t : in_model) ids.insert(t.id);
  for (const InclusionProbability& n : certainty.names) ids.insert(n.id);
  return ids;
}

/// A name of the robot, hand or cameras that may sit everywhere at once.
bool can_be_everywhere(const CandidateEffect& effect, const Problem& model) {
  const EffectTerm& one = effect.units.front().term;
  return !effect.effect->is_unnamed() && !is_change_between_sessions(one) && !is_judged_elsewhere(one, model) &&
         has_one_form(effect);
}

/// The terms of a name stand together. With curves: those of the model; nothing else of it is left out.
std::vector<EffectTerm> with_every_place(const Diagnosis& model, std::size_t first, const std::set<std::string>& ids,
                                         bool with_curves) {
  const Candidates candidates = all_candidates(model.model.fit.problem);
  std::vector<EffectTerm> terms = model.model_options.estimated;
  if (!with_curves)
    terms.erase(std::remove_if(terms.begin() + static_cast<std::ptrdiff_t>(first), terms.end(), is_curve), terms.end());
  for (const CandidateEffect& effect : candidates.effects) {
    if (!ids.contains(effect.effect->id) || !can_be_everywhere(effect, model.model.fit.problem)) continue;
    std::size_t at = terms.size();
    while (at > first && terms[at - 1].id != effect.effect->id) --at;
    if (at == first) at = terms.size();  // a new name
    for (const CandidateUnit& u : effect.units) terms.insert(terms.begin() + static_cast<std::ptrdiff_t>(at++), u.term);
  }
  return terms;
}

/// The model's answer, with what is not in it at 0.
Unknowns start_of(const Diagnosis& model, const std::vector<EffectTerm>& estimated) {
  Unknowns start = estimate(model.model.fit);
  const Problem& problem = model.model.fit.problem;
  std::vector<double> values;
  std::set<std::size_t> used;  // of the model's terms: some stand at one place in several forms
  for (const EffectTerm& t : estimated) {
    const Effect& effect = term_effect(t);
    std::size_t same = model.model_options.effects.size();
    while (same < problem.terms.size() &&
           (problem.terms[same].id != t.id || problem.terms[same].place != t.place || used.contains(same)))
      ++same;
    used.insert(same);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (is_free(effect, t, p)) values.push_back(same < problem.terms.size() ? problem.terms[same].values[p] : 0.0);
  }
  start.effects = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  return start;
}

std::optional<ModelAlternative> likelier_fuller_model(const Diagnosis& model, std::size_t first,
                                                      const std::vector<EffectTerm>& estimated,
                                                      const std::function<bool()>& goes_on) {
  FitOptions o = model.model_options;
  o.estimated = estimated;
  o.start = start_of(model, estimated);
  set_quick(noise_model(model.model.fit), o);
  o.on_iteration = [&](int, double, const Unknowns&) { return goes_on(); };
  const Fit fuller = fit(model.model.session, o);
  if (fuller.solution.stopped || !fuller.solution.normal.in_front) return std::nullopt;
  for (std::size_t t = 0; t < o.estimated.size(); ++t) o.estimated[t] = fuller.effects[o.effects.size() + t].term;
  return search_models_about(model, fuller, first, goes_on);
}

}  // namespace

ModelChange seek_fuller_model(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                              const InclusionProbabilities& certainty) {
  ModelChange change;
  if (stand_ins(model.model.fit).empty()) return change;  // nothing to be led back from
  const auto goes_on = [&] {
    if (options.on_progress && !options.on_progress(0.97)) change.stopped = true;
    return !change.stopped;
  };
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  const std::size_t first = begin_of_names(all, options.estimated.size());
  const std::vector<EffectTerm> names(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
  const std::set<std::string> ids = names_that_may_be(names, certainty);
  std::vector<ModelAlternative> found;
  for (const bool with_curves : {false, true}) {
    if (with_curves && std::none_of(names.begin(), names.end(), is_curve)) continue;
    auto other = likelier_fuller_model(model, first, with_every_place(model, first, ids, with_curves), goes_on);
    if (change.stopped) return change;
    if (other) found.push_back(std::move(*other));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const ModelAlternative& a, const ModelAlternative& b) { return a.ln_gained > b.ln_gained; });
  for (const ModelAlternative& other : found) {
    put_in_place(session, options, model, other, change);
    if (change.stopped || change.model) break;
  }
  return change;
}

}  // namespace handsight
