// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/inclusion_probability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "chain/body_frame.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/indistinguishable.h"
#include "diagnosis/selection/likeliest_choice.h"
#include "diagnosis/selection/model_posterior.h"
#include "diagnosis/selection/second_moments.h"
#include "diagnosis/selection/small_causes.h"
#include "diagnosis/verdict/stand_in.h"
#include "effects/term_numbers.h"
#include "estimation/solvers/covariance_factor.h"

namespace handsight {
namespace {

constexpr double least_of_others = 0.02;  // probability
constexpr double likeliest_odd = 0.05;    // probability of what no robot is built like: it stands in for another cause
constexpr double surest_by_size = 0.95;   // probability of what only usual sizes tell from another name of the model

/// How xi, the model's numbers and those of others move with the open numbers, in prior sigmas of these.
class Movements {
 public:
  Movements(const Diagnosis& model, const ModelSpace& all, const OpenUnits& units, const OpenScore& score)
      : fit_(model.model.fit), all_(all) {
    const std::vector<Eigen::Index> open = all.list_numbers(units.open), fixed = all.list_numbers(units.fixed);
    const Eigen::MatrixXd base = all.base_by_numbers();
    base_ = base(Eigen::all, open);
    if (!fixed.empty()) base_ += base(Eigen::all, fixed) * score.fixed_by_open;
    for (std::size_t i = 0; i < open.size(); ++i) own_[open[i]] = static_cast<Eigen::Index>(i);
    for (std::size_t i = 0; i < fixed.size(); ++i) fixed_[fixed[i]] = static_cast<Eigen::Index>(i);
    fixed_by_open_ = score.fixed_by_open;
    const std::optional<Rigid>& start = model.model_options.start_tcp_from_body;
    frame_ = body_frame(fit_.sides, estimate(fit_).markers_in_tcp, start ? start->rotation : Matrix3::Identity());
  }

  /// With these units listed as others.
  Eigen::MatrixXd by_open(const Chosen& others) const {
    const Problem& p = fit_.problem;
    const std::vector<Eigen::Index> first = first_numbers(p.terms, 6);
    Eigen::Index rows = first.back();
    for (const std::size_t u : others) rows += static_cast<Eigen::Index>(all_.units()[u].term.values.size());
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(rows, base_.cols());
    by.topRows<6>() = frame_.motion_by_markers * base_.topRows(frame_.motion_by_markers.cols());
    for (Eigen::Index c = 0; c < p.effect_count(); ++c) {
      const EffectColumn& column = p.columns_of_effects[static_cast<std::size_t>(c)];
      auto row = by.row(first[column.term] + static_cast<Eigen::Index>(column.parameter));
      if (c < all_.base())
        row = base_.row(p.effect_column() + c);
      else
        set_number(c - all_.base(), row);
    }
    Eigen::Index row = first.back();
    for (const std::size_t u : others) {
      const ModelSpaceUnit& unit = all_.units()[u];
      const Effect& effect = term_effect(unit.term);
      Eigen::Index number = unit.first;
      for (std::size_t p_of = 0; p_of < effect.parameters.size(); ++p_of, ++row)
        if (!effect.parameters[p_of].is_choice) set_number(number++, by.row(row));
    }
    return by;
  }

  /// Of the columns of the fit's problem, then of the numbers of these units.
  Eigen::MatrixXd columns_by_open(const Chosen& others) const {
    const Problem& p = fit_.problem;
    Eigen::Index rows = p.columns();
    for (const std::size_t u : others) rows += all_.units()[u].count;
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(rows, base_.cols());
    by.topRows(p.effect_column() + all_.base()) = base_.topRows(p.effect_column() + all_.base());
    for (Eigen::Index c = all_.base(); c < p.effect_count(); ++c)
      set_number(c - all_.base(), by.row(p.effect_column() + c));
    Eigen::Index row = p.columns();
    for (const std::size_t u : others)
      for (Eigen::Index i = 0; i < all_.units()[u].count; ++i) set_number(all_.units()[u].first + i, by.row(row++));
    return by;
  }

 private:
  template <class Row>
  void set_number(Eigen::Index number, Row&& row) const {
    if (const auto own = own_.find(number); own != own_.end()) row[own->second] = all_.plausible(number);
    if (const auto fixed = fixed_.find(number); fixed != fixed_.end())
      row = all_.plausible(number) * fixed_by_open_.row(fixed->second);
  }

  const Fit& fit_;
  const ModelSpace& all_;
  BodyFrame frame_;
  Eigen::MatrixXd base_, fixed_by_open_;
  std::map<Eigen::Index, Eigen::Index> own_, fixed_;  // places among the open and the fixed numbers
};

/// Two points of the hand, TCP frame.
const std::array<Vector3, 2> points_of_hand{Vector3(0, 0, 0), Vector3(0.1, 0.1, 0.1)};

/// Where some terms put the hand's points (m): in the root's frame and in the sensor's link.
std::array<Vector3, 4> places_of_hand(const ObservationState& c, const std::vector<EffectTerm>& terms) {
  const Sites sites = moved_sites(c, terms);
  const ObservedEnds at = observed_ends(c, sites);
  const Rigid body_motion = small_motion<double>(sites.body), mount_from_root = inverse(at.ends.root_from_mount);
  std::array<Vector3, 4> places;
  for (std::size_t i = 0; i < 2; ++i) {
    places[i] = at.ends.root_from_tcp * (body_motion * points_of_hand[i]);
    places[i + 2] = mount_from_root * places[i];
  }
  return places;
}

/// Does a term, which is at 0, move the hand against the sensor beside the terms of a fit, over some observations? What
/// moves cameras alone says nothing of where the hand is, and what moves hand and sensor alike nobody can measure.
bool moves_the_hand(const EffectTerm& zero, const Fit& fit) {
  constexpr std::size_t looked_at = 8;
  constexpr double alike = 0.5;  // of what it moves in the root's frame
  std::vector<EffectTerm> before = list_terms(fit), after = before;
  before.push_back(zero);
  after.push_back(zero);
  const Effect& effect = term_effect(zero);
  for (std::size_t p = 0; p < effect.parameters.size(); ++p)
    if (!effect.parameters[p].is_choice) after.back().values[p] = effect.parameters[p].sigma;
  const std::size_t count = fit.problem.observations.size(), stride = std::max<std::size_t>(1, count / looked_at);
  double in_root = 0, against_sensor = 0;  // m^2
  for (std::size_t i = 0; i < count; i += stride) {
    const auto index = static_cast<std::size_t>(fit.problem.observations[i].index);
    const ObservationState& c = fit.problem.source->states[index];
    const std::array<Vector3, 4> from = places_of_hand(c, before), to = places_of_hand(c, after);
    for (std::size_t k = 0; k < 2; ++k) {
      in_root += (to[k] - from[k]).squaredNorm();
      against_sensor += (to[k + 2] - from[k + 2]).squaredNorm();
    }
  }
  return in_root > 0 && against_sensor >= alike * alike * in_root;
}

/// The probability of each unit.
std::vector<double> of_units(const ModelSpace& all, const OpenUnits& units, const Weights& weights) {
  std::vector<double> probability(all.units().size(), 0.0);
  for (const std::size_t u : units.fixed) probability[u] = 1;
  for (const auto& [chosen, weight] : weights)
    for (const std::size_t u : chosen) probability[u] += weight;
  return probability;
}

double of_name(std::size_t name, const ModelSpace& all, const OpenUnits& units, const Weights& weights) {
  const auto is_of_name = [&](std::size_t u) { return all.units()[u].name == name; };
  if (std::any_of(units.fixed.begin(), units.fixed.end(), is_of_name)) return 1;
  double probability = 0;
  for (const auto& [chosen, weight] : weights)
    if (std::any_of(chosen.begin(), chosen.end(), is_of_name)) probability += weight;
  return std::min(probability, 1.0);
}

/// Where a name is likelier than not to be if it is there, else where it is likeliest.
Chosen likely_units(std::size_t name, const ModelSpace& all, const std::vector<double>& probability, double of_name) {
  Chosen likely;
  std::size_t likeliest = all.units().size();
  for (std::size_t u = 0; u < all.units().size(); ++u) {
    if (all.units()[u].name != name) continue;
    if (likeliest == all.units().size() || probability[u] > probability[likeliest]) likeliest = u;
    if (probability[u] > 0.5 * of_name) likely.push_back(u);
  }
  if (likely.empty() && likeliest < all.units().size()) likely.push_back(likeliest);
  return likely;
}

/// What is likely of a name: where the model lacks it, all of its likely units `where`; where the model has it, those
/// units that are likely by themselves.
Chosen units_to_come(const ModelSpace& all, std::size_t n, const InclusionProbability& name, const Chosen& where,
                     const std::vector<double>& of_unit) {
  if (!name.is_in_model) return name.probability >= InclusionProbabilities::least_likely ? where : Chosen{};
  Chosen likely;
  for (std::size_t u = 0; u < all.units().size(); ++u)
    if (all.units()[u].name == n && !all.units()[u].is_present && of_unit[u] >= InclusionProbabilities::least_likely)
      likely.push_back(u);
  return likely;
}

/// The probability of what is to come of a name: its own where the model lacks it, else that of its likeliest place.
double of_likeliest(const Chosen& likely, const InclusionProbability& name, const std::vector<double>& of_unit) {
  if (!name.is_in_model) return name.probability;
  double most = 0;
  for (const std::size_t u : likely) most = std::max(most, of_unit[u]);
  return most;
}

std::vector<std::string> places(const Chosen& units, const ModelSpace& all, const Session& session) {
  std::vector<EffectTerm> terms;
  for (const std::size_t u : units) terms.push_back(all.units()[u].term);
  return list_places(terms, session);
}

/// The model's terms with these of a name beside them.
std::vector<EffectTerm> estimated_with(const ModelSpace& all, const Chosen& units) {
  Chosen chosen = all.present();
  for (const std::size_t u : units) chosen = with_unit(chosen, u);
  const std::vector<EffectTerm> terms = all.list_terms(chosen);
  std::vector<EffectTerm> estimated, own;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    (all.units()[chosen[i]].is_present ? estimated : own).push_back(terms[i]);
  estimated.insert(estimated.end(), own.begin(), own.end());
  return estimated;
}

void add_new(const std::vector<std::string>& ids, std::vector<std::string>& list) {
  for (const std::string& id : ids)
    if (std::find(list.begin(), list.end(), id) == list.end()) list.push_back(id);
}

void set_names(const Fit& fit, const ModelSpace& all, const OpenUnits& units, const Weights& weights,
               const std::vector<SmallCauses>& small_instead, const Session& session,
               InclusionProbabilities& inclusion_probabilities) {
  const std::vector<double> probability = of_units(all, units, weights);
  const std::set<std::string> in_model = all.list_names(all.present());
  std::set<std::string> odd;
  for (const StandIn& s : stand_ins(fit))
    if (s.is_everywhere) odd.insert(s.id);
  for (std::size_t n = 0; n < all.names().size(); ++n) {
    InclusionProbability name{all.names()[n].id, {}, of_name(n, all, units, weights), false};
    name.is_in_model = in_model.contains(name.id);
    name.probability *= 1 - small_instead[n].share;
    if (odd.contains(name.id)) name.probability = std::min(name.probability, likeliest_odd);
    if (!name.is_in_model && name.probability < InclusionProbabilities::least_reported) continue;
    const Chosen where = likely_units(n, all, probability, name.probability);
    name.where = places(where, all, session);
    const std::vector<std::string> by_size = name.is_in_model ? told_by_size_from(all, n) : std::vector<std::string>{};
    if (!by_size.empty()) name.probability = std::min(name.probability, surest_by_size);
    if (name.is_in_model) name.indistinguishable_from = indistinguishable_from(all, n);
    add_new(small_instead[n].names, name.indistinguishable_from);
    add_new(by_size, name.indistinguishable_from);
    if (const Chosen likely = units_to_come(all, n, name, where, probability); !likely.empty())
      inclusion_probabilities.likely.push_back(
          {{name.id, places(likely, all, session), of_likeliest(likely, name, probability), name.is_in_model},
           estimated_with(all, likely)});
    inclusion_probabilities.names.push_back(std::move(name));
  }
  std::stable_sort(inclusion_probabilities.names.begin(), inclusion_probabilities.names.end(),
                   [](const InclusionProbability& a, const InclusionProbability& b) {
                     return a.is_in_model != b.is_in_model ? a.is_in_model : a.probability > b.probability;
                   });
  std::stable_sort(inclusion_probabilities.likely.begin(), inclusion_probabilities.likely.end(),
                   [](const LikelyName& a, const LikelyName& b) { return a.name.probability > b.name.probability; });
}

}  // namespace

InclusionProbabilities inclusion_probabilities(const Diagnosis& model, std::size_t first,
                                               const std::function<bool()>& goes_on) {
  InclusionProbabilities c;
  const Fit& fit = model.model.fit;
  // A shape that is held is one more measurement of the linear model; markers that are held without one are not.
  const bool are_held = fit.fixed_markers && !fit.problem.has_shape_prior();
  if (are_held || fit.sides.markers.empty()) return c;
  const ModelSpace all(fit, term_of_fit(model, first), InclusionProbabilities::cost_of_a_name);
  const OpenUnits units = open_units(all, goes_on);
  const OpenScore score = open_score(all, units);
  const Weights weights = model_posterior(all, units, score, goes_on);
  if (!goes_on()) return c;
  const std::vector<SmallCauses> small_instead = find_small_causes(all, all.present());
  set_names(model.model.fit, all, units, weights, small_instead, model.model.session, c);
  const LikeliestChoice likeliest = likeliest_choice(all, units, weights, small_instead);
  c.likeliest = likeliest.chosen;
  c.ln_of_small_causes = likeliest.ln_of_small_causes;
  if (units.open.empty()) return c;

  const std::vector<double> probability = of_units(all, units, weights);
  Chosen others, of_model;
  for (const std::size_t u : units.open) {
    const ModelSpaceUnit& unit = all.units()[u];
    if (unit.is_present) of_model.push_back(u);
    if (unit.is_present || probability[u] < least_of_others || !moves_the_hand(unit.term, fit)) continue;
    others.push_back(u);
    c.model_uncertainty.others.push_back(unit.term);
  }
  const Movements movements(model, all, units, score);
  const Eigen::MatrixXd factor = make_factor(second_moments(all, units, score, weights, of_model));
  c.model_uncertainty.covariance = covariance_from(movements.by_open(others) * factor);
  if (!model.model.session.parts.empty())
    c.model_uncertainty.of_columns = covariance_from(movements.columns_by_open(others) * factor);
  return c;
}

}  // namespace handsight
