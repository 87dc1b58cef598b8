// SPDX-License-Identifier: Apache-2.0
#include "certify/seen_hand.h"

#include <algorithm>
#include <cmath>

namespace handsight {
namespace {

/// Of xi, the model's numbers and those of what else may be there; both covariances together.
Eigen::MatrixXd whole_covariance(const PredictionModel& model) {
  if (!model.model_uncertainty.is_any()) return model.covariance;
  Eigen::MatrixXd whole = model.model_uncertainty.covariance;
  whole.topLeftCorner(model.covariance.rows(), model.covariance.cols()) += model.covariance;
  return whole;
}

Rigid mount_from_hand(const ObservationState& c, const std::vector<EffectTerm>& terms) {
  const ChainEnds ends = observed_ends(c, moved_sites(c, terms)).ends;
  return inverse(ends.root_from_mount) * ends.root_from_tcp;
}

}  // namespace

SeenHand seen_hand(const ObservationState& c, const PredictionModel& model) {
  const Rigid root_from_mount = observed_ends(c, {}).ends.root_from_mount;
  SeenHand hand;
  hand.nominal = root_from_mount * mount_from_hand(c, {});
  hand.predicted = root_from_mount * mount_from_hand(c, model.effects);
  const Eigen::MatrixXd whole = whole_covariance(model);
  std::vector<EffectTerm> terms = model.effects;
  terms.insert(terms.end(), model.model_uncertainty.others.begin(), model.model_uncertainty.others.end());
  Eigen::MatrixXd by_number = Eigen::MatrixXd::Zero(3, whole.cols());
  by_number.leftCols<3>() = hand.predicted.rotation;  // xi moves the hand as its own motion would
  Eigen::Index number = 5;
  for (EffectTerm& term : terms)
    for (double& value : term.values) {
      ++number;
      const double sigma = std::sqrt(std::max(0.0, whole(number, number))), before = value;
      if (!(sigma > 0)) continue;
      value = before + sigma;
      const Vector3 above = (root_from_mount * mount_from_hand(c, terms)).translation;
      value = before - sigma;
      const Vector3 below = (root_from_mount * mount_from_hand(c, terms)).translation;
      value = before;
      by_number.col(number) = (above - below) / (2 * sigma);
    }
  const Matrix3& r = hand.predicted.rotation;
  hand.covariance = r * model.repeatability.covariance.topLeftCorner<3, 3>() * r.transpose() +
                    by_number * whole * by_number.transpose();
  return hand;
}

}  // namespace handsight
