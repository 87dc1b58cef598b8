// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/proof/proof.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/evidence/observation_rows.h"
#include "diagnosis/proof/proof_sites.h"
#include "effects/units.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {
namespace {

/// A model with the effects in it, as far as it goes: its problem, where it stands, and the step from there to the
/// model with the effects (of all columns but those of probes).
struct Standing {
  Problem problem;
  Unknowns unknowns;
  std::vector<std::size_t> terms;  // of the problem: those that are looked at
  Eigen::VectorXd step;            // of the problem's columns
  double noise = 1;
};

struct Number {
  ProofNumber number;
  ProofSite site;
  Eigen::Index column = 0;            // of the problem
  std::optional<Eigen::Index> probe;  // its site's
};

Eigen::Index column_of(const Problem& p, std::size_t term, std::size_t parameter) {
  for (std::size_t c = 0; c < p.columns_of_effects.size(); ++c)
    if (p.columns_of_effects[c].term == term && p.columns_of_effects[c].parameter == parameter)
      return p.effect_column() + static_cast<Eigen::Index>(c);
  return -1;
}

/// Every number that is estimated, with its site; probes of the sites become further terms of the problem.
std::vector<Number> list_numbers(Standing& s, const std::vector<EffectTerm>& terms,
                                 const std::vector<std::vector<double>>& sigmas) {
  std::vector<Number> list;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Effect& effect = term_effect(terms[t]);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const Eigen::Index column = column_of(s.problem, s.terms[t], p);
      if (column < 0) continue;
      const EffectParameter& parameter = effect.parameters[p];
      const double sigma = t < sigmas.size() && p < sigmas[t].size() ? sigmas[t][p] : 0;
      list.push_back({{t, p, parameter.name, unit_at(effect, p, terms[t].place, s.problem.source->chain.robot),
                       terms[t].values[p], sigma, 0},
                      proof_site(s.problem, terms[t], p),
                      column,
                      std::nullopt});
    }
  }
  std::vector<EffectTerm> probes;
  std::vector<std::size_t> entries;
  for (const Number& n : list)
    if (n.site.entry && std::find(entries.begin(), entries.end(), *n.site.entry) == entries.end()) {
      entries.push_back(*n.site.entry);
      const std::shared_ptr<const Effect> probe = make_probe(entries.back());
      probes.push_back(term_of(*probe, -1, probe));
    }
  const Eigen::Index before = s.problem.columns();
  if (!probes.empty()) s.problem = list_candidates(s.problem, probes).problem;
  for (Number& n : list)
    if (n.site.entry) n.probe = before + (std::find(entries.begin(), entries.end(), *n.site.entry) - entries.begin());
  s.step.conservativeResize(s.problem.columns());
  s.step.tail(s.problem.columns() - before).setZero();
  s.unknowns.effects = effect_values(s.problem);
  return list;
}

/// Numbers of one term at one site stand in one plot.
std::vector<std::vector<Number>> by_site(std::vector<Number> list) {
  std::vector<std::vector<Number>> groups;
  for (Number& n : list) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const std::vector<Number>& g) {
      return n.site.entry && g.front().number.term == n.number.term && g.front().site.entry == n.site.entry;
    });
    if (same == groups.end()) {
      groups.push_back({std::move(n)});
    } else {
      same->push_back(std::move(n));
    }
  }
  return groups;
}

/// How far the markers' middle moves against the sensor by one unit of a column: m.
double shift_of_hand(const Problem& p, const ProblemObservation& o, const Unknowns& u, Eigen::Index column) {
  const Eigen::Index at = column - p.mount_column();
  const auto motion = motion_by_columns(p, o, u);
  if (at < 0 || at >= motion.cols() || o.sightings.empty()) return 0;
  Vector3 middle = Vector3::Zero();
  for (const Sighting& s : o.sightings) middle += marker_at(o, u, s.marker);
  const Vector3 x = sensor_from_tcp_at(o, u) * Vector3(middle / static_cast<double>(o.sightings.size()));
  const Vector6 v = motion.col(at);
  return (v.head<3>() + v.tail<3>().cross(x)).norm();
}

/// Slopes of the points by every number's share, weighed.
void set_slopes(ProofPlot& plot) {
  const auto count = static_cast<Eigen::Index>(plot.numbers.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
  for (const ProofPoint& p : plot.points) {
    const double weight = 1 / (p.sigma * p.sigma);
    information += weight * p.share * p.share.transpose();
    gradient += weight * p.y * p.share;
  }
  const Eigen::VectorXd slopes = information.completeOrthogonalDecomposition().solve(gradient);
  for (Eigen::Index n = 0; n < count; ++n) plot.numbers[static_cast<std::size_t>(n)].slope = slopes[n];
}

void add_point(const Standing& s, const ObservationRows& rows, std::size_t place, const std::vector<Number>& group,
               ProofPlot& plot) {
  const auto i = static_cast<Eigen::Index>(place);
  const Number& first = group.front();
  const ProblemObservation& o = s.problem.observations[place];
  const Eigen::VectorXd direction = rows.by_columns.col(first.probe.value_or(first.column));
  const double squares = direction.squaredNorm(), load = first.site.load[i];
  const double size = std::abs(load);
  if (!(squares > 0) || !(size > 1e-9)) {
    ++plot.left_out;
    return;
  }
  ProofPoint point{o.index, 0, first.site.x[i], 0, 0, 0, Eigen::VectorXd(static_cast<Eigen::Index>(group.size()))};
  double hand = 0;
  for (std::size_t n = 0; n < group.size(); ++n) {
    const double share = group[n].site.share[i];
    point.share[static_cast<Eigen::Index>(n)] = share;
    point.curve += share * group[n].number.value;
  }
  const Eigen::VectorXd left = rows.error - rows.by_columns * s.step;
  point.y = point.curve + load * direction.dot(left) / squares;
  point.sigma = s.noise * size / std::sqrt(squares);
  hand = std::abs(point.curve / load) * shift_of_hand(s.problem, o, s.unknowns, first.probe.value_or(first.column));
  plot.hand_m = std::max(plot.hand_m, hand);
  plot.largest = std::max(plot.largest, std::abs(point.curve));
  plot.largest_x = std::max(plot.largest_x, std::abs(point.x));
  plot.strength += std::pow(point.curve / point.sigma, 2);
  plot.points.push_back(std::move(point));
}

std::vector<ProofPlot> plots_of(const Session& session, Standing s, const std::vector<EffectTerm>& terms,
                                const std::vector<std::vector<double>>& sigmas) {
  const std::vector<std::vector<Number>> groups = by_site(list_numbers(s, terms, sigmas));
  std::vector<ProofPlot> plots;
  for (const std::vector<Number>& group : groups) {
    const ProofSite& site = group.front().site;
    const EffectTerm& term = terms[group.front().number.term];
    ProofPlot plot;
    plot.of = place_name(term_effect(term), term.place, session.robot);
    plot.quantity = site.quantity, plot.unit = site.unit;
    plot.against = site.against, plot.against_unit = site.against_unit;
    for (const Number& n : group) plot.numbers.push_back(n.number);
    plots.push_back(std::move(plot));
  }
  for (std::size_t i = 0; i < s.problem.observations.size(); ++i) {
    const ObservationRows rows = observation_rows(s.problem, s.problem.observations[i], s.unknowns);
    for (std::size_t g = 0; g < groups.size(); ++g) add_point(s, rows, i, groups[g], plots[g]);
  }
  for (ProofPlot& plot : plots) {
    std::vector<double> sigmas_of_points;
    for (ProofPoint& p : plot.points) {
      p.id = session.observations[static_cast<std::size_t>(p.index)].id;
      sigmas_of_points.push_back(p.sigma);
    }
    plot.noise = median(std::move(sigmas_of_points));
    set_slopes(plot);
  }
  std::erase_if(plots, [](const ProofPlot& p) { return p.points.empty(); });
  std::stable_sort(plots.begin(), plots.end(),
                   [](const ProofPlot& a, const ProofPlot& b) { return a.strength > b.strength; });
  return plots;
}

/// Where in a problem's terms these stand; nothing where one is missing.
std::optional<std::vector<std::size_t>> places_in(const Problem& p, const std::vector<EffectTerm>& terms) {
  std::vector<std::size_t> places;
  for (const EffectTerm& term : terms) {
    const Effect& effect = term_effect(term);
    const auto found = std::find_if(p.terms.rbegin(), p.terms.rend(), [&](const EffectTerm& t) {
      if (t.id != term.id || t.place != term.place) return false;
      for (std::size_t i = 0; i < effect.parameters.size(); ++i)
        if (effect.parameters[i].is_choice && t.values[i] != term.values[i]) return false;
      return true;
    });
    if (found == p.terms.rend()) return std::nullopt;
    places.push_back(static_cast<std::size_t>(p.terms.rend() - found) - 1);
  }
  return places;
}

/// The candidate's numbers as they stand, and what the model's own take up of them.
Standing linear_standing(const Fit& model, double noise, const std::vector<EffectTerm>& terms) {
  Standing s{list_candidates(with_motions(model.problem), terms).problem, estimate(model), {}, {}, noise};
  const Eigen::Index base = s.problem.columns() - (s.problem.effect_count() - model.problem.effect_count());
  s.unknowns.effects = effect_values(s.problem);
  for (std::size_t t = 0; t < terms.size(); ++t) s.terms.push_back(s.problem.terms.size() - terms.size() + t);
  s.step = Eigen::VectorXd::Zero(s.problem.columns());
  for (Eigen::Index c = base; c < s.problem.columns(); ++c) {
    const EffectColumn& column = s.problem.columns_of_effects[static_cast<std::size_t>(c - s.problem.effect_column())];
    s.step[c] = terms[column.term - s.terms.front()].values[column.parameter];
  }
  const NormalEquations normal = normal_equations(s.problem, s.unknowns);
  const Eigen::Index added = s.problem.columns() - base;
  s.step.head(base) =
      normal.information.topLeftCorner(base, base)
          .completeOrthogonalDecomposition()
          .solve(normal.gradient.head(base) - normal.information.topRightCorner(base, added) * s.step.tail(added));
  return s;
}

}  // namespace

std::vector<ProofPlot> make_proof(const Session& session, const Fit& fit, const std::vector<EffectTerm>& terms) {
  Standing s{with_motions(fit.problem), estimate(fit), {}, {}, noise_model(fit).noise};
  const auto places = places_in(s.problem, terms);
  if (terms.empty() || !places) return {};
  s.terms = *places;
  s.step = Eigen::VectorXd::Zero(s.problem.columns());
  std::vector<EffectTerm> present;
  std::vector<std::vector<double>> sigmas;
  for (const std::size_t place : s.terms) {
    present.push_back(s.problem.terms[place]);
    sigmas.emplace_back();
    for (const FittedEffect& e : fit.effects)
      if (e.term.id == present.back().id && e.term.place == present.back().place &&
          e.term.values == present.back().values)
        sigmas.back() = e.sigmas;
  }
  return plots_of(session, std::move(s), present, sigmas);
}

std::vector<ProofPlot> make_proof(const Diagnosis& d, const DiagnosisCandidate& c) {
  if (c.terms.empty()) return {};
  const double noise = noise_model(d.model.fit).noise;
  const Session& session = d.model.session;
  if (c.full_fit && c.full_fit->start) {
    const FitOptions& o = *c.full_fit;
    Standing s{
        make_problem(session, d.model.fit.problem.source->chain, o.effects, o.estimated), *o.start, {}, {}, noise};
    const BodySides& sides = d.model.fit.sides;
    if (!sides.markers.empty()) s.problem.tcp_from_slip = body_frame(sides, o.start->markers_in_tcp).tcp_from_body;
    place_observations(s.problem);
    if (const auto places = places_in(s.problem, c.terms)) {
      s.terms = *places;
      s.step = Eigen::VectorXd::Zero(s.problem.columns());
      return plots_of(session, std::move(s), c.terms, c.sigmas);
    }
  }
  return plots_of(session, linear_standing(d.model.fit, noise, c.terms), c.terms, c.sigmas);
}

}  // namespace handsight
