// SPDX-License-Identifier: Apache-2.0
// One camera as other programs than ROS's drivers and Kalibr write it.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "base/message.h"
#include "readers/camera_files.h"

namespace handsight {

/// `ros2 topic echo` (or `rostopic echo`) of a CameraInfo: the first of its messages; d k r p in small letters or
/// capitals.
bool is_echoed_camera_info(const YAML::Node& yaml);
RosCamera read_echoed_camera_info(const YAML::Node& yaml, const std::string& file);

/// ost.ini and ost.txt of ROS's camera_calibration (the format of Videre's): one camera, or a left and a right one with
/// their rectification.
bool is_ost(const std::string& text);
std::vector<RosCamera> read_ost(const std::string& text, const std::string& file);

/// RealSense's intrinsics: JSON with width height ppx ppy fx fy model coeffs, or what `rs-enumerate-devices -c` prints,
/// of which one stream is left. Coefficients of "inverse Brown-Conrady" are taken as Brown's, as librealsense itself
/// projects with them; `notes` says so where they are not 0.
bool is_realsense(const YAML::Node& yaml);
bool is_realsense_listing(const std::string& text);
RosCamera read_realsense(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes);
RosCamera read_realsense_listing(const std::string& text, const std::string& file, std::vector<Message>& notes);

/// YAML of fx fy cx cy by name, with image_width and image_height (or width and height) and a list of OpenCV's
/// coefficients, as ZED's tools and people write them, or ORB-SLAM's Camera.fx ... with Camera.k1 ... k3 (of a
/// KannalaBrandt8 k1 ... k4).
bool is_named_camera(const std::string& text);
RosCamera read_named_camera(const std::string& text, const std::string& file, std::vector<Message>& notes);

/// camodocal's YAML: PINHOLE (k1 k2 p1 p2) and KANNALA_BRANDT (a fisheye's k2 k3 k4 k5).
bool is_camodocal(const std::string& text);
RosCamera read_camodocal(const std::string& text, const std::string& file);

}  // namespace handsight
