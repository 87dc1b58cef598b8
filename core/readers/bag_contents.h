// SPDX-License-Identifier: Apache-2.0
// What a bag of ROS 2 holds for a session: joint readings, cameras, images, transforms.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "readers/camera_files.h"
#include "readers/series.h"
#include "robot/robot.h"

namespace handsight {

/// The images of one topic: when each was taken.
struct BagImages {
  std::string topic;
  bool compressed = false;
  std::vector<double> times;
};

/// Transforms of one child frame.
struct BagFrame {
  std::string parent;
  PoseSeries series;
};

struct BagContents {
  std::string robot_description;  // URDF text; empty where no topic has it
  JointSeries joints;             // of the robot's joints that were published
  std::vector<BagImages> images;
  std::map<std::string, RosCamera> cameras;  // by topic
  std::map<std::string, BagFrame> frames;    // by child, of /tf alone
  std::vector<std::string> notes;            // what was taken, and what not
};

/// The robot's URDF as published, empty where it was not.
std::string robot_description_of(const std::filesystem::path& bag);

/// InputError where a message is damaged. `at_each` is called at every message; what it throws ends the reading.
BagContents read_bag_contents(const std::filesystem::path& bag, const Robot& robot,
                              const std::function<void()>& at_each = {});

/// Writes those images of a topic whose places in BagImages::times are wanted, named by `name_of` in `folder` with the
/// ending of their kind; returns the file names in the order wanted. InputError where an encoding is none that sessions
/// hold. `at_each` as above; where it ends in an exception none of them stays.
std::vector<std::string> write_bag_images(const std::filesystem::path& bag, const BagImages& images,
                                          const std::vector<std::size_t>& wanted, const std::filesystem::path& folder,
                                          const std::string& side, const std::function<void()>& at_each = {});

}  // namespace handsight
