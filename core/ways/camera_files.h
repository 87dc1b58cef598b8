// SPDX-License-Identifier: Apache-2.0
// Cameras as ROS and Kalibr write them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "ways/cdr.h"
#include "ways/yaml_text.h"

namespace handsight {

/// One camera of ROS: its numbers, and what its rectified twin says of a rig.
struct RosCamera {
  std::string name, file;
  Camera camera;
  Matrix3 rectified_from_camera = Matrix3::Identity();
  double baseline = 0;  // m: -P[3] / P[0], > 0 for the right camera of a rectified rig
  bool has_rectification = false;
};

/// Is this a camera_info YAML, a camchain?
bool is_camera_info(const YAML::Node& yaml);
bool is_camchain(const YAML::Node& yaml);

/// InputError where it is incomplete, of a lens that sessions have no model for, or not calibrated (zeros).
RosCamera read_camera_info(const YAML::Node& yaml, const std::string& file);
RosCamera camera_from_message(const ros::CameraInfo& message, const std::string& file);

/// The rig that two cameras of ROS make by their rectification. InputError where neither names a baseline.
StereoRig rig_of(const RosCamera& left, const RosCamera& right);

/// cam0 and cam1 of Kalibr's camchain (T_cn_cnm1). Those beyond are named in `notes`.
StereoRig read_camchain(const YAML::Node& yaml, const std::string& file, std::vector<std::string>& notes);

/// InputError, or turned into what it must be with a sentence in `notes`, where images of this size cannot be of these
/// cameras: width and height swapped.
void fit_to_images(StereoRig& rig, int width, int height, std::vector<std::string>& notes);

}  // namespace handsight
