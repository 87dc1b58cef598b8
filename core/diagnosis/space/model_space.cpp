// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/space/model_space.h"

#include <algorithm>

#include "base/combinations.h"
#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/refitting.h"

namespace handsight {
namespace {

double ln_odds_against_name(const EffectTerm& term) {
  return is_curve(term) ? ln_odds_against_curve(term) : ln_odds_against(term);
}

/// What one of the linear model's columns of the base is, in the problem's unit.
std::vector<double> sizes_of_base(const Problem& problem, const Unknowns& answer, Eigen::Index base_effects) {
  std::vector<double> sizes(static_cast<std::size_t>(problem.effect_column()), 1.0);
  for (Eigen::Index c = 0; c < base_effects; ++c) {
    const double plausible = problem.columns_of_effects[static_cast<std::size_t>(c)].sigma;
    sizes.push_back(plausible * times_prior_sigma(answer.effects[c] / plausible));
  }
  return sizes;
}

}  // namespace

ModelSpace::ModelSpace(const Fit& fit, std::size_t first, double cost_of_a_name,
                       const std::optional<Repeatability>& repeatability)
    : ModelSpace(fit, all_candidates(fit.problem), first, cost_of_a_name, repeatability) {}

ModelSpace::ModelSpace(const Fit& fit, const Candidates& others, std::size_t first, double cost_of_a_name,
                       const std::optional<Repeatability>& repeatability)
    : by_(noise_model(fit)) {
  base_ = std::count_if(fit.problem.columns_of_effects.begin(), fit.problem.columns_of_effects.end(),
                        [&](const EffectColumn& c) { return c.term < first; });
  for (std::size_t c = static_cast<std::size_t>(base_); c < others.problem.columns_of_effects.size(); ++c)
    sizes_.push_back(others.problem.columns_of_effects[c].sigma);
  list_units(fit.problem, first, others, cost_of_a_name);

  const Unknowns answer = estimate(fit);
  base_sizes_ = sizes_of_base(fit.problem, answer, base_);
  const LinearModel linear = linear_model(others.problem, answer, base_, by_.noise);
  const Repeatability scatter = repeatability ? *repeatability : fit_evidence(fit, base_, by_).repeatability;
  whitened_ = whiten(linear, scatter, by_.knowledge);
  score_ = handsight::score(whitened_, 0, linear.candidates());
  whitened_.model = nullptr;  // it ends here
  whitened_.external.resize(0, 0);
  whitened_.external_error.resize(0);
  widen(answer.effects.tail(fit.problem.effect_count() - base_));
  move_to_zero(answer.effects.tail(fit.problem.effect_count() - base_));
}

std::size_t ModelSpace::display_name(const EffectTerm& term, double cost) {
  std::size_t n = 0;
  while (n < names_.size() && names_[n].id != term.id) ++n;
  if (n == names_.size()) names_.push_back({term.id, cost + ln_odds_against_name(term)});
  return n;
}

bool is_judged_elsewhere(const EffectTerm& term, const Problem& model) {
  return follows_time(term) || (term.id == "target_scale" && !model.rig);
}

bool has_one_form(const CandidateEffect& effect) {
  std::set<int> places;
  return std::all_of(effect.units.begin(), effect.units.end(),
                     [&](const CandidateUnit& u) { return places.insert(u.term.place).second; });
}

/// Units of one name stand together. What is judged elsewhere can go, but does not come.
void ModelSpace::list_units(const Problem& model, std::size_t first_term, const Candidates& others, double cost) {
  for (std::size_t t = first_term; t < model.terms.size(); ++t)
    units_.push_back({model.terms[t], display_name(model.terms[t], cost), 0, 0, true});
  for (std::size_t c = static_cast<std::size_t>(base_); c < model.columns_of_effects.size(); ++c) {
    ModelSpaceUnit& unit = units_[model.columns_of_effects[c].term - first_term];
    if (unit.count++ == 0) unit.first = static_cast<Eigen::Index>(c) - base_;
  }
  for (const ModelSpaceUnit& u : units_) ++names_[u.name].places;
  const Eigen::Index present = others.base_effects - base_;
  for (const CandidateEffect& e : others.effects)
    for (const CandidateUnit& unit : e.units) {
      const std::size_t name = display_name(unit.term, cost);
      ++names_[name].places;
      if (!is_judged_elsewhere(unit.term, model)) units_.push_back({unit.term, name, present + unit.first, unit.count});
    }
  std::stable_sort(units_.begin(), units_.end(),
                   [](const ModelSpaceUnit& a, const ModelSpaceUnit& b) { return a.name < b.name; });
}

/// A place whose number is clearly large is plausible in its own way: with one size for all, the small ones beside it
/// would be charged for it, and fewer numbers that stand in for them would seem likelier.
void ModelSpace::widen(const Eigen::VectorXd& value) {
  Eigen::VectorXd times = Eigen::VectorXd::Ones(score_.gradient.size());
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    times[i] = times_prior_sigma(value[i] / plausible(i));
    sizes_[static_cast<std::size_t>(i)] *= times[i];
  }
  score_.gradient.array() *= times.array();
  score_.information = times.asDiagonal() * score_.information * times.asDiagonal();
  whitened_.shared = whitened_.shared * times.asDiagonal();
}

/// The score as it would be with all units at 0; it was taken with the present ones at these values.
void ModelSpace::move_to_zero(Eigen::VectorXd value) {
  for (Eigen::Index i = 0; i < value.size(); ++i) value[i] /= plausible(i);
  const Eigen::VectorXd moved = score_.information.leftCols(value.size()) * value;
  whitened_.residual_squares += (2 * score_.gradient + moved).head(value.size()).dot(value);
  score_.gradient += moved;
}

Chosen ModelSpace::present() const {
  Chosen chosen;
  for (std::size_t u = 0; u < units_.size(); ++u)
    if (units_[u].is_present) chosen.push_back(u);
  return chosen;
}

std::set<std::string> ModelSpace::list_names(const Chosen& chosen) const {
  std::set<std::string> names;
  for (const std::size_t u : chosen) names.insert(names_[units_[u].name].id);
  return names;
}

std::vector<Eigen::Index> ModelSpace::list_numbers(const Chosen& chosen) const {
  std::vector<Eigen::Index> numbers;
  for (const std::size_t u : chosen)
    for (Eigen::Index i = 0; i < units_[u].count; ++i) numbers.push_back(units_[u].first + i);
  return numbers;
}

Eigen::MatrixXd ModelSpace::base_by_numbers() const {
  Eigen::MatrixXd moved = whitened_.shared;
  if (moved.cols() > 0) whitened_.base.matrixL().transpose().solveInPlace(moved);
  const Eigen::Map<const Eigen::VectorXd> sizes(base_sizes_.data(), static_cast<Eigen::Index>(base_sizes_.size()));
  return -(sizes.asDiagonal() * moved);
}

double ModelSpace::compute_cost(const Chosen& chosen) const {
  double cost = 0;
  for (auto u = chosen.begin(); u != chosen.end();) {
    const std::size_t name = units_[*u].name;
    const auto next = std::find_if(u, chosen.end(), [&](std::size_t other) { return units_[other].name != name; });
    cost += names_[name].cost + ln_choose(names_[name].places, static_cast<double>(next - u));
    u = next;
  }
  return cost;
}

double ModelSpace::worth(const Chosen& chosen) const {
  return ln_bayes_factor(take_part(score_, list_numbers(chosen)), whitened_, by_.knowledge) - compute_cost(chosen);
}

bool ModelSpace::can_come(std::size_t unit, const Chosen& chosen) const {
  return std::none_of(chosen.begin(), chosen.end(), [&](std::size_t c) {
    return units_[c].name == units_[unit].name && units_[c].term.place == units_[unit].term.place;
  });
}

std::vector<EffectTerm> ModelSpace::list_terms(const Chosen& chosen) const {
  const std::vector<Eigen::Index> numbers = list_numbers(chosen);
  const LinearEstimate e = linear_estimate(take_part(score_, numbers), whitened_, by_.knowledge);
  std::vector<EffectTerm> terms;
  Eigen::Index number = 0;
  for (const std::size_t u : chosen) {
    terms.push_back(units_[u].term);
    const Effect& effect = term_effect(terms.back());
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      terms.back().values[p] = e.value[number] * plausible(numbers[static_cast<std::size_t>(number)]);
      ++number;
    }
  }
  return terms;
}

Chosen with_unit(Chosen chosen, std::size_t unit) {
  chosen.insert(std::upper_bound(chosen.begin(), chosen.end(), unit), unit);
  return chosen;
}

Chosen without_unit(Chosen chosen, std::size_t i) {
  chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(i));
  return chosen;
}

}  // namespace handsight
