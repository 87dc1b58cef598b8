// SPDX-License-Identifier: Apache-2.0
// What the choice of a model's effects leaves open: a covariance beside that of its numbers.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "effects/effect.h"

namespace handsight {

/// Which effects a model has was decided by what the measurements say, and they may say it of others nearly as well.
struct ModelUncertainty {
  std::vector<EffectTerm> others;  // that may be there too: numbers 0, choices set
  /// Second moments about the model's answer of xi of TCP->Body (m, rad), of every number of the model's terms and of
  /// every number of `others`, in their units; beside the model's own covariance. Empty: no doubt.
  Eigen::MatrixXd covariance;
  /// Of several sessions: the same of the columns of the fit's problem (markers, mounts, effects' free numbers), then
  /// of the numbers of `others` that are no choices. Each session's own follows from it.
  Eigen::MatrixXd of_columns;

  bool is_any() const { return covariance.size() > 0; }
};

}  // namespace handsight
