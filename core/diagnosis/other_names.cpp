// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/other_names.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/combinations.h"
#include "base/threads.h"
#include "diagnosis/curves.h"
#include "diagnosis/exchange.h"
#include "diagnosis/refitting.h"
#include "diagnosis/slips.h"
#include "diagnosis/upkeep.h"

namespace handsight {
namespace {

constexpr double clearly = 3;        // ln of a Bayes factor, odds of 20
constexpr double least_gain = 1e-6;  // of two ways round, the last digit would go on for ever

struct Name {
  std::string id;
  double cost = 0;  // ln of the odds against it, without its places
  int places = 0;   // at which it could sit
};

/// An effect at one place.
struct Unit {
  EffectTerm term;  // at the model's answer
  std::size_t name = 0;
  Eigen::Index first = 0, count = 0;  // columns
  bool is_present = false;
};

/// Places in a list of units, in order.
using Chosen = std::vector<std::size_t>;

double ln_odds_against(const EffectTerm& term) {
  if (is_curve(term)) return ln_ways_of_curves - ln_odds_of_unnamed;
  return slip_order({term}) ? ln_odds_against_slip : 0;
}

struct Weighed {
  Chosen chosen;
  double worth = 0;  // ln of the evidence against none, with what it costs to choose so
};

/// All that the catalogue could put in the place of a model's terms from `first` on, and what the measurements say of
/// it together, to first order about the model's answer.
class Explanations {
 public:
  Explanations(const Diagnosis& model, std::size_t first) : by_(weighing(model.model.fit)) {
    const Fit& fit = model.model.fit;
    const Candidates others = all_candidates(fit.problem);
    const std::size_t first_term = model.model_options.effects.size() + first;
    base_ = std::count_if(fit.problem.columns_of_effects.begin(), fit.problem.columns_of_effects.end(),
                          [&](const EffectColumn& c) { return c.term < first_term; });
    for (std::size_t c = static_cast<std::size_t>(base_); c < others.problem.columns_of_effects.size(); ++c)
      sizes_.push_back(others.problem.columns_of_effects[c].sigma);
    list_units(fit.problem, first_term, others, model.threshold);

    const Unknowns answer = estimate(fit);
    const LinearModel linear = linear_model(others.problem, answer, base_, by_.noise);
    w_ = whiten(linear, fit_evidence(fit, base_, by_).scatter, by_.knowledge);
    all_ = score(w_, 0, linear.candidates());
    w_.model = nullptr;  // it ends here
    move_to_zero(answer.effects.tail(fit.problem.effect_count() - base_));
  }

  Chosen present() const {
    Chosen chosen;
    for (std::size_t u = 0; u < units_.size(); ++u)
      if (units_[u].is_present) chosen.push_back(u);
    return chosen;
  }

  Eigen::Index base() const { return base_; }

  std::set<std::string> names_of(const Chosen& chosen) const {
    std::set<std::string> names;
    for (const std::size_t u : chosen) names.insert(names_[units_[u].name].id);
    return names;
  }

  /// ln of the odds against so many names, and of the ways in which they could have sat at so many places.
  double cost_of(const Chosen& chosen) const {
    double cost = 0;
    for (auto u = chosen.begin(); u != chosen.end();) {
      const std::size_t name = units_[*u].name;
      const auto next = std::find_if(u, chosen.end(), [&](std::size_t other) { return units_[other].name != name; });
      cost += names_[name].cost + ln_choose(names_[name].places, static_cast<double>(next - u));
      u = next;
    }
    return cost;
  }

  /// ln of their evidence against none.
  double worth(const Chosen& chosen) const {
    return ln_bayes_factor(part_of(all_, columns_of(chosen)), w_, by_.knowledge) - cost_of(chosen);
  }

  /// The best that comes of these by one unit more, or none, and dropping what says nothing any more.
  Weighed with_one_more(const Chosen& chosen) const {
    std::vector<Chosen> starts{chosen};
    for (std::size_t u = 0; u < units_.size(); ++u)
      if (can_come(u, chosen)) starts.push_back(with(chosen, u));
    std::vector<Weighed> made(starts.size());
    each_part(static_cast<int>(starts.size()), true,
              [&](int i) { made[static_cast<std::size_t>(i)] = pruned(starts[static_cast<std::size_t>(i)]); });
    return best_of(made);
  }

  /// The best that comes of these by a name everywhere, and dropping what says nothing any more: several of its places
  /// may be worth a name that none of them is worth alone.
  Weighed with_one_name_more(const Chosen& chosen) const {
    std::vector<Weighed> made(names_.size());
    each_part(static_cast<int>(names_.size()), true, [&](int name) {
      Chosen more = chosen;
      for (std::size_t u = 0; u < units_.size(); ++u)
        if (units_[u].name == static_cast<std::size_t>(name) && can_come(u, more)) more = with(more, u);
      made[static_cast<std::size_t>(name)] = pruned(std::move(more));
    });
    return best_of(made);
  }

  /// The best that comes of these where others grow in the place of one unit.
  Weighed with_others_for_a_unit(const Chosen& chosen) const {
    std::vector<Weighed> made(chosen.size());
    each_part(static_cast<int>(chosen.size()), true, [&](int i) {
      const std::size_t barred = chosen[static_cast<std::size_t>(i)];
      Chosen left = chosen;
      left.erase(left.begin() + i);
      made[static_cast<std::size_t>(i)] = grown({left, worth(left)}, barred);
    });
    return best_of(made);
  }

  /// The best that comes of these where others, or the same again, grow in the place of a name at several places.
  Weighed with_others_for_a_name(const Chosen& chosen) const {
    std::vector<Weighed> made;
    for (std::size_t name = 0; name < names_.size(); ++name) {
      Chosen left;
      std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(left),
                   [&](std::size_t u) { return units_[u].name != name; });
      if (left.size() + 1 < chosen.size()) made.push_back(grown({left, worth(left)}, units_.size()));
    }
    return best_of(made);
  }

  /// Their terms at the estimate to first order.
  std::vector<EffectTerm> terms_of(const Chosen& chosen) const {
    const std::vector<Eigen::Index> columns = columns_of(chosen);
    const LinearEstimate e = linear_estimate(part_of(all_, columns), w_, by_.knowledge);
    std::vector<EffectTerm> terms;
    Eigen::Index number = 0;
    for (const std::size_t u : chosen) {
      terms.push_back(units_[u].term);
      const Effect& effect = effect_of(terms.back());
      for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
        if (effect.parameters[p].is_choice) continue;
        const auto column = static_cast<std::size_t>(columns[static_cast<std::size_t>(number)]);
        terms.back().values[p] = e.value[number++] * sizes_[column];
      }
    }
    return terms;
  }

 private:
  std::size_t name_of(const EffectTerm& term, double threshold) {
    std::size_t n = 0;
    while (n < names_.size() && names_[n].id != term.id) ++n;
    if (n == names_.size()) names_.push_back({term.id, threshold + ln_odds_against(term)});
    return n;
  }

  /// Units of one name stand together. What begins at some observation can go, but does not come: its moment is sought
  /// elsewhere.
  void list_units(const Problem& model, std::size_t first_term, const Candidates& others, double threshold) {
    for (std::size_t t = first_term; t < model.terms.size(); ++t)
      units_.push_back({model.terms[t], name_of(model.terms[t], threshold), 0, 0, true});
    for (std::size_t c = static_cast<std::size_t>(base_); c < model.columns_of_effects.size(); ++c) {
      Unit& unit = units_[model.columns_of_effects[c].term - first_term];
      if (unit.count++ == 0) unit.first = static_cast<Eigen::Index>(c) - base_;
    }
    for (const Unit& u : units_) ++names_[u.name].places;
    const Eigen::Index present = others.base_effects - base_;
    for (const CandidateEffect& e : others.effects)
      for (const CandidateUnit& unit : e.units) {
        const std::size_t name = name_of(unit.term, threshold);
        ++names_[name].places;
        if (!slip_order({unit.term})) units_.push_back({unit.term, name, present + unit.first, unit.count});
      }
    std::stable_sort(units_.begin(), units_.end(), [](const Unit& a, const Unit& b) { return a.name < b.name; });
  }

  /// The score as it would be with all units at 0; it was taken with the present ones at these values.
  void move_to_zero(Eigen::VectorXd value) {
    for (Eigen::Index i = 0; i < value.size(); ++i) value[i] /= sizes_[static_cast<std::size_t>(i)];
    const Eigen::VectorXd moved = all_.information.leftCols(value.size()) * value;
    w_.residual_squares += (2 * all_.gradient + moved).head(value.size()).dot(value);
    all_.gradient += moved;
  }

  std::vector<Eigen::Index> columns_of(const Chosen& chosen) const {
    std::vector<Eigen::Index> columns;
    for (const std::size_t u : chosen)
      for (Eigen::Index i = 0; i < units_[u].count; ++i) columns.push_back(units_[u].first + i);
    return columns;
  }

  /// Not what is in already, nor another form of it at the same place.
  bool can_come(std::size_t u, const Chosen& chosen) const {
    return std::none_of(chosen.begin(), chosen.end(), [&](std::size_t c) {
      return units_[c].name == units_[u].name && units_[c].term.joint == units_[u].term.joint;
    });
  }

  static Chosen with(Chosen chosen, std::size_t u) {
    chosen.insert(std::upper_bound(chosen.begin(), chosen.end(), u), u);
    return chosen;
  }

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
        if (u == barred || !can_come(u, now.chosen)) continue;
        coming.push_back(u);
        groups.push_back({units_[u].first, units_[u].count});
      }
      const std::vector<double> factors =
          ln_bayes_factors_beside(all_, columns_of(now.chosen), groups, w_, by_.knowledge);
      Weighed best = now;
      for (std::size_t i = 0; i < coming.size(); ++i) {
        const Chosen more = with(now.chosen, coming[i]);
        const double worth = factors[i] - cost_of(more);
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
      const FactorsWithout factors =
          ln_bayes_factors_without(part_of(all_, columns_of(chosen)), groups, w_, by_.knowledge);
      const double present = factors.whole - cost_of(chosen);
      double most = 0;
      std::optional<Chosen> fewer;
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        Chosen less = chosen;
        less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
        double gained = factors.without[i] - cost_of(less) - present;
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

  Weighing by_;
  Eigen::Index base_ = 0;  // effect columns of the terms before
  std::vector<Name> names_;
  std::vector<Unit> units_;
  std::vector<double> sizes_;  // plausible, by column
  WhitenedModel w_;
  Score all_;
};

std::vector<std::string> without(const std::set<std::string>& all, const std::set<std::string>& those) {
  std::vector<std::string> left;
  std::set_difference(all.begin(), all.end(), those.begin(), those.end(), std::back_inserter(left));
  return left;
}

/// The best by first order, sought from what is present on; nothing where that is not clearly better.
std::optional<Chosen> better_choice(const Explanations& explanations, const std::function<bool()>& goes_on) {
  using Move = Weighed (Explanations::*)(const Chosen&) const;
  constexpr std::array<Move, 4> moves{&Explanations::with_one_more, &Explanations::with_one_name_more,
                                      &Explanations::with_others_for_a_unit, &Explanations::with_others_for_a_name};
  Weighed best{explanations.present(), 0};
  best.worth = explanations.worth(best.chosen);
  const double least = best.worth + clearly;
  for (std::size_t move = 0; move < moves.size();) {
    if (!goes_on()) return std::nullopt;
    Weighed next = (explanations.*moves[move])(best.chosen);
    const bool climbs = next.worth > best.worth + least_gain;
    if (climbs) best = std::move(next);
    move = climbs ? 0 : move + 1;
  }
  return best.worth > least ? std::optional(best.chosen) : std::nullopt;
}

}  // namespace

std::optional<OtherNames> other_names(const Diagnosis& model, std::size_t first, const std::function<bool()>& goes_on) {
  const Explanations explanations(model, first);
  const auto chosen = better_choice(explanations, goes_on);
  if (!chosen) return std::nullopt;

  const Weighing by = weighing(model.model.fit);
  OtherNames other{{}, {}, model.model_options};
  FitOptions& o = other.options;
  o.estimated.resize(first);
  for (EffectTerm& t : explanations.terms_of(*chosen)) o.estimated.push_back(std::move(t));
  o.start = estimate(model.model.fit);
  set_quick(by, o);
  o.on_iteration = [&](int, double, const Unknowns&) { return goes_on(); };
  const Fit refit = fit(model.model.session, o);
  if (refit.solution.stopped || !refit.converged()) return std::nullopt;
  const auto ln_evidence = [&](const Fit& f, const Chosen& c) {
    return fit_evidence(f, explanations.base(), by).ln_evidence - explanations.cost_of(c);
  };
  const Chosen present = explanations.present();
  if (ln_evidence(refit, *chosen) <= ln_evidence(model.model.fit, present) + clearly) return std::nullopt;
  o.on_iteration = nullptr;
  for (std::size_t t = first; t < o.estimated.size(); ++t) o.estimated[t] = refit.effects[o.effects.size() + t].term;
  o.start = estimate(refit);
  const std::set<std::string> before = explanations.names_of(present), after = explanations.names_of(*chosen);
  other.gone = without(before, after);
  other.come = without(after, before);
  return other;
}

}  // namespace handsight
