// SPDX-License-Identifier: Apache-2.0
// What others would make of a messy robot: fits that are told more or less of what is hidden, everything at once, and a
// learned correction.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "diagnosis/ranking/curves.h"
#include "effects/own_effect.h"
#include "effects/term_numbers.h"
#include "estimation/report/fit_report.h"
#include "fixtures/gaussian_process.h"
#include "trials/messy_robots.h"

namespace handsight::trials {

/// TCP->Body alone, and a Gaussian process over the joint angles on where the observations saw the body instead, along
/// the axes of the robot's root.
inline double error_of_learning(const Messy& m, const Fit& alone) {
  const FitReport r = report(m.session, alone);
  const Chain model = make_chain(m.session);
  const Vector3 body = alone.tcp_from_body.translation;
  std::vector<std::pair<Eigen::VectorXd, Vector3>> seen;
  for (const ObservationReport& o : r.per_observation) {
    if (!o.deviation) continue;
    const Eigen::VectorXd& pose = m.session.observations[static_cast<std::size_t>(o.index)].position;
    const Vector3 off = o.deviation->tcp_from_tcp_est * body - body;
    seen.emplace_back(pose, hand_at(model, pose, {}).rotation * off);
  }
  Eigen::MatrixXd angles(seen.size(), seen.front().first.size()), off(seen.size(), 3);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    angles.row(static_cast<Eigen::Index>(i)) = seen[i].first;
    off.row(static_cast<Eigen::Index>(i)) = 1e3 * seen[i].second;
  }
  const GaussianProcess process(angles, off);
  return error_on_fresh(m, alone, [&](const Eigen::VectorXd& pose) {
    return Vector3(body + 1e-3 * hand_at(model, pose, {}).rotation.transpose() * process.at(pose).transpose());
  });
}

/// The terms of an effect at every place of the chain; none where it has no place there.
inline std::vector<EffectTerm> everywhere(const Effect& e, const Chain& chain) {
  try {
    return effect_terms(e.id, chain);
  } catch (const InputError&) {
    return {};
  }
}

/// Everything of the catalogue at every place in one fit, held by its prior sigmas alone; but what begins at some
/// observation.
inline Fit all_at_once(const Messy& m) {
  FitOptions o;
  const Chain chain = make_chain(m.session);
  for (const Effect& e : catalogue()) {
    if (std::any_of(e.parameters.begin(), e.parameters.end(), [](const auto& p) { return p.is_choice; })) continue;
    for (EffectTerm& t : everywhere(e, chain)) o.estimated.push_back(std::move(t));
  }
  return fit(m.session, o);
}

/// The effects that are there but `without`, to be estimated.
inline FitOptions told_effects(const Messy& m, const std::string& without) {
  FitOptions o;
  for (EffectTerm t : m.effects) {
    if (t.id == without) continue;
    clear_numbers(t);
    o.estimated.push_back(t);
  }
  return o;
}

/// Told which effects there are, but `without`; `everything`: the shift's form too.
inline Fit reported(const Messy& m, bool everything, const std::string& without = {}) {
  FitOptions o = told_effects(m, without);
  if (everything && m.shift) {
    o.estimated.push_back(*m.shift);
    std::fill(o.estimated.back().values.begin(), o.estimated.back().values.end(), 0.0);
  }
  return fit(m.session, o);
}

/// A wave of the hand along each axis with the variable that a term follows, of a frequency and any phase.
inline EffectTerm wave_of(const EffectTerm& shift, double frequency, const Robot& robot) {
  const std::string& formula = shift.own->definition->moves.front().formula;
  const std::size_t begin = formula.find("q_");
  const std::string variable = formula.substr(begin, formula.find('+', begin) - begin);
  EffectDefinition d;
  d.id = "wave";
  d.scope = "session";
  for (const std::string axis : {"x", "y", "z"}) {
    d.parameters.push_back({axis + "_sine", "m", 1e-3});
    d.parameters.push_back({axis + "_cosine", "m", 1e-3});
    d.moves.push_back(
        {"hand_" + axis, fmt::format("{0}_sine*sin({1}*{2}) + {0}_cosine*cos({1}*{2})", axis, frequency, variable), 0});
  }
  const auto effect = own_effect(d, robot);
  return term_of(*effect, -1, effect);
}

/// Told which effects there are and what the shift follows, as a wave: not its frequency, phase and sizes.
inline Fit told_the_variable(const Messy& m) {
  constexpr double widest = 0.5, exact = 2e-3, golden = 0.6180339887;  // of the frequency, which is 3.3
  const auto with = [&](double frequency) {
    FitOptions o = told_effects(m, {});
    o.estimated.push_back(wave_of(*m.shift, frequency, m.session.robot));
    return fit(m.session, o);
  };
  const auto cost = [](const Fit& f) { return f.solution.normal.data_cost(); };
  double low = 3.3 - widest, high = 3.3 + widest;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  Fit at_left = with(left), at_right = with(right);
  while (high - low > exact) {
    if (cost(at_left) < cost(at_right)) {
      high = std::exchange(right, left);
      at_right = std::move(at_left);
      at_left = with(left = high - golden * (high - low));
    } else {
      low = std::exchange(left, right);
      at_left = std::move(at_right);
      at_right = with(right = low + golden * (high - low));
    }
  }
  return cost(at_left) < cost(at_right) ? at_left : at_right;
}

inline std::set<std::string> list_ids(const std::vector<EffectTerm>& terms) {
  std::set<std::string> ids;
  for (const EffectTerm& t : terms)
    if (!is_curve(t)) ids.insert(t.id);
  return ids;
}

/// The hidden names that show where all else is given: without one of them a fit that knows the rest leaves 50 of
/// chi-squared more, in units of what it leaves with it. Nobody can find what does not show even then.
inline std::set<std::string> seen_beside_the_rest(const Messy& m, const Fit& everything) {
  const NormalEquations& with = everything.solution.normal;
  const double square = with.data_cost() / with.rows;
  std::set<std::string> seen;
  for (const std::string& id : list_ids(m.effects))
    if (reported(m, true, id).solution.normal.cost - with.cost > 50 * square) seen.insert(id);
  return seen;
}

}  // namespace handsight::trials
