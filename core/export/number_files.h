// SPDX-License-Identifier: Apache-2.0
// A calibration's numbers as YAML, CSV, OpenCV's storage and a launch file of ROS 2.
#pragma once

#include <string>

#include "correct/calibrated_robot.h"

namespace handsight {

/// Everything that the calibration says; of formulas the XML of their definitions.
std::string yaml_file(const CalibratedRobot& robot);

/// The same as a table: quantity, of, name, value, sigma, unit.
std::string csv_file(const CalibratedRobot& robot);

/// cv::FileStorage: tcp_from_body, its covariance, mount_from_sensor and the cameras, where they are known.
std::string opencv_file(const CalibratedRobot& robot);

/// A launch file of ROS 2 with static transforms: TCP link to body, mount link to sensor where that is known.
std::string static_tf_file(const CalibratedRobot& robot);

/// x y z w of a rotation, w >= 0.
Eigen::Vector4d make_quaternion(const Matrix3& rotation);

/// In double quotes, as YAML and JSON read them; as a field of a CSV.
std::string quoted_text(const std::string& text);
std::string field_of_table(const std::string& text);

}  // namespace handsight
