// SPDX-License-Identifier: Apache-2.0
// The evidence for what a model lacks: linearised Bayes factors with physical priors, under one assumption of how well
// the joints repeat (docs/method.md, "Ranking what is missing").
#pragma once

#include <array>
#include <span>

#include "diagnosis/evidence/linear_model.h"

namespace handsight {

/// Effects may be as large as plausible, or by these factors smaller and larger: the prior sigma is what is usual,
/// not a wall. Where a hobby arm's zeros were set by eye they are thirty times as far off as a factory's.
inline constexpr std::array<double, 6> prior_scales{0.1, 0.3, 1, 3, 10, 30};
/// How much of the prior each of them has.
inline constexpr std::array<double, 6> scale_shares{0.24, 0.24, 0.24, 0.24, 0.03, 0.01};
/// The largest that surprises nobody.
inline constexpr double largest_usual_scale = 3;

/// How the logarithm of a Bayes factor follows from squares: sigma known, or profiled out over `degrees` of freedom.
struct NoiseKnowledge {
  bool known = true;
  double degrees = 0;  // rows less the model's parameters; read where sigma is not known
};

/// What is drawn anew in every observation, beside the measurements' noise: each joint's value, and the hand's place as
/// the sensor sees it (a coordinate of it).
struct Repeatability {
  double joints = 0;                  // rad; where they differ the root of the mean square
  double place = 0;                   // m
  std::vector<double> of_joint = {};  // one a joint, times `joints`; empty: all alike

  bool is_any() const { return joints > 0 || place > 0; }
  bool operator==(const Repeatability&) const = default;
};

/// A linear model whitened for a scatter, its own parameters projected out.
struct WhitenedModel {
  const LinearModel* model = nullptr;
  Repeatability repeatability;
  std::vector<Eigen::MatrixXd> whiteners;  // per observation, count x count
  Eigen::MatrixXd external;                // rows x (base + candidates)
  Eigen::VectorXd external_error;
  Eigen::LLT<Eigen::MatrixXd> base;  // of the base's information with priors
  Eigen::MatrixXd shared;            // L^-1 B^T C, base x candidates
  Eigen::VectorXd base_gradient;     // L^-1 of the base's gradient
  double residual_squares = 0;       // after the base's own best step, priors included
  double ln_evidence = 0;            // of the model, up to a constant that all scatters share
};

WhitenedModel whiten(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise);

/// The same into the place of another, whose memory it takes: of thousands of observations these are hundreds of MB.
void whiten(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise,
            WhitenedModel& into);

/// What the measurements say of a model's own parameters under one scatter.
struct BaseSums {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double squares = 0, ln_volume = 0;
};

/// The evidence of a model's own parameters alone, for one prior after another.
class BaseEvidence {
 public:
  BaseEvidence(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise);
  /// WhitenedModel::ln_evidence, were this the model's prior.
  double ln_with(const BasePrior& prior) const;
  /// WhitenedModel::residual_squares, were this the model's prior.
  double squares_with(const BasePrior& prior) const;

 private:
  BaseSums sums_;
  NoiseKnowledge noise_;
};

/// WhitenedModel::ln_evidence without whitening the candidates, which are most of the columns.
double ln_evidence_of_base(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise);

/// What the data say of some parameters in units of their prior sigma: information A and score b after the model's
/// own parameters are projected out.
struct Score {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
};

Score score(const WhitenedModel& w, Eigen::Index first, Eigen::Index count);

/// The part of a score for these of its parameters.
Score take_part(const Score& whole, std::span<const Eigen::Index> parameters);

/// ln of the Bayes factor for a score at prior sigmas times `scale` alone.
double ln_bayes_factor_at(const Score& score, double scale, const WhitenedModel& w, const NoiseKnowledge& noise);

/// ln of the mean over the scales, by their shares, of the Bayes factor for a score.
double ln_bayes_factor(const Score& score, const WhitenedModel& w, const NoiseKnowledge& noise);

/// Some parameters of a score that follow each other.
struct ParameterGroup {
  Eigen::Index first = 0, count = 0;
};

/// ln_bayes_factor() of a score, and of it without each of these groups, which hold no parameter twice.
struct FactorsWithout {
  double whole = 0;
  std::vector<double> without;
};
FactorsWithout ln_bayes_factors_without(const Score& score, std::span<const ParameterGroup> groups,
                                        const WhitenedModel& w, const NoiseKnowledge& noise);

/// ln_bayes_factor() of the chosen parameters of a score together with each of these groups, which hold none of them.
std::vector<double> ln_bayes_factors_beside(const Score& all, std::span<const Eigen::Index> chosen,
                                            std::span<const ParameterGroup> groups, const WhitenedModel& w,
                                            const NoiseKnowledge& noise);

/// The best estimate (plausible units) and its covariance at the best of those scales.
struct LinearEstimate {
  Eigen::VectorXd value;
  Eigen::MatrixXd covariance;
  double scale = 1;
};
LinearEstimate linear_estimate(const Score& score, const WhitenedModel& w, const NoiseKnowledge& noise);

/// ln(mean(exp(x))), 0 of nothing.
double ln_mean_exp(std::span<const double> x);

/// ln of the mean of exp(x) over the plausible scales, one x each, by their shares.
double ln_over_scales(std::span<const double> x);

}  // namespace handsight
