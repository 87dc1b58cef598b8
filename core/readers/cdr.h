// SPDX-License-Identifier: Apache-2.0
// The few messages of ROS 2 that sessions are made from, as bags hold them: CDR (OMG DDS-RTPS 2.3, section 10; XCDR1).
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

/// Each reads one message with its four bytes of encapsulation, of either byte order. InputError, in which `what` is
/// what the sentence calls it, where the bytes are too few or are no such message.
JointState read_joint_state(std::string_view bytes, const std::string& what);
Image read_image(std::string_view bytes, const std::string& what);
CompressedImage read_compressed_image(std::string_view bytes, const std::string& what);
CameraInfo read_camera_info(std::string_view bytes, const std::string& what);
std::vector<Transform> read_transforms(std::string_view bytes, const std::string& what);
std::string read_string(std::string_view bytes, const std::string& what);

}  // namespace handsight::ros
