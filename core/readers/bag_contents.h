// SPDX-License-Identifier: Apache-2.0
// What a bag of ROS holds for a session: joint readings, cameras, images, transforms.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "readers/bag_poses.h"
#include "readers/bags/bag.h"
#include "readers/camera_files.h"
#include "readers/series.h"
#include "robot/robot.h"

namespace handsight {

/// The images of one topic in order of time: when each was taken, and the how-many-th of the topic's messages it is.
struct BagImages {
  std::string topic;
  std::vector<double> times;
  std::vector<std::size_t> places;
};

struct BagContents {
  JointSeries joints;  // of the robot's joints that were published
  std::vector<BagImages> images;
  std::map<std::string, RosCamera> cameras;  // by topic
  BagFrames frames;
  std::vector<Message> ambiguous;  // topics of poses of which nothing tells what they are of, and why
  std::vector<Message> notes;      // what was taken, and what not
};

/// The robot's URDF as published, empty where it was not.
std::string find_robot_description(const Bag& bag);

/// InputError where a message is damaged. `at_each` is called at every message; what it throws ends the reading.
BagContents read_bag_contents(const Bag& bag, const Robot& robot, const std::function<void()>& at_each = {});

/// Writes those images of a topic whose places in BagImages::times are wanted, into `folder` with `side` in their names
/// and the ending of their kind; returns the file names in the order wanted. InputError where an encoding is none that
/// sessions hold. `at_each` as above; where it ends in an exception none of them stays.
std::vector<std::string> write_bag_images(const Bag& bag, const BagImages& images,
                                          const std::vector<std::size_t>& wanted, const std::filesystem::path& folder,
                                          const std::string& side, const std::function<void()>& at_each = {});

}  // namespace handsight
