// SPDX-License-Identifier: Apache-2.0
// The poses that one takes who knows what is missing and by how much: how few could do at best.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/linear_model.h"
#include "estimation/fit/fit.h"
#include "fixtures/trial_sessions.h"

namespace handsight::trials {

/// Takes poses one after another so that the truth gains most on what else could be the cause: each rival, or nothing,
/// is fitted together with the model, and leaves a chi-squared of what the truth does.
class KnowingChoice {
 public:
  /// `seen`: poses without what is hidden. Each can be taken once; the first `taken` of them are measured already.
  KnowingChoice(const Session& seen, const EffectTerm& truth, std::size_t taken) : fit_(fit(seen)) {
    const Candidates candidates = all_candidates(fit_.problem);
    model_ = linear_model(candidates.problem, estimate(fit_), candidates.base_effects, sigma);
    for (const CandidateEffect& effect : candidates.effects) {
      const auto& numbers = effect.effect->parameters;
      if (std::any_of(numbers.begin(), numbers.end(),
                      [](const EffectParameter& p) { return p.is_choice && p.choices.empty(); }))
        continue;  // begins at some moment
      for (const CandidateUnit& unit : effect.units) {
        if (effect.effect->id != truth.id)
          rivals_.push_back({unit.first, unit.count});
        else if (unit.term.place == truth.place)
          set_truth(unit, truth);
      }
    }
    information_ = Eigen::MatrixXd::Zero(model_.external.cols(), model_.external.cols());
    constexpr double least = 1e-6;
    information_.diagonal().head(model_.base) = model_.prior.precision.array() + least;
    for (std::size_t i = 0; i < taken; ++i) information_ += gained_at(i);
    is_taken_.assign(model_.observations.size(), false);
    std::fill_n(is_taken_.begin(), taken, true);
  }

  bool knows() const { return value_.size() > 0; }

  /// The place of the best next pose; nothing once all are taken.
  std::optional<std::size_t> take() {
    std::optional<std::size_t> best;
    double least = 0;
    for (std::size_t i = 0; i < is_taken_.size(); ++i) {
      if (is_taken_[i]) continue;
      if (const double left = doubt(information_ + gained_at(i)); !best || left < least) best = i, least = left;
    }
    if (!best) return best;
    is_taken_[*best] = true;
    information_ += gained_at(*best);
    return best;
  }

 private:
  struct Columns {
    Eigen::Index first = 0, count = 0;
  };

  void set_truth(const CandidateUnit& unit, const EffectTerm& truth) {
    const Effect& effect = term_effect(truth);
    truth_ = {unit.first, unit.count};
    value_.resize(unit.count);
    Eigen::Index next = 0;
    for (std::size_t p = 0; p < truth.values.size(); ++p)
      if (!effect.parameters[p].is_choice) value_[next++] = truth.values[p] / effect.parameters[p].sigma;
  }

  Eigen::MatrixXd gained_at(std::size_t i) const {
    const LinearObservation& o = model_.observations[i];
    const auto rows = model_.external.middleRows(o.first, o.count);
    return rows.transpose() * rows;
  }

  /// ln of the odds of everything else together against the truth, but for what is the same of all poses.
  double doubt(const Eigen::MatrixXd& information) const {
    constexpr double loosely = 3;  // prior sigmas
    const Eigen::Index base = model_.base, others = information.cols() - base;
    const Eigen::LLT<Eigen::MatrixXd> llt(information.topLeftCorner(base, base));
    const Eigen::MatrixXd half = llt.matrixL().solve(information.topRightCorner(base, others));
    const Eigen::VectorXd done = information.block(base, base + truth_.first, others, truth_.count) * value_ -
                                 half.transpose() * (half.middleCols(truth_.first, truth_.count) * value_);
    const double shown = value_.dot(done.segment(truth_.first, truth_.count));
    std::vector<double> logs{-0.5 * shown};
    for (const Columns& r : rivals_) {
      const auto column = half.middleCols(r.first, r.count);
      Eigen::MatrixXd own = information.block(base + r.first, base + r.first, r.count, r.count);
      own -= column.transpose() * column;
      own.diagonal().array() += 1 / (loosely * loosely);
      const Eigen::VectorXd by_it = done.segment(r.first, r.count);
      logs.push_back(-0.5 * (shown - by_it.dot(own.llt().solve(by_it))));
    }
    const double most = *std::max_element(logs.begin(), logs.end());
    double sum = 0;
    for (const double l : logs) sum += std::exp(l - most);
    return most + std::log(sum);
  }

  Fit fit_;
  LinearModel model_;
  std::vector<Columns> rivals_;
  Columns truth_;
  Eigen::VectorXd value_;        // prior sigmas
  Eigen::MatrixXd information_;  // J^T J of the poses taken; the model's columns, then the candidates'
  std::vector<bool> is_taken_;
};

}  // namespace handsight::trials
