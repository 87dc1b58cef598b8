// SPDX-License-Identifier: Apache-2.0
// Where the sensor tells the hand to be, as a model's effects are or are changed: what a cause is worth at the hand.
#pragma once

#include "estimation/fit/fit_result.h"

namespace handsight {

/// The body's origin (with markers that shift, moved as their mean) in the sensor's frame, in one observation after
/// another; of long sessions 400 of them, evenly taken. Where cameras are moved, it is where the model's own cameras
/// would tell it from what they see: of two or more triangulated, of one across the line of sight.
class HandPlaces {
 public:
  explicit HandPlaces(const Fit& fit);

  /// By how much these terms in the place of the model's would move it, m: a column an observation. Where the
  /// mount is estimated too, what is the same in all of them is left out: it is the mount's.
  Eigen::Matrix3Xd moved_by(const std::vector<EffectTerm>& terms);

 private:
  Eigen::Matrix3Xd with(const std::vector<EffectTerm>& terms);
  Vector3 reported_place(const ProblemObservation& o) const;

  const Fit& fit_;
  Problem part_;  // of some observations
  Eigen::Matrix3Xd now_;
};

}  // namespace handsight
