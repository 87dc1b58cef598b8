// SPDX-License-Identifier: Apache-2.0
// Bags of every kind, as messages by topic and time: of ROS 2 in sqlite3 (*.db3) and MCAP (*.mcap), both also
// compressed with zstd, and of ROS 1 (*.bag, version 2.0). A bag is a file, or the folder of the files of one
// recording.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace handsight {

inline constexpr std::size_t longest_topic = 200;  // bytes of a name that are kept, as sentences show it

struct BagTopic {
  std::string name;      // "/joint_states"
  std::string type;      // "sensor_msgs/JointState", without the "/msg" of ROS 2
  std::string encoding;  // of its messages: "cdr", "ros1", or another that is not read
  std::int64_t messages = 0;
};

/// One file of a bag. What is lost of a damaged one is reported in `lost`, a sentence each, and the rest is read.
class BagFile {
 public:
  BagFile() = default;
  virtual ~BagFile() = default;
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  using Wanted = std::function<bool(const BagTopic&)>;
  using Take = std::function<void(const BagTopic&, std::int64_t nanoseconds, std::string_view bytes)>;
  virtual std::vector<BagTopic> topics() = 0;
  virtual void read(const Wanted& wanted, const Take& take, std::vector<Message>& lost) = 0;
};

/// Each opens one file; `name` is what sentences call it. InputError where it is of another kind, or holds nothing.
std::unique_ptr<BagFile> open_sqlite_bag(const std::filesystem::path& file, const std::string& name);
std::unique_ptr<BagFile> open_mcap_bag(const std::filesystem::path& file, const std::string& name);
std::unique_ptr<BagFile> open_ros1_bag(const std::filesystem::path& file, const std::string& name);

/// Is this a bag: a folder that holds such a file, or the file?
bool is_bag(const std::filesystem::path& path);

/// A bag that is open. Compressed files of it are decompressed into the folder for temporary files, as long as it is.
struct Bag {
  std::string name;  // of its file or folder, for sentences
  std::vector<std::unique_ptr<BagFile>> files;
  std::vector<BagTopic> topics;  // of all files, by name
};

/// InputError where a file is no bag, or of a kind that is not read: the sentence says what it is and what to do.
Bag open_bag(const std::filesystem::path& path);

/// Calls `take` with every message of the wanted topics, file by file and, within one, as they were recorded: roughly
/// in order of time, and in the same order at every call. The bytes hold until it returns; no more than one chunk of a
/// file is in memory. Returns what was lost, a sentence each.
std::vector<Message> read_bag(const Bag& bag, const BagFile::Wanted& wanted, const BagFile::Take& take);

}  // namespace handsight
