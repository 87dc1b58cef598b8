// SPDX-License-Identifier: Apache-2.0
// What neither the measurements nor anything known beside them determine: motions of the body and of the sensor that
// leave every residual as it is.
#pragma once

#include <array>
#include <string>

#include "base/message.h"
#include "estimation/fit/fit_result.h"

namespace handsight {

/// Gives a factor of the covariance of the problem's columns one column more for each direction of the unknowns that
/// nothing determines, as long as what stands for a length or an angle of which nothing is known
/// (chain/unknown_angle.h).
void add_undetermined_columns(const Fit& fit, Eigen::MatrixXd& factor);

/// A pose's motions of which nothing is known: more than 1 m or 1 rad.
struct UndeterminedMotions {
  Eigen::Matrix<double, 6, Eigen::Dynamic> directions;  // unit (v, w), as many as there are
  std::array<bool, 6> numbers{};                        // which of x y z and the turns about them are touched

  bool is_any() const { return directions.cols() > 0; }
};

/// `covariance`: of the pose's place and its small turn, about its own origin.
UndeterminedMotions undetermined_motions(const Matrix6& covariance);

/// Covariance of the place of TCP->Body's origin and of its turn, in the TCP's axes.
Matrix6 body_covariance_at_origin(const Fit& fit);
/// The same of the sensor in the axes of the mount's link. The mount must be estimated.
Matrix6 mount_covariance_at_origin(const Fit& fit);

/// Sentences for people: what of TCP->Body and of the mount is not determined, along which axes, and why. Empty where
/// all of it is, and for one or two markers, whose rotation is a convention.
std::vector<Message> undetermined_texts(const Fit& fit);

/// Did the hand stand still against the sensor in all observations of the fit, though where the sensor sits is asked
/// for? Then nothing of either is determined.
bool never_moved(const Fit& fit);

}  // namespace handsight
