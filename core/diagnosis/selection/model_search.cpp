// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/model_search.h"

#include <algorithm>
#include <array>

#include "base/threads.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/exchange.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/space/model_space.h"

namespace handsight {
namespace {

constexpr double least_gain = 1e-6;  // of two ways round, the last digit would go on for ever

struct Weighed {
  Chosen chosen;
  double worth = 0;  // ln of the evidence against none, with what it costs to choose so
};

/// Climbs from one choice to a better one.
class Search {
 public:
  explicit Search(const ModelSpace& model_space) : all_(model_space), units_(model_space.units()) {}

  /// The best that comes of these by one unit more, or none, and dropping what says nothing any more.
  Weighed with_one_more(const Chosen& chosen) const {
    std::vector<Chosen> starts{chosen};
    for (std::size_t u = 0; u < units_.size(); ++u)
      if (all_.can_come(u, chosen)) starts.push_back(with_unit(chosen, u));
    std::vector<Weighed> made(starts.size());
    each_part(static_cast<int>(starts.size()), true,
              [&](int i) { made[static_cast<std::size_t>(i)] = pruned(starts[static_cast<std::size_t>(i)]); });
    return best_of(made);
  }

  /// The best that comes of these by a name everywhere, and dropping what says nothing any more: several of its places
  /// may be worth a name that none of them is worth alone.
  Weighed with_one_name_more(const Chosen& chosen) const {
    std::vector<Weighed> made(all_.names().size());
    each_part(static_cast<int>(all_.names().size()), true, [&](int name) {
      Chosen more = chosen;
      for (std::size_t u = 0; u < units_.size(); ++u)
        if (units_[u].name == static_cast<std::size_t>(name) && all_.can_come(u, more)) more = with_unit(more, u);
      made[static_cast<std::size_t>(name)] = pruned(std::move(more));
    });
    return best_of(made);
  }

  /// The best that comes of none, whatever stands: where names were added one after another, the order has a say.
  Weighed grown_afresh(const Chosen& /*chosen*/) const { return grown({{}, all_.worth({})}, units_.size()); }

  /// The best that comes of these where others grow in the place of one unit.
  Weighed with_others_for_a_unit(const Chosen& chosen) const {
    std::vector<Weighed> made(chosen.size());
    each_part(static_cast<int>(chosen.size()), true, [&](int i) {
      const std::size_t barred = chosen[static_cast<std::size_t>(i)];
      const Chosen left = without_unit(chosen, static_cast<std::size_t>(i));
      made[static_cast<std::size_t>(i)] = grown({left, all_.worth(left)}, barred);
    });
    return best_of(made);
  }

  /// The best that comes of these where others, or the same again, grow in the place of a name at several places.
  Weighed with_others_for_a_name(const Chosen& chosen) const {
    std::vector<Weighed> made;
    for (std::size_t name = 0; name < all_.names().size(); ++name) {
      Chosen left;
      std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(left),
                   [&](std::size_t u) { return units_[u].name != name; });
      if (left.size() + 1 < chosen.size()) made.push_back(grown({left, all_.worth(left)}, units_.size()));
    }
    return best_of(made);
  }

  /// Without what says nothing, one unit after another: a place of a name that stays has to be worth its numbers, also
  /// where all places of it would have been the fewest ways.
  Weighed pruned(Chosen chosen) const;

 private:
  static Weighed best_of(const std::vector<Weighed>& made) {
    const auto best = std::max_element(made.begin(), made.end(),
                                       [](const Weighed& a, const Weighed& b) { return a.worth < b.worth; });
    return best == made.end() ? Weighed{{}, -1e300} : *best;
  }

  /// With one unit after another, as long as that is worth it; but not with `barred`.
  Weighed grown(Weighed now, std::size_t barred) const {
    for (;;) {
      Chosen coming;
      std::vector<ParameterGroup> groups;
      for (std::size_t u = 0; u < units_.size(); ++u) {
        if (u == barred || !all_.can_come(u, now.chosen)) continue;
        coming.push_back(u);
        groups.push_back({units_[u].first, units_[u].count});
      }
      const std::vector<double> factors = ln_bayes_factors_beside(all_.score(), all_.list_numbers(now.chosen), groups,
                                                                  all_.whitened(), all_.by().knowledge);
      Weighed best = now;
      for (std::size_t i = 0; i < coming.size(); ++i) {
        const Chosen more = with_unit(now.chosen, coming[i]);
        const double worth = factors[i] - all_.compute_cost(more);
        if (worth > best.worth + least_gain) best = {more, worth};
      }
      best = pruned(best.chosen);
      if (best.worth <= now.worth + least_gain) return now;
      now = std::move(best);
    }
  }

  bool is_one_of_several(const Chosen& chosen, std::size_t i) const {
    const std::size_t name = units_[chosen[i]].name;
    return (i > 0 && units_[chosen[i - 1]].name == name) ||
           (i + 1 < chosen.size() && units_[chosen[i + 1]].name == name);
  }

  const ModelSpace& all_;
  const std::vector<ModelSpaceUnit>& units_;
};

Weighed Search::pruned(Chosen chosen) const {
  for (;;) {
    std::vector<ParameterGroup> groups;
    for (const std::size_t u : chosen)
      groups.push_back({groups.empty() ? 0 : groups.back().first + groups.back().count, units_[u].count});
    const FactorsWithout factors = ln_bayes_factors_without(take_part(all_.score(), all_.list_numbers(chosen)), groups,
                                                            all_.whitened(), all_.by().knowledge);
    const double present = factors.whole - all_.compute_cost(chosen);
    double most = 0;
    std::optional<Chosen> fewer;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      Chosen less = without_unit(chosen, i);
      double gained = factors.without[i] - all_.compute_cost(less) - present;
      if (is_one_of_several(chosen, i)) gained = std::max(gained, worth_a_place - (factors.whole - factors.without[i]));
      if (gained <= most) continue;
      most = gained;
      fewer = std::move(less);
    }
    if (!fewer) return {std::move(chosen), present};
    chosen = std::move(*fewer);
  }
}

/// The best by first order, sought from what is present on; nothing where that is not clearly better than what stands.
std::optional<Chosen> better_choice(const ModelSpace& model_space, const Chosen& stands,
                                    const std::function<bool()>& goes_on) {
  using Move = Weighed (Search::*)(const Chosen&) const;
  constexpr std::array<Move, 5> moves{&Search::with_one_more, &Search::with_one_name_more,
                                      &Search::with_others_for_a_unit, &Search::with_others_for_a_name,
                                      &Search::grown_afresh};
  const Search search(model_space);
  const double least = model_space.worth(stands) + clear_gain;
  Weighed best = search.pruned(model_space.present());
  for (std::size_t move = 0; move < moves.size();) {
    if (!goes_on()) return std::nullopt;
    Weighed next = (search.*moves[move])(best.chosen);
    const bool climbs = next.worth > best.worth + least_gain;
    if (climbs) best = std::move(next);
    move = climbs ? 0 : move + 1;
  }
  return best.worth > least ? std::optional(best.chosen) : std::nullopt;
}

}  // namespace

namespace {

/// The terms of a choice in the place of the model's from `first` on, fitted from there in full.
std::optional<Refit> fitted_with(const Diagnosis& model, const ModelSpace& space, const Chosen& chosen,
                                 const Fit& start, std::size_t first, const std::function<bool()>& goes_on) {
  Refit r;
  r.options = model.model_options;
  r.options.estimated.resize(first);
  for (EffectTerm& t : space.list_terms(chosen)) r.options.estimated.push_back(std::move(t));
  r.options.start = estimate(start);
  set_quick(noise_model(model.model.fit), r.options);
  r.options.on_iteration = [&](int, double, const Unknowns&) { return goes_on(); };
  r.fit = fit(model.model.session, r.options);
  if (r.fit.solution.stopped || !r.fit.converged()) return std::nullopt;
  r.options.on_iteration = nullptr;
  for (std::size_t t = first; t < r.options.estimated.size(); ++t)
    r.options.estimated[t] = r.fit.effects[r.options.effects.size() + t].term;
  r.options.start = estimate(r.fit);
  return r;
}

/// The units that are terms of the model from `first` on.
Chosen units_of(const Diagnosis& model, const ModelSpace& space, std::size_t first) {
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  Chosen chosen;
  for (std::size_t u = 0; u < space.units().size(); ++u) {
    const ModelSpaceUnit& unit = space.units()[u];
    const bool is_of_it = unit.is_present && std::any_of(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(),
                                                         [&](const EffectTerm& t) {
                                                           return t.id == unit.term.id && t.place == unit.term.place;
                                                         });
    if (is_of_it) chosen.push_back(u);
  }
  return chosen;
}

/// What the curves of a model cost that are not among the units of a space; nothing else of it is missing there.
double cost_of_curves_beside(const ModelSpace& space, const Diagnosis& model, std::size_t first) {
  std::set<std::string> beside;
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  for (std::size_t t = first; t < all.size(); ++t)
    if (std::none_of(space.names().begin(), space.names().end(),
                     [&](const ModelSpaceEffect& name) { return name.id == all[t].id; }))
      beside.insert(all[t].id);
  return static_cast<double>(beside.size()) * (model.threshold + ln_ways_of_curves - ln_odds_of_unnamed);
}

/// A choice of `space`, whose names the model's stand in too, fitted in full: where its evidence is above the model's
/// by more than `least` (ln).
std::optional<ModelAlternative> fitted_choice(const ModelSpace& space, const Chosen& chosen, const Diagnosis& model,
                                              const Fit& start, std::size_t first, double least,
                                              const std::function<bool()>& goes_on) {
  auto refit = fitted_with(model, space, chosen, start, first, goes_on);
  if (!refit) return std::nullopt;
  const Chosen stands = units_of(model, space, first);
  const NoiseModel by = noise_model(model.model.fit);
  const auto ln_evidence = [&](const Fit& f, const Chosen& c) {
    return fit_evidence(f, space.base(), by).ln_evidence - space.compute_cost(c);
  };
  const double gained = ln_evidence(refit->fit, chosen) - ln_evidence(model.model.fit, stands) +
                        cost_of_curves_beside(space, model, first);
  if (gained <= least) return std::nullopt;
  const auto from = static_cast<std::ptrdiff_t>(first);
  const std::vector<EffectTerm>&was = model.model_options.estimated, &is = refit->options.estimated;
  const ChangedNames changed = changed_names({was.begin() + from, was.end()}, {is.begin() + from, is.end()});
  return ModelAlternative{changed.gone, changed.come, std::move(refit->options), gained};
}

/// What is clearly likelier in `space` than the model, whose names stand in it too.
std::optional<ModelAlternative> likelier_in(const ModelSpace& space, const Diagnosis& model, const Fit& start,
                                            std::size_t first, const std::function<bool()>& goes_on) {
  const auto chosen = better_choice(space, units_of(model, space, first), goes_on);
  return chosen ? fitted_choice(space, *chosen, model, start, first, clear_gain, goes_on) : std::nullopt;
}

}  // namespace

std::optional<ModelAlternative> search_models(const Diagnosis& model, std::size_t first,
                                              const std::function<bool()>& goes_on) {
  return likelier_in(ModelSpace(model.model.fit, term_of_fit(model, first), model.threshold), model, model.model.fit,
                     first, goes_on);
}

std::optional<ModelAlternative> fit_likeliest(const Diagnosis& model, std::size_t first,
                                              const InclusionProbabilities& inclusion_probabilities,
                                              const std::function<bool()>& goes_on) {
  const std::optional<Chosen>& chosen = inclusion_probabilities.likeliest;
  if (!chosen) return std::nullopt;
  const ModelSpace space(model.model.fit, term_of_fit(model, first), InclusionProbabilities::cost_of_a_name);
  if (*chosen == space.present()) return std::nullopt;
  return fitted_choice(space, *chosen, model, model.model.fit, first, -inclusion_probabilities.ln_of_small_causes,
                       goes_on);
}

std::optional<ModelAlternative> search_models_about(const Diagnosis& model, const Fit& fuller, std::size_t first,
                                                    const std::function<bool()>& goes_on) {
  return likelier_in(ModelSpace(fuller, term_of_fit(model, first), model.threshold), model, fuller, first, goes_on);
}

}  // namespace handsight
