// SPDX-License-Identifier: Apache-2.0
// Where the hand really was, as each observation measured it, before correction and after, every observation judged by
// fits that have not seen it: as the sensor's link sees it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "estimation/report/prediction.h"

namespace handsight {

/// One measured pose; motions are root_from_hand.
struct AttainedPose {
  std::int64_t id = 0;
  int index = 0;                         // into Session::observations
  int same_pose = 0;                     // the rank of the first observation in the same configuration
  Rigid commanded;                       // by the nominal robot
  Rigid before, after;                   // attained, uncorrected and corrected
  bool shows_turn = true;                // false: the rotations are the commanded ones
  Matrix3 covariance = Matrix3::Zero();  // m^2, root axes: of after - commanded as the model and the noise promise it
};

struct AttainedPoses {
  std::vector<AttainedPose> all;  // in order of time
  int folds = 0;
  int shown_nothing = 0;  // used observations that do not show where the hand was
};

/// What stands for the robot in the folds: terms that each fold estimates for itself, or, with `of_file`, terms as they
/// are and how sure of them the calibration of another session is.
struct CertifiedModel {
  FitOptions options;
  ModelUncertainty model_uncertainty;
  std::optional<PredictionModel> of_file;  // of the hand that the robot moves
};

/// Five folds, an observation and its repetitions in one. `before` is a fit without the effects that move the robot:
/// what is wrong with cameras and target is not counted against it. InputError where there are fewer than ten used
/// observations or two folds. `goes_on` is asked before each fold; where it says no, what is there is returned.
AttainedPoses attained_poses(const Session& session, const CertifiedModel& model,
                             const std::function<bool(double done)>& goes_on = {});

}  // namespace handsight
