// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/model_search.h"

#include <algorithm>
#include <array>

#include "base/threads.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/model_space.h"
#include "diagnosis/selection/pruning.h"

namespace handsight {
namespace {

constexpr double clearly = 3;        // ln of a Bayes factor, odds of 20
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

  /// Without what says nothing, one unit after another: a place of a name that stays has to be worth its numbers, also
  /// where all places of it would have been the fewest ways.
  Weighed pruned(Chosen chosen) const {
    for (;;) {
      std::vector<ParameterGroup> groups;
      for (const std::size_t u : chosen)
        groups.push_back({groups.empty() ? 0 : groups.back().first + groups.back().count, units_[u].count});
      const FactorsWithout factors = ln_bayes_factors_without(take_part(all_.score(), all_.list_numbers(chosen)),
                                                              groups, all_.whitened(), all_.by().knowledge);
      const double present = factors.whole - all_.compute_cost(chosen);
      double most = 0;
      std::optional<Chosen> fewer;
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        Chosen less = without_unit(chosen, i);
        double gained = factors.without[i] - all_.compute_cost(less) - present;
        if (is_one_of_several(chosen, i))
          gained = std::max(gained, worth_a_place - (factors.whole - factors.without[i]));
        if (gained <= most) continue;
        most = gained;
        fewer = std::move(less);
      }
      if (!fewer) return {std::move(chosen), present};
      chosen = std::move(*fewer);
    }
  }

  const ModelSpace& all_;
  const std::vector<ModelSpaceUnit>& units_;
};

std::vector<std::string> difference(const std::set<std::string>& all, const std::set<std::string>& those) {
  std::vector<std::string> left;
  std::set_difference(all.begin(), all.end(), those.begin(), those.end(), std::back_inserter(left));
  return left;
}

/// The best by first order, sought from what is present on; nothing where that is not clearly better.
std::optional<Chosen> better_choice(const ModelSpace& model_space, const std::function<bool()>& goes_on) {
  using Move = Weighed (Search::*)(const Chosen&) const;
  constexpr std::array<Move, 5> moves{&Search::with_one_more, &Search::with_one_name_more,
                                      &Search::with_others_for_a_unit, &Search::with_others_for_a_name,
                                      &Search::grown_afresh};
  const Search search(model_space);
  Weighed best{model_space.present(), 0};
  best.worth = model_space.worth(best.chosen);
  const double least = best.worth + clearly;
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

std::optional<ModelAlternative> search_models(const Diagnosis& model, std::size_t first,
                                              const std::function<bool()>& goes_on) {
  const ModelSpace model_space(model, first, model.threshold);
  const auto chosen = better_choice(model_space, goes_on);
  if (!chosen) return std::nullopt;

  const NoiseModel by = noise_model(model.model.fit);
  ModelAlternative other{{}, {}, model.model_options};
  FitOptions& o = other.options;
  o.estimated.resize(first);
  for (EffectTerm& t : model_space.list_terms(*chosen)) o.estimated.push_back(std::move(t));
  o.start = estimate(model.model.fit);
  set_quick(by, o);
  o.on_iteration = [&](int, double, const Unknowns&) { return goes_on(); };
  const Fit refit = fit(model.model.session, o);
  if (refit.solution.stopped || !refit.converged()) return std::nullopt;
  const auto ln_evidence = [&](const Fit& f, const Chosen& c) {
    return fit_evidence(f, model_space.base(), by).ln_evidence - model_space.compute_cost(c);
  };
  const Chosen present = model_space.present();
  if (ln_evidence(refit, *chosen) <= ln_evidence(model.model.fit, present) + clearly) return std::nullopt;
  o.on_iteration = nullptr;
  for (std::size_t t = first; t < o.estimated.size(); ++t) o.estimated[t] = refit.effects[o.effects.size() + t].term;
  o.start = estimate(refit);
  const std::set<std::string> before = model_space.list_names(present), after = model_space.list_names(*chosen);
  other.gone = difference(before, after);
  other.come = difference(after, before);
  return other;
}

}  // namespace handsight
