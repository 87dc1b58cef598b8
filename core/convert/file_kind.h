// SPDX-License-Identifier: Apache-2.0
// What a file of a user is, by its content.
#pragma once

#include <filesystem>
#include <string>

#include "robot/robot.h"

namespace handsight {

enum class FileKind {
  robot,        // URDF
  images,       // a folder of them
  joints,       // a table of joint readings
  poses,        // a table or list of poses, a storage or a folder of them
  pose,         // a file with one pose
  points,       // a table of points
  servos,       // of LeRobot: what its joint readings mean
  mocap,        // a table of Motive's, Vicon's or Qualisys's: rigid bodies or markers
  samples,      // of easy_handeye
  storage,      // of OpenCV
  camera_info,  // of ROS, as a file or as `ros2 topic echo` tells it
  ost,          // of ROS's camera_calibration
  realsense,    // its intrinsics
  camodocal,    // a camera of it
  named,        // a camera by fx fy cx cy
  matrix,       // a camera's matrix, or its lens, as plain numbers
  target,       // of Kalibr: what the images show
  camchain,     // of Kalibr
  bag,          // of ROS 2 or 1
};

/// What a file or folder is, without the robot: a table of joints is one whose columns name no place. InputError where
/// it is nothing that a session is made from: the sentence says what it looks like and what to do.
FileKind file_kind(const std::filesystem::path& path, const Robot* robot, const std::vector<std::string>& columns = {});

/// Does it hold the numbers of one camera (of a left and a right one)?
bool is_one_camera(FileKind kind);

/// "a table of joint readings".
const char* kind_text(FileKind kind);

/// Is it called as images are?
bool is_image_name(const std::filesystem::path& file);

/// Is there an image in the folder?
bool has_images(const std::filesystem::path& folder);

/// Has it the marks of OpenCV's FileStorage?
bool is_storage_text(const std::string& text);

}  // namespace handsight
