// SPDX-License-Identifier: Apache-2.0
#include "readers/bags/bag.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "readers/bags/decompress.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

bool has_ending(const fs::path& file) {
  const std::string name = file.filename().string();
  for (const char* ending : {".db3", ".mcap", ".bag", ".bag.active", ".db3.zstd", ".mcap.zstd"})
    if (name.ends_with(ending)) return true;
  return false;
}

std::string first_bytes(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(16, '\0');
  stream.read(bytes.data(), 16);
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

bool begins_as_bag(std::string_view bytes) { return bytes.starts_with("\x89MCAP") || bytes.starts_with("#ROSBAG V"); }

std::vector<fs::path> files_of_bag(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path, error))
    if (has_ending(entry.path()) && fs::is_regular_file(entry.path(), error)) files.push_back(entry.path());
  // bag_2.db3 stands before bag_10.db3
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    const std::string left = a.filename().string(), right = b.filename().string();
    return left.size() != right.size() ? left.size() < right.size() : left < right;
  });
  // What `ros2 bag play` has decompressed stays beside the compressed file.
  const std::set<fs::path> all(files.begin(), files.end());
  std::erase_if(
      files, [&](const fs::path& f) { return f.extension() == ".zstd" && all.contains(f.parent_path() / f.stem()); });
  return files;
}

[[noreturn]] void refuse_version(const std::string& name, std::string_view begin) {
  const std::string version(begin.substr(0, begin.find('\n')));
  throw InputError(
      message("{}: is a bag of ROS 1 of the version {}; expected V2.0. `rosbag fix OLD.bag NEW.bag` of ROS writes it "
              "anew.",
              name, in_quotes(version)));
}

std::unique_ptr<BagFile> open_plain(const fs::path& file, const std::string& name) {
  const std::string begin = first_bytes(file);
  if (begin.starts_with("\x89MCAP")) return open_mcap_bag(file, name);
  if (begin.starts_with("#ROSBAG V2.0")) return open_ros1_bag(file, name);
  if (begin.starts_with("#ROSBAG")) refuse_version(name, begin);
  if (file.extension() == ".db3") return open_sqlite_bag(file, name);
  throw InputError(
      message("{}: does not begin as a bag does: it was not copied whole, or is of another kind; expected a ROS 2 bag "
              "(sqlite3 or MCAP) or a ROS 1 bag of version 2.0.",
              name));
}

/// Gone when it is no longer needed.
struct TemporaryFolder {
  fs::path path;
  TemporaryFolder() = default;
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code error;
    if (!path.empty()) fs::remove_all(path, error);
  }
};

/// A file that was compressed as a whole.
class DecompressedBag : public BagFile {
 public:
  DecompressedBag(const fs::path& file, const std::string& name) {
    folder_.path = make_temporary_folder(fs::temp_directory_path());
    const fs::path plain = folder_.path / file.stem().filename();
    const Message fault = decompress_file(file, plain);
    if (!fault.empty())
      lost_ = message("{}: its zstd is damaged ({}): what comes after the damage is lost.", name, at_most(fault, 80));
    try {
      inner_ = open_plain(plain, name);
      inner_->topics();
    } catch (const InputError&) {
      if (fault.empty()) throw;
      throw InputError(message("{}: is compressed with zstd, and damaged ({}); expected a whole file: copy it again.",
                               name, at_most(fault, 80)));
    }
  }

  std::vector<BagTopic> topics() override { return inner_->topics(); }
  void read(const Wanted& wanted, const Take& take, std::vector<Message>& lost) override {
    if (!lost_.empty()) lost.push_back(lost_);
    inner_->read(wanted, take, lost);
  }

 private:
  TemporaryFolder folder_;
  Message lost_;
  std::unique_ptr<BagFile> inner_;
};

std::unique_ptr<BagFile> open_file(const fs::path& file) {
  const std::string name = shown_path(file.filename());
  if (file.extension() == ".zstd") return std::make_unique<DecompressedBag>(file, name);
  return open_plain(file, name);
}

std::vector<BagTopic> topics_of(const std::vector<std::unique_ptr<BagFile>>& files) {
  std::map<std::string, BagTopic> all;
  for (const auto& file : files)
    for (BagTopic& topic : file->topics()) {
      const auto [place, is_new] = all.emplace(topic.name, topic);
      if (!is_new) place->second.messages += topic.messages;
    }
  std::vector<BagTopic> list;
  for (auto& [name, topic] : all) list.push_back(std::move(topic));
  return list;
}

/// Messages may be compressed one by one, which nothing of the topic tells: neither CDR nor ROS 1's images of joints
/// begin so.
void take_plain(const BagTopic& topic, std::int64_t nanoseconds, std::string_view bytes, const BagFile::Take& take,
                std::size_t& damaged) {
  constexpr std::size_t most = 1u << 30;
  if (topic.encoding != "cdr" || !begins_as_zstd(bytes)) return take(topic, nanoseconds, bytes);
  const Decompressed plain = decompressed(Compression::zstd, bytes, most);
  if (plain.fault.empty())
    take(topic, nanoseconds, plain.bytes);
  else
    ++damaged;
}

}  // namespace

bool is_bag(const fs::path& path) {
  if (fs::is_directory(path)) return !files_of_bag(path).empty();
  return has_ending(path) || begins_as_bag(first_bytes(path));
}

Bag open_bag(const fs::path& path) {
  Bag bag;
  bag.name = shown_path(path.filename().empty() ? path.parent_path().filename() : path.filename());
  for (const fs::path& file : files_of_bag(path)) bag.files.push_back(open_file(file));
  bag.topics = topics_of(bag.files);
  return bag;
}

std::vector<Message> read_bag(const Bag& bag, const BagFile::Wanted& wanted, const BagFile::Take& take) {
  constexpr std::size_t most_reported = 5;
  std::vector<Message> lost;
  std::size_t damaged = 0;
  for (const auto& file : bag.files)
    file->read(
        wanted,
        [&](const BagTopic& topic, std::int64_t time, std::string_view bytes) {
          take_plain(topic, time, bytes, take, damaged);
        },
        lost);
  if (damaged > 0)
    lost.push_back(message("{}: {} messages whose compression is damaged are left out.", bag.name, damaged));
  if (lost.size() > most_reported) {
    const std::size_t more = lost.size() - most_reported;
    lost.resize(most_reported);
    lost.push_back(message("{}: {} more places are damaged.", bag.name, more));
  }
  return lost;
}

}  // namespace handsight
