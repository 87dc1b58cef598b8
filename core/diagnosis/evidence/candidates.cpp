// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/evidence/candidates.h"

#include <algorithm>

#include "effects/term_numbers.h"

namespace handsight {
namespace {

/// Orders of the used observations at which a step can be seen: some before it, some from it on.
std::vector<double> step_orders(const Problem& model, int most) {
  std::vector<double> orders;
  const std::size_t count = model.observations.size();
  constexpr std::size_t margin = 2;
  if (count <= 2 * margin) return orders;
  const std::size_t inner = count - 2 * margin + 1;
  const std::size_t kept = std::min<std::size_t>(inner, static_cast<std::size_t>(most));
  for (std::size_t i = 0; i < kept; ++i) {
    const std::size_t place = margin + (2 * i + 1) * inner / (2 * kept);
    const auto index = static_cast<std::size_t>(model.observations[place].index);
    orders.push_back(model.source->states[index].order);
  }
  return orders;
}

/// Every combination of an effect's choices, numbers 0. At most one parameter is an order.
std::vector<std::vector<double>> choices_of(const Effect& effect, const std::vector<double>& orders) {
  std::vector<std::vector<double>> all{std::vector<double>(effect.parameters.size(), 0.0)};
  for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
    if (!effect.parameters[p].is_choice) continue;
    std::vector<std::vector<double>> more;
    for (const std::vector<double>& values : all)
      for (const double choice : effect.parameters[p].choices.empty() ? orders : effect.parameters[p].choices) {
        more.push_back(values);
        more.back()[p] = choice;
      }
    all = std::move(more);
  }
  return all;
}

std::vector<double> list_sizes(const Effect& effect, const Problem& model) {
  std::vector<double> sizes;
  for (const EffectParameter& p : effect.parameters) sizes.push_back(prior_sigma(p, model.source->chain));
  return sizes;
}

/// Does a choice of an effect at one joint name something that is there? A coupling with a joint that the chain has not
/// got moves nothing whatever its size.
bool has_choice(const Effect& effect, int place, const std::vector<double>& values, const Chain& chain) {
  if (!moves_one_joint(effect)) return true;
  std::vector<double> sizes = values;
  bool chooses = false;
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    chooses = chooses || effect.parameters[p].is_choice;
    if (!effect.parameters[p].is_choice) sizes[p] = effect.parameters[p].sigma;
  }
  if (!chooses) return true;
  const auto count = static_cast<Eigen::Index>(chain.joints.size());
  Sites sites = unmoved_sites(chain);
  effect.move(states_at(chain, Eigen::VectorXd::Ones(count)), place, sizes, sites);
  const JointChange& j = sites.robot.joints[static_cast<std::size_t>(place)];
  return j.angle != 0 || !j.frame.isZero(0) || !j.after.isZero(0) || j.compliance != 0 || j.lateral_compliance != 0 ||
         j.gap != 0;
}

Candidates none_yet(const Problem& model) { return {{}, model, model.effect_count()}; }

/// Every unit of an effect that is not in the model yet, as a candidate.
struct Offer {
  const Problem& model;
  std::vector<double> orders;
  Candidates& candidates;

  void operator()(const Effect& effect, std::shared_ptr<const Effect> own) const;
};

bool same_unit(const Effect& effect, const EffectTerm& a, const EffectTerm& b) {
  if (a.id != b.id || a.place != b.place) return false;
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (effect.parameters[p].is_choice && a.values[p] != b.values[p]) return false;
  return true;
}

void add_unit(const Effect& effect, const EffectTerm& term, CandidateEffect& candidate, Problem& problem,
              Eigen::Index base_effects) {
  CandidateUnit unit{term, problem.effect_count() - base_effects, 0};
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (!effect.parameters[p].is_choice) {
      problem.columns_of_effects.push_back({problem.terms.size(), p, candidate.sizes[p]});
      ++unit.count;
    }
  problem.terms.push_back(term);
  candidate.units.push_back(unit);
}

void Offer::operator()(const Effect& effect, std::shared_ptr<const Effect> own) const {
  CandidateEffect candidate{&effect, {}, list_sizes(effect, model), own};
  for (const int place : effect_places(effect, model.source->chain)) {
    if (effect.scope == EffectScope::marker && !model.marker_is_seen[static_cast<std::size_t>(place)]) continue;
    for (const std::vector<double>& values : choices_of(effect, orders)) {
      if (!has_choice(effect, place, values, model.source->chain)) continue;
      EffectTerm term = term_of(effect, place, own);
      term.values = values;
      const bool is_in = std::any_of(model.terms.begin(), model.terms.end(),
                                     [&](const EffectTerm& t) { return same_unit(effect, t, term); });
      if (!is_in) add_unit(effect, term, candidate, candidates.problem, candidates.base_effects);
    }
  }
  if (!candidate.units.empty()) candidates.effects.push_back(std::move(candidate));
}

}  // namespace

Candidates all_candidates(const Problem& model, int most_orders) {
  Candidates candidates = none_yet(model);
  const Offer offer{model, step_orders(model, most_orders), candidates};
  for (const Effect* effect : catalogue_beside(model.source->own_effects)) offer(*effect, nullptr);
  for (const std::shared_ptr<const Effect>& own : model.source->own_effects) offer(*own, own);
  place_observations(candidates.problem);
  return candidates;
}

Candidates candidates_of(const Problem& model, const std::set<std::string>& effects) {
  Candidates candidates = none_yet(model);
  const Offer offer{model, {}, candidates};
  for (const Effect* effect : catalogue_beside(model.source->own_effects))
    if (effects.contains(effect->id)) offer(*effect, nullptr);
  place_observations(candidates.problem);
  return candidates;
}

Candidates list_candidates(const Problem& model, const std::vector<EffectTerm>& terms) {
  Candidates candidates = none_yet(model);
  for (const EffectTerm& term : terms) {
    const Effect& effect = term_effect(term);
    EffectTerm at = term;
    clear_numbers(at);
    candidates.effects.push_back({&effect, {}, list_sizes(effect, model), term.own});
    add_unit(effect, at, candidates.effects.back(), candidates.problem, candidates.base_effects);
  }
  place_observations(candidates.problem);
  return candidates;
}

namespace {

/// A term's effect at its place alone, a unit for each of these values.
Candidates at_place(const Problem& model, const EffectTerm& term, const std::vector<std::vector<double>>& choices) {
  Candidates candidates = none_yet(model);
  const Effect& effect = term_effect(term);
  CandidateEffect candidate{&effect, {}, list_sizes(effect, model), term.own};
  for (const std::vector<double>& values : choices) {
    EffectTerm at = term;
    at.values = values;
    add_unit(effect, at, candidate, candidates.problem, candidates.base_effects);
  }
  candidates.effects.push_back(std::move(candidate));
  place_observations(candidates.problem);
  return candidates;
}

}  // namespace

Candidates choices_at_place(const Problem& model, const EffectTerm& term, int most_orders) {
  std::vector<std::vector<double>> choices = choices_of(term_effect(term), step_orders(model, most_orders));
  std::erase_if(choices, [&](const std::vector<double>& values) {
    return !has_choice(term_effect(term), term.place, values, model.source->chain);
  });
  return at_place(model, term, choices);
}

Candidates candidates_at_orders(const Problem& model, const EffectTerm& term, const std::vector<double>& orders) {
  const Effect& effect = term_effect(term);
  std::vector<std::vector<double>> choices;
  EffectTerm at = term;
  clear_numbers(at);
  for (const double order : orders) {
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (effect.parameters[p].is_choice && effect.parameters[p].choices.empty()) at.values[p] = order;
    choices.push_back(at.values);
  }
  return at_place(model, term, choices);
}

}  // namespace handsight
