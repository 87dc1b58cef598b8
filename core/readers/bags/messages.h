// SPDX-License-Identifier: Apache-2.0
// The few messages of ROS that sessions are made from, as bags hold them: of ROS 2 in CDR (OMG DDS-RTPS 2.3, section
// 10; XCDR1), of ROS 1 in its own way (https://wiki.ros.org/msg): little endian, without gaps.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/rigid.h"

namespace handsight::ros {

struct Header {
  double stamp = 0;  // s
  std::string frame;
};

/// When a message was made; when it was recorded where it does not say. s
double time_of(const Header& header, std::int64_t recorded_nanoseconds);

struct JointState {
  Header header;
  std::vector<std::string> names;
  std::vector<double> position, velocity, effort;
};

struct Image {
  Header header;
  std::uint32_t height = 0, width = 0, step = 0;
  std::string encoding;
  bool is_bigendian = false;
  std::string_view data;  // into the message
};

struct CompressedImage {
  Header header;
  std::string format;
  std::string_view data;
};

struct CameraInfo {
  Header header;
  std::uint32_t height = 0, width = 0;
  std::string model;
  std::vector<double> d;
  double k[9] = {}, r[9] = {}, p[12] = {};
};

struct Transform {
  Header header;
  std::string child;
  Rigid parent_from_child;
};

/// Poses of several things in one frame.
struct Poses {
  Header header;
  std::vector<Rigid> poses;
  std::vector<std::string> names;  // what each is called by; empty where the message does not say
};

/// "sensor_msgs/JointState" of both ROS's names for a type: ROS 2 has "sensor_msgs/msg/JointState".
std::string find_type(std::string_view name);

/// The bytes of one message, CDR with its four bytes of encapsulation and of either byte order; `what` is what
/// sentences call it.
struct Message {
  std::string_view bytes;
  bool is_ros1 = false;
  const std::string& what;
};

/// Each reads one message. InputError where the bytes are too few or are no such message.
JointState read_joint_state(const Message& message);
Image read_image(const Message& message);
CompressedImage read_compressed_image(const Message& message);
CameraInfo read_camera_info(const Message& message);
std::vector<Transform> read_transforms(const Message& message);  // TFMessage
Transform read_transform(const Message& message);                // TransformStamped
/// PoseStamped and PoseWithCovarianceStamped: parent_from_child, without a child's name.
Transform read_pose(const Message& message);
Poses read_pose_array(const Message& message);       // geometry_msgs/PoseArray: without names
Poses read_aruco_markers(const Message& message);    // ArucoMarkers of ros2_aruco: the tags' numbers, then their poses
Poses read_aruco_detection(const Message& message);  // aruco_opencv_msgs/ArucoDetection: tags by number, boards by name
std::string read_string(const Message& message);

}  // namespace handsight::ros
