// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/planning/cause_planning.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/outliers/snooping.h"
#include "diagnosis/planning/cause_suspects.h"
#include "diagnosis/planning/expected_poses.h"
#include "diagnosis/planning/pose_pool.h"

namespace handsight {
namespace {

/// Nats of distance that count as settled: odds of 20.
constexpr double evidence_in_question = 3;
/// The nats about the model's own numbers beside those about names: enough to decide where names do not.
constexpr double worth_of_numbers = 0.2;
constexpr double least_probability = 1e-4;  // of a suspect that is still asked about

/// What a hypothesis predicts of a pose's measurement, beside what the model does without it: its mean, and its
/// covariance by what is not known of its numbers; in units of the measurement's own uncertainty.
struct Prediction {
  Eigen::VectorXd mean;
  Eigen::LLT<Eigen::MatrixXd> covariance;
  double half_ln_determinant = 0;
};

/// Bhattacharyya's: how little two predictions overlap.
double distance(const Prediction& a, const Prediction& b) {
  const Eigen::MatrixXd middle = 0.5 * (a.covariance.reconstructedMatrix() + b.covariance.reconstructedMatrix());
  const Eigen::LLT<Eigen::MatrixXd> llt(middle);
  const double squares = llt.matrixL().solve(a.mean - b.mean).squaredNorm();
  return squares / 8 + half_ln_determinant(llt) - 0.5 * (a.half_ln_determinant + b.half_ln_determinant);
}

class CausePlanner {
 public:
  CausePlanner(const Session& session, const PlanOptions& options) : session_(session), options_(options) {
    FitOptions o;
    o.effects = options.effects;
    o.estimated = options.estimated;
    fit_ = clean_fit(session, o).fit;
    candidates_ = all_candidates(fit_.problem);
    learn();
    fill_pool();
  }

  std::vector<Eigen::VectorXd> run() {
    std::vector<Eigen::VectorXd> chosen;
    while (static_cast<int>(chosen.size()) < options_.count && !pool_.empty()) {
      const std::size_t best = find_best();
      chosen.push_back(pool_[best]);
      measure(best);
      remove(best);
    }
    return chosen;
  }

 private:
  /// What the measurements so far say.
  void learn() {
    const NoiseModel noise = noise_model(fit_);
    noise_ = noise.noise;
    const LinearModel model = linear_model(candidates_.problem, estimate(fit_), candidates_.base_effects, noise_);
    const WhitenedModel w = whiten(model, {}, noise.knowledge);
    suspects_ = list_suspects(candidates_, w, noise.knowledge);
    std::erase_if(suspects_, [](const Suspect& s) { return s.count > 0 && s.probability < least_probability; });
    base_ = w.base.reconstructedMatrix();
    shared_ = w.base.matrixL() * w.shared;
    distances_.setZero(static_cast<Eigen::Index>(suspects_.size()), static_cast<Eigen::Index>(suspects_.size()));
  }

  void fill_pool() {
    const PoseJudge judge(session_, fit_);
    pool_ = pose_pool(session_, judge, options_.pool, options_.seed);
    std::erase_if(pool_, [&](const Eigen::VectorXd& q) { return options_.may_take && !options_.may_take(q); });
    if (pool_.empty()) return;
    const Problem problem = expected_problem(candidates_.problem, estimate(fit_), fit_.tcp_from_body, pool_,
                                             session_.observations.back().position);
    rows_ = linear_model(problem, estimate(fit_), candidates_.base_effects, noise_);
    for (std::size_t i = 0; i < pool_.size(); ++i) row_of_.push_back(i);
  }

  auto rows_at(std::size_t i) const {
    const LinearObservation& o = rows_.observations[row_of_[i]];
    return rows_.external.middleRows(o.first, o.count);
  }

  /// The model's own numbers predict a measurement with this covariance, the noise's included; its root.
  Eigen::LLT<Eigen::MatrixXd> own_covariance(const Eigen::MatrixXd& by_base) const {
    const Eigen::MatrixXd whitened = llt_.matrixL().solve(by_base.transpose());
    Eigen::MatrixXd v = whitened.transpose() * whitened;
    v.diagonal().array() += 1;
    return Eigen::LLT<Eigen::MatrixXd>(v);
  }

  /// What a suspect's numbers do there that the model's own cannot take up, in units of what both leave open.
  Eigen::MatrixXd seen_of(const Suspect& s, const Eigen::MatrixXd& rows, const Eigen::LLT<Eigen::MatrixXd>& own) const {
    const Eigen::MatrixXd left = rows.middleCols(rows_.base + s.first, s.count) -
                                 rows.leftCols(rows_.base) * taken_up_.middleCols(s.first, s.count);
    return own.matrixL().solve(left);
  }

  Prediction predict(const Suspect& s, const Eigen::MatrixXd& rows, const Eigen::LLT<Eigen::MatrixXd>& own) const {
    Prediction p;
    Eigen::MatrixXd v = Eigen::MatrixXd::Identity(rows.rows(), rows.rows());
    p.mean = Eigen::VectorXd::Zero(rows.rows());
    if (s.count > 0) {
      const Eigen::MatrixXd seen = seen_of(s, rows, own);
      p.mean = seen * s.value;
      v += seen * s.information.llt().solve(seen.transpose());
    }
    p.covariance.compute(v);
    p.half_ln_determinant = half_ln_determinant(p.covariance);
    return p;
  }

  /// Between all suspects, of the poses that were chosen and of this one; 0 between places of one effect.
  Eigen::MatrixXd distances_with(const std::vector<Prediction>& predictions) const {
    Eigen::MatrixXd all = distances_;
    for (std::size_t a = 0; a < suspects_.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        if (suspects_[a].effect == suspects_[b].effect) continue;
        const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
        all(i, j) = all(j, i) += distance(predictions[a], predictions[b]);
      }
    return all;
  }

  /// Nats that are expected about which suspect it is: a bound of the mutual information.
  double said_of_names(const Eigen::MatrixXd& distances) const {
    double sum = 0;
    for (std::size_t a = 0; a < suspects_.size(); ++a) {
      double like = 0;
      for (std::size_t b = 0; b < suspects_.size(); ++b)
        like += suspects_[b].probability *
                std::exp(-distances(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) / evidence_in_question);
      sum -= suspects_[a].probability * std::log(like);
    }
    return sum;
  }

  std::vector<Prediction> predictions_at(const Eigen::MatrixXd& rows, const Eigen::LLT<Eigen::MatrixXd>& own) const {
    std::vector<Prediction> all;
    for (const Suspect& s : suspects_) all.push_back(predict(s, rows, own));
    return all;
  }

  double worth(std::size_t i) const {
    const Eigen::MatrixXd rows = rows_at(i);
    const Eigen::LLT<Eigen::MatrixXd> own = own_covariance(rows.leftCols(rows_.base));
    const std::vector<Prediction> predictions = predictions_at(rows, own);
    double numbers = half_ln_determinant(own);
    for (std::size_t s = 0; s < suspects_.size(); ++s)
      numbers += suspects_[s].probability * predictions[s].half_ln_determinant;
    return said_of_names(distances_with(predictions)) + worth_of_numbers * numbers;
  }

  std::size_t find_best() {
    llt_.compute(base_);
    taken_up_ = llt_.solve(shared_);
    std::size_t best = 0;
    double most = -1e300;
    for (std::size_t i = 0; i < pool_.size(); ++i)
      if (const double w = worth(i); w > most) most = w, best = i;
    return best;
  }

  void measure(std::size_t i) {
    const Eigen::MatrixXd rows = rows_at(i);
    const Eigen::MatrixXd by_base = rows.leftCols(rows_.base);
    const Eigen::LLT<Eigen::MatrixXd> own = own_covariance(by_base);
    distances_ = distances_with(predictions_at(rows, own));
    for (Suspect& s : suspects_) {
      if (s.count == 0) continue;
      const Eigen::MatrixXd seen = seen_of(s, rows, own);
      s.information += seen.transpose() * seen;
    }
    base_ += by_base.transpose() * by_base;
    shared_ += by_base.transpose() * rows.rightCols(rows_.candidates());
  }

  void remove(std::size_t i) {
    pool_.erase(pool_.begin() + static_cast<std::ptrdiff_t>(i));
    row_of_.erase(row_of_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  const Session& session_;
  const PlanOptions& options_;
  Fit fit_;
  Candidates candidates_;
  double noise_ = 1;
  std::vector<Suspect> suspects_;
  Eigen::MatrixXd base_, shared_;      // information about the model's own numbers; with the candidates
  Eigen::LLT<Eigen::MatrixXd> llt_;    // of base_
  Eigen::MatrixXd taken_up_;           // base x candidates: by how much the model's numbers give way
  Eigen::MatrixXd distances_;          // between suspects, by the poses that are chosen
  std::vector<Eigen::VectorXd> pool_;  // rad (m)
  std::vector<std::size_t> row_of_;    // per pose of the pool: its observation in rows_
  LinearModel rows_;                   // of the pool
};

}  // namespace

std::vector<Eigen::VectorXd> plan_for_causes(const Session& session, const PlanOptions& options) {
  return CausePlanner(session, options).run();
}

}  // namespace handsight
