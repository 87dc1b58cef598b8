// SPDX-License-Identifier: Apache-2.0
// Which numbers of a calibrated motion are known, for files that hold numbers and no sentences.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/message.h"
#include "correct/calibrated_robot.h"

namespace handsight {

/// A motion as a file tells it: what the session does not determine is NaN, and so are its variances, in whose place
/// stood what is taken for a length or an angle of which nothing is known (10 m, pi).
struct ReportedMotion {
  Vector3 place;                             // m
  Matrix3 rotation;                          // all of it NaN where a turn is not determined
  Matrix6 covariance;                        // of xi in small_motion(xi) * motion
  bool is_place = true, is_rotation = true;  // determined?
  bool is_whole() const { return is_place && is_rotation; }
};

/// The body: with one or two markers its rotation is a convention, which stays; only its variances are NaN then.
ReportedMotion reported_body(const CalibratedRobot& robot);

/// The sensor where `motion` has it (the calibration's, or with effects on its mount).
ReportedMotion reported_mount(const CalibratedRobot& robot, const Rigid& motion);

/// What stands in files of numbers, and in launch files.
inline constexpr const char* nan_instead = "these numbers are nan here, and no sigma stands beside them";
inline constexpr const char* left_out_instead = "the transform is left out of the file";

/// Sentences for people about what is NaN; empty where nothing is. `instead`: what stands in the file.
std::vector<Message> undetermined_texts(const CalibratedRobot& robot, const Message& instead);

}  // namespace handsight
