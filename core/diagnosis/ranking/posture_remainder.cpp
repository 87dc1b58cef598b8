// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/posture_remainder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "diagnosis/evidence/candidates.h"
#include "estimation/report/regions.h"

namespace handsight {
namespace {

constexpr Eigen::Index waves = 24;
constexpr std::array<double, 3> lengths{0.4, 0.8, 1.6};  // in the features' unit: ranges of joints and place
constexpr std::array<double, 3> sizes{0.3, 1, 3};        // in root mean squares of what is left

/// Waves over the features in random directions: observations x waves, each of mean square 1 / waves.
Eigen::MatrixXd waves_over(const Eigen::MatrixXd& features, double length) {
  std::mt19937_64 random(20261125);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  Eigen::MatrixXd turns(features.cols(), waves);
  for (double& turn : turns.reshaped()) turn = normal(random) / length;
  Eigen::MatrixXd angles = features * turns;
  for (auto column : angles.colwise()) column.array() += phase(random);
  return std::sqrt(2.0 / static_cast<double>(waves)) * angles.array().cos().matrix();
}

/// What of the hand's place, in m, the external error may be: root mean square over observations.
double place_left(const LinearModel& model) {
  double squares = 0, by_place = 0;
  for (const LinearObservation& o : model.observations) {
    squares += model.external_error.segment(o.first, o.count).squaredNorm();
    by_place += o.by_body.leftCols<3>().squaredNorm() / 3;
  }
  return by_place > 0 ? std::sqrt(squares / by_place) : 0;
}

/// The model with three more columns a wave in its base: the hand's place along x, y and z of the sensor.
LinearModel with_remainder(const LinearModel& model, const Eigen::MatrixXd& by_wave, double size) {
  const Eigen::Index base = model.base, added = 3 * by_wave.cols(), candidates = model.candidates();
  LinearModel with = model;
  with.base = base + added;
  with.external.resize(model.external.rows(), model.external.cols() + added);
  with.external.leftCols(base) = model.external.leftCols(base);
  with.external.rightCols(candidates) = model.external.rightCols(candidates);
  for (std::size_t i = 0; i < model.observations.size(); ++i) {
    const LinearObservation& o = model.observations[i];
    for (Eigen::Index k = 0; k < by_wave.cols(); ++k)
      with.external.block(o.first, base + 3 * k, o.count, 3) =
          size * by_wave(static_cast<Eigen::Index>(i), k) * o.by_body.leftCols<3>();
  }
  const Eigen::Index inner = model.internal.cols(), rest = inner - base;
  with.internal = Eigen::MatrixXd::Zero(inner + added, inner + added);
  with.internal.topLeftCorner(base, base) = model.internal.topLeftCorner(base, base);
  with.internal.topRightCorner(base, rest) = model.internal.topRightCorner(base, rest);
  with.internal.bottomLeftCorner(rest, base) = model.internal.bottomLeftCorner(rest, base);
  with.internal.bottomRightCorner(rest, rest) = model.internal.bottomRightCorner(rest, rest);
  for (Eigen::Index& place : with.internal_of)
    if (place >= 0) place += added;
  with.prior.precision.conservativeResize(base + added);
  with.prior.gradient.conservativeResize(base + added);
  with.prior.precision.tail(added).setOnes();
  with.prior.gradient.tail(added).setZero();
  return with;
}

/// The likeliest of the assumptions, without and with the terms.
struct Likeliest {
  double without = -1e300, with = -1e300;

  void take(const LinearModel& model, const Repeatability& repeatability, const NoiseKnowledge& noise) {
    const WhitenedModel w = whiten(model, repeatability, noise);
    without = std::max(without, w.ln_evidence);
    with = std::max(with, w.ln_evidence + ln_bayes_factor(score(w, 0, model.candidates()), w, noise));
  }
};

}  // namespace

double ln_factor_beside_posture(const Fit& without, const std::vector<EffectTerm>& terms,
                                const Repeatability& repeatability, const NoiseModel& noise_model) {
  const Candidates candidates = list_candidates(without.problem, terms);
  const LinearModel model =
      linear_model(candidates.problem, estimate(without), candidates.base_effects, noise_model.noise);
  const Eigen::MatrixXd features = posture_features(candidates.problem);
  const double left = place_left(model);
  Likeliest likeliest;
  likeliest.take(model, repeatability, noise_model.knowledge);
  for (const double length : lengths) {
    const Eigen::MatrixXd by_wave = waves_over(features, length);
    for (const double size : sizes)
      likeliest.take(with_remainder(model, by_wave, size * left), repeatability, noise_model.knowledge);
  }
  return likeliest.with - likeliest.without;
}

}  // namespace handsight
