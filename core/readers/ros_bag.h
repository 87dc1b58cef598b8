// SPDX-License-Identifier: Apache-2.0
// Bags of ROS 2 in sqlite3: a folder with metadata.yaml and *.db3, or one .db3 alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace handsight {

struct BagTopic {
  std::string name, type;  // "/joint_states", "sensor_msgs/msg/JointState"
  std::int64_t messages = 0;
};

/// Is this a bag: a folder that holds a .db3, or such a file?
bool is_bag(const std::filesystem::path& path);

/// All topics of all files, by name. InputError where a file is no bag of this kind, or is compressed.
std::vector<BagTopic> bag_topics(const std::filesystem::path& path);

/// Calls `take` with the bytes of every message of a topic in order of time (ns, when it was recorded), file by file.
void read_bag(const std::filesystem::path& path, const std::string& topic,
              const std::function<void(std::int64_t nanoseconds, std::string_view bytes)>& take);

}  // namespace handsight
