// SPDX-License-Identifier: Apache-2.0
#include "compare/several_changes.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace handsight {
namespace {

bool is_one_marker(const std::vector<ChangeUnit>& units) {
  return std::count_if(units.begin(), units.end(), [](const ChangeUnit& u) { return u.group == "marker_slip"; }) == 1;
}

}  // namespace

SeveralComparer::SeveralComparer(SeveralSides sides) : sides_(std::move(sides)), state_(sides_.start) {
  for (const SeveralSide& s : sides_.sides) of_sides_.push_back(change_units(s.problem));
  list_units();
  list_alternatives();
}

/// What two sides and more have in common, distinguished by effect, place and whose it is.
void SeveralComparer::list_units() {
  std::map<std::tuple<std::string, int, Owner, int>, std::size_t> known;
  for (std::size_t k = 0; k < of_sides_.size(); ++k)
    for (std::size_t u = 0; u < of_sides_[k].size(); ++u) {
      const ChangeUnit& own = of_sides_[k][u];
      if (own.group == "marker_slip" && is_one_marker(of_sides_[k])) continue;  // that is a slip of the body
      const EffectTerm& term = own.terms.front();
      const Owner owner = find_owner(term_effect(term));
      const auto [at, is_new] =
          known.emplace(std::tuple{term.id, term.place, owner, sides_.sides[k].number(owner)}, units_.size());
      if (is_new) units_.push_back({own.group, own.where, std::vector<int>(of_sides_.size(), -1), {}});
      SeveralUnit& unit = units_[at->second];
      if (!unit.who.empty() && handsight::count_numbers(find_unit(unit.who.front(), at->second).terms) !=
                                   handsight::count_numbers(own.terms))
        continue;
      unit.at[k] = static_cast<int>(u);
      unit.who.push_back(k);
    }
}

/// From each session on, and in each of those in between alone; sides are in order of time.
void SeveralComparer::list_alternatives() {
  for (std::size_t u = 0; u < units_.size(); ++u) {
    const std::vector<std::size_t>& who = units_[u].who;
    for (std::size_t first = 1; first < who.size(); ++first) {
      std::vector<char> from(of_sides_.size(), 0), alone(of_sides_.size(), 0);
      for (std::size_t i = first; i < who.size(); ++i) from[who[i]] = 1;
      alone[who[first]] = 1;
      alternatives_.push_back({u, std::move(from)});
      if (first + 1 < who.size()) alternatives_.push_back({u, std::move(alone)});
    }
  }
}

Eigen::Index SeveralComparer::count_numbers(std::size_t unit) const {
  return handsight::count_numbers(find_unit(units_[unit].who.front(), unit).terms);
}

const ChangeUnit& SeveralComparer::find_unit(std::size_t side, std::size_t unit) const {
  return of_sides_[side][static_cast<std::size_t>(units_[unit].at[side])];
}

Eigen::VectorXd SeveralComparer::list_sizes(std::size_t unit) const {
  const std::size_t side = units_[unit].who.front();
  std::vector<double> sizes;
  for (const EffectTerm& t : find_unit(side, unit).terms)
    for (const EffectParameter& p : term_effect(t).parameters)
      if (!p.is_choice) sizes.push_back(prior_sigma(p, sides_.sides[side].problem.source->chain));
  return Eigen::Map<Eigen::VectorXd>(sizes.data(), static_cast<Eigen::Index>(sizes.size()));
}

std::vector<EffectTerm> SeveralComparer::list_terms(std::size_t side, std::size_t unit,
                                                    const Eigen::VectorXd& change) const {
  return with_numbers(find_unit(side, unit).terms, change.cwiseProduct(list_sizes(unit)));
}

/// Rows of one side with these terms as its changes, standing at their values.
ChangeRows SeveralComparer::take_rows(std::size_t k, const SeveralState& state,
                                      const std::vector<EffectTerm>& terms) const {
  const SeveralSide& side = sides_.sides[k];
  SharedState own = read_state(side, state);
  const Problem changed = with_changes(side.problem, terms, own.unknowns.effects);
  own.unknowns.effects = effect_values(changed);
  const Eigen::Index base = side.problem.effect_count();
  const ChangeColumns columns{base, &side.curves, column_count(side.curves), changed.effect_count() - base};
  return change_rows(changed, own, columns, side.weight);
}

}  // namespace handsight
