// SPDX-License-Identifier: Apache-2.0
#include "compare/several_changes.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "compare/change_evidence.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"
#include "estimation/fit/noise.h"

namespace handsight {
namespace {

constexpr double least_visible = 1e-2;  // chi-squared of a plausible size below which a change cannot be seen at all
constexpr std::size_t most_groups = 5, most_beside = 3;  // that are fitted in full: the best of each, the best of all
constexpr int most_iterations = 8, most_iterations_wide = 3;
constexpr double least_gain = 1e-4, least_gain_wide = 1e-1;  // of chi-squared, of one more iteration
constexpr double change_scale = 3;  // plausible sizes that a change is held at while it is fitted
constexpr double held = 1 / (change_scale * change_scale);
constexpr double free_scale = 1e6;
constexpr int learning_rounds = 3, learning_steps = 4;

Eigen::Index numbers_of(const ChangeUnit& unit) {
  Eigen::Index count = 0;
  for (const EffectTerm& t : unit.terms)
    for (const EffectParameter& p : effect_of(t).parameters) count += !p.is_choice;
  return count;
}

bool is_one_marker(const std::vector<ChangeUnit>& units) {
  return std::count_if(units.begin(), units.end(), [](const ChangeUnit& u) { return u.group == "marker_slip"; }) == 1;
}

ScatteredNormal nothing(Eigen::Index columns) {
  return {Eigen::MatrixXd::Zero(columns, columns), Eigen::VectorXd::Zero(columns), 0};
}

/// A side's columns by those of all.
using ColumnMap = Eigen::SparseMatrix<double>;

ColumnMap map_of(const std::vector<Eigen::Triplet<double>>& places, Eigen::Index own, Eigen::Index all) {
  ColumnMap map(own, all);
  map.setFromTriplets(places.begin(), places.end());
  return map;
}

void add(const ScatteredNormal& own, const ColumnMap& map, ScatteredNormal& all) {
  const Eigen::MatrixXd half = own.information * map;
  all.information += map.transpose() * half;
  all.gradient += map.transpose() * own.gradient;
  all.squares += own.squares;
}

/// So that what nothing tells has an answer.
void stiffen(ScatteredNormal& n) {
  for (Eigen::Index i = 0; i < n.gradient.size(); ++i) n.information(i, i) += 1e-12 * n.information(i, i) + 1e-12;
}

/// A change at `value` that is held at `scale` plausible sizes.
void add_prior(ScatteredNormal& n, Eigen::Index column, double value, double scale) {
  n.information(column, column) += 1 / (scale * scale);
  n.gradient[column] -= value / (scale * scale);
  n.squares += value * value / (scale * scale);
}

struct EvidenceAt {
  double evidence = 0, gained = 0;
};

/// Of a change that was fitted with this answer and covariance, by the squares with and without it. It was held at
/// change_scale; the prior of each scale is counted in the evidence.
EvidenceAt evidence_at(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& change, double squares_without,
                       double squares_with) {
  const double gained = squares_without - squares_with;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(change.size(), change.size());
  return {change_evidence_at(covariance.ldlt().solve(one) - held * one, change, gained), gained};
}

int sides_in(const Alternative& a) { return static_cast<int>(std::count(a.in.begin(), a.in.end(), 1)); }

}  // namespace

struct SeveralComparer::Fitted {
  SeveralState state;
  std::vector<ActiveChange> active;
  Eigen::MatrixXd information;
  double squares = 0;  // what the changes are held at left out
};

SeveralComparer::SeveralComparer(SeveralSides sides) : sides_(std::move(sides)), state_(sides_.start) {
  for (const SeveralSide& s : sides_.sides) of_sides_.push_back(change_units(s.problem));
  list_units();
  list_alternatives();
}

/// What two sides and more have in common, told apart by effect, place and whose it is.
void SeveralComparer::list_units() {
  std::map<std::tuple<std::string, int, Owner, int>, std::size_t> known;
  for (std::size_t k = 0; k < of_sides_.size(); ++k)
    for (std::size_t u = 0; u < of_sides_[k].size(); ++u) {
      const ChangeUnit& own = of_sides_[k][u];
      if (own.group == "marker_slip" && is_one_marker(of_sides_[k])) continue;  // that is a slip of the body
      const EffectTerm& term = own.terms.front();
      const Owner owner = owner_of(effect_of(term));
      const auto [at, is_new] =
          known.emplace(std::tuple{term.id, term.joint, owner, sides_.sides[k].number(owner)}, units_.size());
      if (is_new) units_.push_back({own.group, own.where, std::vector<int>(of_sides_.size(), -1), {}});
      SeveralUnit& unit = units_[at->second];
      if (!unit.who.empty() && numbers_of(unit_of(unit.who.front(), at->second)) != numbers_of(own)) continue;
      unit.at[k] = static_cast<int>(u);
      unit.who.push_back(k);
    }
}

/// From each session on, and in each of those in between alone; sides are in order of time.
void SeveralComparer::list_alternatives() {
  for (std::size_t u = 0; u < units_.size(); ++u) {
    const std::vector<std::size_t>& who = units_[u].who;
    for (std::size_t first = 1; first < who.size(); ++first) {
      Alternative from{u, std::vector<char>(of_sides_.size(), 0)}, alone = from;
      for (std::size_t i = first; i < who.size(); ++i) from.in[who[i]] = 1;
      alone.in[who[first]] = 1;
      alternatives_.push_back(std::move(from));
      if (first + 1 < who.size()) alternatives_.push_back(std::move(alone));
    }
  }
}

Eigen::Index SeveralComparer::count_of(std::size_t unit) const {
  return numbers_of(unit_of(units_[unit].who.front(), unit));
}

const ChangeUnit& SeveralComparer::unit_of(std::size_t side, std::size_t unit) const {
  return of_sides_[side][static_cast<std::size_t>(units_[unit].at[side])];
}

Eigen::VectorXd SeveralComparer::sizes_of(std::size_t unit) const {
  const std::size_t side = units_[unit].who.front();
  std::vector<double> sizes;
  for (const EffectTerm& t : unit_of(side, unit).terms)
    for (const EffectParameter& p : effect_of(t).parameters)
      if (!p.is_choice) sizes.push_back(plausible_size(p, sides_.sides[side].problem.source->chain));
  return Eigen::Map<Eigen::VectorXd>(sizes.data(), static_cast<Eigen::Index>(sizes.size()));
}

std::vector<EffectTerm> SeveralComparer::terms_of(std::size_t side, std::size_t unit,
                                                  const Eigen::VectorXd& change) const {
  std::vector<EffectTerm> terms = unit_of(side, unit).terms;
  const Eigen::VectorXd values = change.cwiseProduct(sizes_of(unit));
  Eigen::Index next = 0;
  for (EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!effect_of(t).parameters[p].is_choice) t.values[p] = values[next++];
  return terms;
}

/// Rows of one side with these terms as its changes, standing at their values.
ChangeRows SeveralComparer::rows_of(std::size_t k, const SeveralState& state,
                                    const std::vector<EffectTerm>& terms) const {
  const SeveralSide& side = sides_.sides[k];
  SharedState own = state_of(side, state);
  const Eigen::Index base = side.problem.effect_count();
  Candidates c = candidates_of(side.problem, terms);
  Eigen::VectorXd values(c.problem.effect_count());
  values.head(base) = own.unknowns.effects;
  Eigen::Index next = base;
  for (const EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!effect_of(t).parameters[p].is_choice) values[next++] = t.values[p];
  if (values.size() > 0) set_effects(c.problem, values);
  own.unknowns.effects = values;
  const ChangeColumns columns{base, &side.curves, column_count(side.curves), c.problem.effect_count() - base};
  return change_rows(c.problem, own, columns, side.weight);
}

namespace {

/// Where a unit's numbers of one side go: as large there as in the unit's own sizes.
void place_unit(std::vector<Eigen::Triplet<double>>& places, const ChangeUnit& unit, const Chain& chain,
                const Eigen::VectorXd& sizes, Eigen::Index own, Eigen::Index all) {
  Eigen::Index i = 0;
  for (const EffectTerm& t : unit.terms)
    for (const EffectParameter& p : effect_of(t).parameters) {
      if (p.is_choice) continue;
      places.emplace_back(own + i, all + i, sizes[i] / plausible_size(p, chain));
      ++i;
    }
}

std::vector<Eigen::Triplet<double>> shared_places(const SeveralSides& sides, const SeveralSide& side) {
  std::vector<Eigen::Triplet<double>> places;
  for (const ColumnPlace& c : columns_of(sides, side))
    places.emplace_back(static_cast<Eigen::Index>(places.size()), c.column, c.times);
  return places;
}

}  // namespace

/// Normal equations of all sides, the active changes' columns behind the shared ones; with priors.
ScatteredNormal SeveralComparer::normal_of(const SeveralState& state, const std::vector<ActiveChange>& active) const {
  Eigen::Index total = sides_.columns();
  for (const ActiveChange& a : active) total += a.change.size();
  ScatteredNormal n = nothing(total);
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    keep_going(sides_.progress);
    std::vector<Eigen::Triplet<double>> places = shared_places(sides_, sides_.sides[k]);
    auto own = static_cast<Eigen::Index>(places.size());
    Eigen::Index all = sides_.columns();
    std::vector<EffectTerm> terms;
    for (const ActiveChange& a : active) {
      const Alternative& alternative = alternatives_[a.alternative];
      if (alternative.in[k]) {
        const ChangeUnit& unit = unit_of(k, alternative.unit);
        place_unit(places, unit, sides_.sides[k].problem.source->chain, sizes_of(alternative.unit), own, all);
        own += a.change.size();
        for (EffectTerm& t : terms_of(k, alternative.unit, a.change)) terms.push_back(std::move(t));
      }
      all += a.change.size();
    }
    const Matrix6& scatter = sides_.scatter[static_cast<std::size_t>(sides_.sides[k].rig)];
    add(scattered(rows_of(k, state, terms), scatter), map_of(places, own, total), n);
  }
  add_priors(sides_, state, n);
  Eigen::Index column = sides_.columns();
  for (const ActiveChange& a : active)
    for (Eigen::Index i = 0; i < a.change.size(); ++i) add_prior(n, column++, a.change[i], change_scale);
  stiffen(n);
  return n;
}

/// Gauss-Newton over the shared unknowns and the changes' numbers.
SeveralComparer::Fitted SeveralComparer::fitted(std::vector<ActiveChange> active) const {
  Fitted r{state_, std::move(active), {}, 0};
  for (int i = 0; i < (sides_.is_wide ? most_iterations_wide : most_iterations); ++i) {
    const ScatteredNormal n = normal_of(r.state, r.active);
    const Eigen::VectorXd step = n.information.ldlt().solve(n.gradient);
    r.information = n.information;
    r.squares = n.squares - n.gradient.dot(step);
    r.state = moved_by(sides_, r.state, step);
    Eigen::Index column = sides_.columns();
    for (ActiveChange& a : r.active) {
      a.change += step.segment(column, a.change.size());
      column += a.change.size();
    }
    if (n.gradient.dot(step) < (sides_.is_wide ? least_gain_wide : least_gain)) break;
  }
  for (const ActiveChange& a : r.active) r.squares -= held * a.change.squaredNorm();
  return r;
}

SeveralComparer::Together SeveralComparer::fitted_together(const std::vector<ActiveChange>& changes) const {
  const Fitted r = fitted(changes);
  const Eigen::Index count = r.information.rows() - sides_.columns();
  Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(r.information.rows(), count);
  ends.bottomRows(count).setIdentity();
  const Eigen::VectorXd variances = r.information.ldlt().solve(ends).bottomRows(count).diagonal();
  Together all{r.active, {}, r.squares};
  Eigen::Index at = 0;
  for (const ActiveChange& a : r.active) {
    all.sigmas.emplace_back(variances.segment(at, a.change.size()).cwiseMax(0).cwiseSqrt());
    at += a.change.size();
  }
  return all;
}

std::vector<double> SeveralComparer::evidence_of_each(const std::vector<ActiveChange>& changes) const {
  const Fitted all = fitted(changes);
  const Eigen::MatrixXd covariance =
      all.information.ldlt().solve(Eigen::MatrixXd::Identity(all.information.rows(), all.information.rows()));
  std::vector<double> factors;
  Eigen::Index at = sides_.columns();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    std::vector<ActiveChange> others = changes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Eigen::VectorXd& change = all.active[i].change;
    const Eigen::Index count = change.size();
    factors.push_back(
        evidence_at(covariance.block(at, at, count, count), change, fitted(others).squares, all.squares).evidence);
    at += count;
  }
  return factors;
}

/// Rows of every side with all of its units, where those that were taken stand at their numbers.
void SeveralComparer::linearise(const std::vector<ActiveChange>& taken) {
  linear_.clear();
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    keep_going(sides_.progress);
    std::vector<EffectTerm> terms;
    for (std::size_t own = 0; own < of_sides_[k].size(); ++own) {
      const std::size_t first = terms.size();
      terms.insert(terms.end(), of_sides_[k][own].terms.begin(), of_sides_[k][own].terms.end());
      for (const ActiveChange& a : taken) {
        const Alternative& alternative = alternatives_[a.alternative];
        if (!alternative.in[k] || units_[alternative.unit].at[k] != static_cast<int>(own)) continue;
        const std::vector<EffectTerm> here = terms_of(k, alternative.unit, a.change);
        for (std::size_t t = 0; t < here.size(); ++t)
          for (std::size_t p = 0; p < here[t].values.size(); ++p)
            if (!effect_of(here[t]).parameters[p].is_choice) terms[first + t].values[p] += here[t].values[p];
      }
    }
    linear_.push_back(rows_of(k, state_, terms));
  }
}

struct SeveralComparer::Linear {
  std::vector<ColumnMap> maps;  // by side
  ScatteredNormal normal;       // without priors
};

/// The linearised model with these changes' columns behind the shared ones.
SeveralComparer::Linear SeveralComparer::linear_of(const std::vector<ActiveChange>& columns, bool with_scatter) const {
  Eigen::Index total = sides_.columns();
  for (const ActiveChange& a : columns) total += a.change.size();
  Linear linear{{}, nothing(total)};
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    const SeveralSide& side = sides_.sides[k];
    std::vector<Eigen::Triplet<double>> places = shared_places(sides_, side);
    std::vector<Eigen::Index> first{static_cast<Eigen::Index>(places.size())};  // column of each of its units
    for (const ChangeUnit& unit : of_sides_[k]) first.push_back(first.back() + numbers_of(unit));
    Eigen::Index all = sides_.columns();
    for (const ActiveChange& a : columns) {
      const Alternative& alternative = alternatives_[a.alternative];
      if (alternative.in[k])
        place_unit(places, unit_of(k, alternative.unit), side.problem.source->chain, sizes_of(alternative.unit),
                   first[static_cast<std::size_t>(units_[alternative.unit].at[k])], all);
      all += a.change.size();
    }
    linear.maps.push_back(map_of(places, linear_[k].gradient.size(), total));
    const Matrix6 scatter = with_scatter ? sides_.scatter[static_cast<std::size_t>(side.rig)] : Matrix6::Zero();
    add(scattered(linear_[k], scatter), linear.maps.back(), linear.normal);
  }
  return linear;
}

/// Adds priors: of what is shared, of the first changes at their numbers, of those after them at `scale_of_free`.
ScatteredNormal SeveralComparer::with_priors(ScatteredNormal n, const std::vector<ActiveChange>& columns,
                                             std::size_t taken, double scale_of_free) const {
  add_priors(sides_, state_, n);
  Eigen::Index column = sides_.columns();
  for (std::size_t a = 0; a < columns.size(); ++a)
    for (Eigen::Index i = 0; i < columns[a].change.size(); ++i)
      add_prior(n, column++, columns[a].change[i], a < taken ? change_scale : scale_of_free);
  stiffen(n);
  return n;
}

/// Each session against the first of those that have a unit in common: all changes that there can be.
std::vector<ActiveChange> SeveralComparer::all_changes() const {
  std::vector<ActiveChange> all;
  for (std::size_t a = 0; a < alternatives_.size(); ++a)
    if (sides_in(alternatives_[a]) == 1) all.push_back({a, Eigen::VectorXd::Zero(count_of(alternatives_[a].unit))});
  return all;
}

/// Sizes of what the model lacks, and the scatter, from what all changes together leave.
void SeveralComparer::learn(SeveralRanking& ranking) {
  const std::vector<ActiveChange> all = all_changes();
  for (int i = 0; sides_.is_wide && i < learning_steps; ++i) {
    keep_going(sides_.progress);
    learn_sizes(sides_, state_, with_priors(linear_of(all, true).normal, all, 0, change_scale));
  }
  const Linear linear = linear_of(all, false);
  const ScatteredNormal n = with_priors(linear.normal, all, 0, change_scale);
  const Eigen::VectorXd step = n.information.ldlt().solve(n.gradient);
  set_scatter(linear, step, settled_parameters(n, linear.normal.information), ranking);
}

/// What a step leaves beside the noise; where that is more than noise, it is motions of the body, of each rig's own
/// covariance.
void SeveralComparer::set_scatter(const Linear& linear, const Eigen::VectorXd& step, double settled,
                                  SeveralRanking& ranking) {
  std::vector<BodyErrors> left(sides_.scatter.size());
  double rows = 0, noise_degrees = 0;
  for (std::size_t k = 0; k < sides_.sides.size(); ++k) {
    const Eigen::VectorXd own = linear.maps[k] * step;
    for (const ChangeObservation& o : linear_[k].observations) {
      BodyErrors& of_rig = left[static_cast<std::size_t>(sides_.sides[k].rig)];
      of_rig.errors.emplace_back(o.body_by_error - o.body_by_columns * own);
      of_rig.body_squares.push_back(o.body_squares);
    }
    rows += linear_[k].rows;
    noise_degrees += sides_.sides[k].noise_degrees;
  }
  const ScatteredNormal& n = linear.normal;
  const double squares = n.squares - 2 * n.gradient.dot(step) + step.dot(n.information * step);
  ranking.left = {};
  if (const auto test = noise_test(squares, rows - settled, noise_degrees)) ranking.left.p = test->p;
  for (std::size_t r = 0; r < left.size(); ++r)
    sides_.scatter[r] = ranking.left.p > more_than_noise ? Matrix6(Matrix6::Zero()) : scatter_of(left[r]);
}

/// Of every alternative by the linearised model; those worth a fit of their own, best first.
std::vector<std::size_t> SeveralComparer::rank_linearly(const std::vector<ActiveChange>& taken,
                                                        SeveralRanking& ranking) {
  std::vector<ActiveChange> columns = taken;
  const auto is_taken = [&](std::size_t a) {
    return std::any_of(taken.begin(), taken.end(), [&](const ActiveChange& t) { return t.alternative == a; });
  };
  Eigen::Index base = sides_.columns();
  for (const ActiveChange& a : taken) base += a.change.size();
  for (std::size_t a = 0; a < alternatives_.size(); ++a)
    if (!is_taken(a)) columns.push_back({a, Eigen::VectorXd::Zero(count_of(alternatives_[a].unit))});
  const ScatteredNormal n = with_priors(linear_of(columns, true).normal, columns, taken.size(), free_scale);
  const Eigen::Index changes = n.gradient.size() - base;
  const Eigen::LDLT<Eigen::MatrixXd> shared(n.information.topLeftCorner(base, base));
  const Eigen::MatrixXd cross = n.information.topRightCorner(base, changes);
  const Eigen::MatrixXd information =
      n.information.bottomRightCorner(changes, changes) - cross.transpose() * shared.solve(cross);
  const Eigen::VectorXd gradient = n.gradient.tail(changes) - cross.transpose() * shared.solve(n.gradient.head(base));
  std::vector<std::size_t> order;
  std::vector<ChangePlace> places;
  Eigen::Index at = 0;
  for (std::size_t c = taken.size(); c < columns.size(); ++c) {
    const Eigen::Index count = columns[c].change.size();
    const std::size_t a = columns[c].alternative;
    const Eigen::MatrixXd own = information.block(at, at, count, count);
    if (own.trace() >= least_visible) {
      ranking.found[a].is_visible = true;
      ranking.found[a].ln_bayes_factor = change_evidence(own, gradient.segment(at, count));
      order.push_back(a);
      places.push_back({units_[alternatives_[a].unit].group, at, count});
    }
    at += count;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return ranking.found[a].ln_bayes_factor > ranking.found[b].ln_bayes_factor;
  });
  ranking.threshold = change_threshold(information, places);
  return worth_a_fit(order, ranking);
}

/// The best of the best groups, and the best of all.
std::vector<std::size_t> SeveralComparer::worth_a_fit(const std::vector<std::size_t>& order,
                                                      const SeveralRanking& ranking) const {
  std::vector<std::size_t> chosen;
  std::vector<std::string> groups;
  std::size_t beside = 0;
  for (const std::size_t a : order) {
    if (ranking.found[a].ln_bayes_factor < 0.3 * ranking.threshold) break;
    const std::string& group = units_[alternatives_[a].unit].group;
    const bool is_first = std::find(groups.begin(), groups.end(), group) == groups.end();
    if (is_first ? groups.size() == most_groups : beside++ >= most_beside) continue;
    if (is_first) groups.push_back(group);
    chosen.push_back(a);
  }
  return chosen;
}

/// One alternative fitted in full beside those that are taken; the Bayes factor then by Laplace's approximation.
void SeveralComparer::refit(std::size_t alternative, const std::vector<ActiveChange>& taken, double squares_without,
                            SeveralRanking& ranking) const {
  std::vector<ActiveChange> active = taken;
  active.push_back({alternative, Eigen::VectorXd::Zero(count_of(alternatives_[alternative].unit))});
  const Fitted r = fitted(std::move(active));
  const Eigen::VectorXd& change = r.active.back().change;
  const Eigen::Index count = change.size();
  Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(r.information.rows(), count);
  ends.bottomRows(count).setIdentity();
  const Eigen::MatrixXd covariance = r.information.ldlt().solve(ends).bottomRows(count);
  const auto [evidence, gained] = evidence_at(covariance, change, squares_without, r.squares);
  if (!std::isfinite(evidence) || !covariance.allFinite()) return;  // the linearised answer stands
  FoundChange& f = ranking.found[alternative];
  f.ln_bayes_factor = evidence;
  f.explained = gained;
  f.change = change;
  f.sigma = covariance.diagonal().cwiseMax(0).cwiseSqrt();
}

void SeveralComparer::group(SeveralRanking& ranking) const {
  std::map<std::string, std::vector<double>> factors;
  for (std::size_t a = 0; a < alternatives_.size(); ++a) {
    const FoundChange& f = ranking.found[a];
    if (!f.is_visible) continue;
    const std::string& name = units_[alternatives_[a].unit].group;
    factors[name].push_back(f.ln_bayes_factor);
    const auto [place, is_new] = ranking.groups.emplace(name, GroupEvidence{0, a, 0});
    if (!is_new && f.ln_bayes_factor > ranking.found[place->second.best].ln_bayes_factor) place->second.best = a;
  }
  for (auto& [name, evidence] : ranking.groups) {
    evidence.ln_bayes_factor = ln_mean_exp(factors[name]);
    evidence.places = factors[name].size();
  }
}

SeveralRanking SeveralComparer::rank(const std::vector<ActiveChange>& taken, bool learns) {
  SeveralRanking ranking;
  ranking.found.assign(alternatives_.size(), {});
  if (learns) {
    if (!sides_.is_wide) state_ = fitted({}).state;
    linearise({});
    for (int round = 0; round < (sides_.is_wide ? learning_rounds : 1); ++round) learn(ranking);
  }
  const Fitted without = fitted(taken);
  // A wide model stays where it started: with what has changed still missing it would go astray.
  if (!sides_.is_wide) state_ = without.state;
  linearise(without.active);
  for (const std::size_t a : rank_linearly(without.active, ranking)) refit(a, without.active, without.squares, ranking);
  group(ranking);
  return ranking;
}

}  // namespace handsight
