// SPDX-License-Identifier: Apache-2.0
// Cameras as ROS and Kalibr write them.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "camera/rig.h"
#include "readers/bags/messages.h"

namespace handsight {

/// One camera of ROS: its numbers, and what its rectified twin says of a rig.
struct RosCamera {
  std::string name, file;
  std::string frame;  // in which it sees, as ROS calls it; empty: not told
  Camera camera;
  Matrix3 rectified_from_camera = Matrix3::Identity();
  double baseline = 0;  // m: -P[3] / P[0], > 0 for the right camera of a rectified rig
  bool has_rectification = false;
};

/// InputError where these are no numbers of a camera, or the images' size is missing; `file` begins the sentence.
void check_camera(const Camera& camera, const std::string& file);

/// The lens by what ROS and Kalibr call its model; an empty name is recognised by the count of its numbers.
void set_distortion(Camera& camera, const std::vector<double>& numbers, const std::string& model,
                    const std::string& file);

/// Is this a camera_info YAML, a camchain?
bool is_camera_info(const YAML::Node& yaml);
bool is_camchain(const YAML::Node& yaml);

/// Lenses: plumb_bob (radtan) with up to five numbers, rational_polynomial with eight, equidistant (fisheye) with four.
/// InputError where it is incomplete, of another lens, or not calibrated (zeros).
RosCamera read_camera_info(const YAML::Node& yaml, const std::string& file);
RosCamera camera_from_message(const ros::CameraInfo& message, const std::string& file);

/// The rig that two cameras of ROS make by their rectification. InputError where neither names a baseline.
StereoRig make_rig(const RosCamera& left, const RosCamera& right);

/// cam0, cam1, ... of Kalibr's camchain (T_cn_cnm1), as many as a rig holds; two are called left and right.
Rig read_camchain(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes);

/// A rig of this one camera.
Rig make_rig(const RosCamera& camera);

/// InputError, or turned into what it must be with a sentence in `notes`, where images of this size cannot be of this
/// camera: width and height swapped.
void fit_to_images(RigCamera& camera, int width, int height, std::vector<Message>& notes);

}  // namespace handsight
