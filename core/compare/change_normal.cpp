// SPDX-License-Identifier: Apache-2.0
#include "compare/change_normal.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "compare/change_evidence.h"
#include "compare/change_limits.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"

namespace handsight {

Eigen::Index count_numbers(const std::vector<EffectTerm>& terms) {
  Eigen::Index count = 0;
  for (const EffectTerm& t : terms)
    for (const EffectParameter& p : term_effect(t).parameters) count += !p.is_choice;
  return count;
}

std::vector<EffectTerm> with_numbers(std::vector<EffectTerm> terms, const Eigen::VectorXd& values) {
  Eigen::Index next = 0;
  for (EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!term_effect(t).parameters[p].is_choice) t.values[p] = values[next++];
  return terms;
}

Problem with_changes(const Problem& problem, const std::vector<EffectTerm>& terms, const Eigen::VectorXd& effects) {
  Candidates c = list_candidates(problem, terms);
  Eigen::VectorXd values(c.problem.effect_count());
  values.head(effects.size()) = effects;
  Eigen::Index next = effects.size();
  for (const EffectTerm& t : terms)
    for (std::size_t p = 0; p < t.values.size(); ++p)
      if (!term_effect(t).parameters[p].is_choice) values[next++] = t.values[p];
  if (values.size() > 0) set_effects(c.problem, values);
  return std::move(c.problem);
}

void add_prior(ScatteredNormal& n, Eigen::Index column, double value, double scale) {
  n.information(column, column) += 1 / (scale * scale);
  n.gradient[column] -= value / (scale * scale);
  n.squares += value * value / (scale * scale);
}

void stiffen(ScatteredNormal& n) {
  for (Eigen::Index i = 0; i < n.gradient.size(); ++i) n.information(i, i) += 1e-12 * n.information(i, i) + 1e-12;
}

Eigen::MatrixXd last_covariance(const Eigen::MatrixXd& information, Eigen::Index count) {
  Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(information.rows(), count);
  ends.bottomRows(count).setIdentity();
  return information.ldlt().solve(ends).bottomRows(count);
}

EvidenceAt evidence_at(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& change, double squares_without,
                       double squares_with) {
  const double gained = squares_without - squares_with;
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(change.size(), change.size());
  return {change_evidence_at(covariance.ldlt().solve(one) - change_weight * one, change, gained), gained};
}

LinearRanking rank_linearly(const ScatteredNormal& n, std::vector<ChangeFinding>& found) {
  Eigen::Index changes = 0;
  for (const ChangeFinding& f : found) changes += f.numbers;
  const Eigen::Index base = n.gradient.size() - changes;
  const Eigen::LDLT<Eigen::MatrixXd> shared(n.information.topLeftCorner(base, base));
  const Eigen::MatrixXd cross = n.information.topRightCorner(base, changes);
  const Eigen::MatrixXd information =
      n.information.bottomRightCorner(changes, changes) - cross.transpose() * shared.solve(cross);
  const Eigen::VectorXd gradient = n.gradient.tail(changes) - cross.transpose() * shared.solve(n.gradient.head(base));
  LinearRanking ranking;
  std::vector<ChangePlace> places;
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    ChangeFinding& f = found[i];
    const Eigen::MatrixXd own = information.block(at, at, f.numbers, f.numbers);
    f.is_visible = own.trace() >= least_visible_change;
    if (f.is_visible) {
      f.ln_bayes_factor = change_evidence(own, gradient.segment(at, f.numbers));
      ranking.order.push_back(i);
      places.push_back({f.group, at, f.numbers});
    }
    at += f.numbers;
  }
  std::stable_sort(ranking.order.begin(), ranking.order.end(),
                   [&](std::size_t a, std::size_t b) { return found[a].ln_bayes_factor > found[b].ln_bayes_factor; });
  ranking.threshold = change_threshold(information, places);
  return ranking;
}

std::map<std::string, GroupEvidence> group_evidence(const std::vector<ChangeFinding>& changes) {
  std::map<std::string, std::vector<double>> factors;
  std::map<std::string, GroupEvidence> groups;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const ChangeFinding& f = changes[i];
    if (!f.is_visible) continue;
    factors[f.group].push_back(f.ln_bayes_factor);
    const auto [place, is_new] = groups.emplace(f.group, GroupEvidence{0, i, 0});
    if (!is_new && f.ln_bayes_factor > changes[place->second.best].ln_bayes_factor) place->second.best = i;
  }
  for (auto& [name, evidence] : groups) {
    evidence.ln_bayes_factor = ln_mean_exp(factors[name]);
    evidence.places = factors[name].size();
  }
  return groups;
}

}  // namespace handsight
