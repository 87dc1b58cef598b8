// SPDX-License-Identifier: Apache-2.0
// Bags of ROS 1, version 2.0 (https://wiki.ros.org/Bags/Format/2.0): from front to end, chunk by chunk, so that a bag
// that was never closed (.bag.active) or lost its index is read as far as it goes.
#include <algorithm>
#include <map>
#include <optional>

#include "base/error.h"
#include "base/text.h"
#include "readers/bags/bag.h"
#include "readers/bags/decompress.h"
#include "readers/bags/file_bytes.h"
#include "readers/bags/messages.h"

namespace handsight {
namespace {

enum Op : std::uint8_t { op_message = 2, op_bag = 3, op_index = 4, op_chunk = 5, op_chunk_info = 6, op_connection = 7 };
constexpr std::uint64_t magic_size = 13, largest_record = 1u << 30;

/// The fields "name=value" of a record's head.
std::map<std::string, std::string_view, std::less<>> fields_of(std::string_view head) {
  std::map<std::string, std::string_view, std::less<>> all;
  Fields list(head);
  while (list.more()) {
    const std::string_view field = list.text();
    const std::size_t sign = field.find('=');
    if (sign != std::string_view::npos) all[std::string(field.substr(0, sign))] = field.substr(sign + 1);
  }
  return all;
}

struct Record {
  std::map<std::string, std::string_view, std::less<>> head;
  std::string_view data;

  /// A number of the head; `missing` where there is none of this size.
  template <class T>
  T number(const char* name, T missing = 0) const {
    const auto found = head.find(name);
    return found == head.end() || found->second.size() != sizeof(T) ? missing : Fields(found->second).number<T>();
  }
  std::uint8_t op() const { return number<std::uint8_t>("op"); }
  std::string text(const char* name) const {
    const auto found = head.find(name);
    return found == head.end() ? std::string() : std::string(found->second);
  }
};

std::optional<Record> next_record(Fields& list) {
  Record record;
  record.head = fields_of(list.text());
  record.data = list.text();
  if (list.ended) return std::nullopt;
  return record;
}

/// ns, of seconds and nanoseconds in 32 bit each.
std::int64_t nanoseconds_of(const Record& record) {
  const auto raw = record.number<std::uint64_t>("time");
  return static_cast<std::int64_t>(raw & 0xFFFFFFFFu) * 1000000000 + static_cast<std::int64_t>(raw >> 32);
}

std::optional<Compression> compression_of(const std::string& name) {
  if (name == "none") return Compression::none;
  if (name == "bz2") return Compression::bz2;
  if (name == "lz4") return Compression::lz4;
  return std::nullopt;
}

class Ros1Bag : public BagFile {
 public:
  Ros1Bag(const std::filesystem::path& file, std::string name) : name_(std::move(name)), file_(file) {
    if (!take_index()) count_messages();
    if (topics_.empty())
      throw InputError(
          message("{}: is a bag of ROS 1 without a connection: nothing was recorded, or it is damaged; expected a bag "
                  "with messages: record it again, or try `rosbag reindex`.",
                  name_));
  }

  std::vector<BagTopic> topics() override {
    std::vector<BagTopic> list;  // several nodes may publish one topic
    for (const auto& [connection, topic] : topics_) list.push_back(topic);
    return list;
  }

  void read(const Wanted& wanted, const Take& take, std::vector<handsight::Message>& lost) override {
    wanted_ = wanted;
    take_ = take;
    lost_ = &lost;
    walk();
  }

 private:
  /// Connections and the messages of each, from the end of a bag that was closed.
  bool take_index() {
    const std::optional<Record> bag = record_at(magic_size);
    if (!bag || bag->op() != op_bag) return false;
    if (const std::string by = bag->text("encryptor"); !by.empty())
      throw InputError(message("{}: is encrypted ({}); expected one that is not: `rosbag decrypt` of ROS writes it.",
                               name_, in_quotes(by)));
    std::uint64_t at = bag->number<std::uint64_t>("index_pos");
    const auto connections = bag->number<std::uint32_t>("conn_count"),
               chunks = bag->number<std::uint32_t>("chunk_count");
    if (at < magic_size || at >= file_.size()) return false;
    while (const std::optional<Record> record = record_at(at)) {
      if (record->op() == op_connection) take_connection(*record);
      if (record->op() == op_chunk_info) take_chunk_info(*record);
      at += size_of_record(at);
    }
    return topics_.size() == connections && chunks_.size() == chunks;
  }

  void take_connection(const Record& record) {
    const auto about = fields_of(record.data);
    const auto type = about.find("type");
    const auto id = record.number<std::uint32_t>("conn", ~0u);
    if (id == ~0u || type == about.end()) return;
    topics_.emplace(id, BagTopic{shortened(record.text("topic"), longest_topic), ros::find_type(type->second), "ros1"});
  }

  void take_chunk_info(const Record& record) {
    chunks_.push_back(record.number<std::uint64_t>("chunk_pos"));
    Fields counts(record.data);
    while (counts.more()) {
      const auto connection = topics_.find(counts.number<std::uint32_t>());
      const auto count = counts.number<std::uint32_t>();
      if (connection != topics_.end()) connection->second.messages += count;
    }
  }

  void count_messages() {
    std::vector<handsight::Message> lost;
    lost_ = &lost;
    is_counted_ = true;
    for (auto& [id, topic] : topics_) topic.messages = 0;
    walk();
    is_counted_ = false;
  }

  std::uint64_t size_of_record(std::uint64_t at) {
    const std::uint64_t head = Fields(file_.view(at, 4)).number<std::uint32_t>();
    return 8 + head + Fields(file_.view(at + 4 + head, 4)).number<std::uint32_t>();
  }

  /// Nothing where the file ends before the record does.
  std::optional<Record> record_at(std::uint64_t at) {
    if (at + 8 > file_.size()) return std::nullopt;
    const std::uint64_t size = size_of_record(at);
    if (size > file_.size() - at || size > largest_record + (1u << 20)) return std::nullopt;
    Fields bytes(file_.view(at, size));
    return next_record(bytes);
  }

  void walk() {
    taken_ = nameless_ = 0;
    std::uint64_t at = magic_size;
    while (at != 0 && at < file_.size()) {
      const std::optional<Record> record = record_at(at);
      const std::uint64_t size = size_of_record(at);
      if (!record || record->op() < op_message || record->op() > op_connection) {
        at = after_damage(at);
        continue;
      }
      if (record->op() == op_chunk_info) break;  // what follows is the index
      take_record(*record, at);
      at += size;
    }
    if (nameless_ > 0)
      lost_->push_back(
          message("{}: {} messages are of connections that are described nowhere and are left out.", name_, nameless_));
  }

  void take_record(const Record& record, std::uint64_t at) {
    if (record.op() == op_connection) take_connection(record);
    if (record.op() == op_message) take_message(record);
    if (record.op() == op_chunk) take_chunk(record, at);
  }

  void take_message(const Record& record) {
    const auto connection = topics_.find(record.number<std::uint32_t>("conn", ~0u));
    if (connection == topics_.end()) {
      ++nameless_;
      return;
    }
    ++taken_;
    if (is_counted_)
      ++connection->second.messages;
    else if (wanted_(connection->second))
      take_(connection->second, nanoseconds_of(record), record.data);
  }

  void take_chunk(const Record& chunk, std::uint64_t at) {
    const std::string name = chunk.text("compression");
    const auto compression = compression_of(name);
    if (!compression)
      return lose_chunk(at, message("it is compressed with {}, which is not read", in_quotes(name, 20)));
    const auto size = chunk.number<std::uint32_t>("size");
    if (size > largest_record) return lose_chunk(at, "it says that it is larger than 1 GiB");
    const Decompressed plain = decompressed(*compression, chunk.data, size);
    if (!plain.fault.empty()) return lose_chunk(at, plain.fault);
    if (plain.bytes.size() != size) return lose_chunk(at, "it holds less than it says");
    Fields list(plain.bytes);
    while (list.more()) {
      const auto record = next_record(list);
      if (!record) return lose_chunk(at, "a record in it is damaged; what stands before it is read");
      if (record->op() != op_chunk) take_record(*record, at);
    }
  }

  void lose_chunk(std::uint64_t at, const handsight::Message& why) {
    lost_->push_back(message("{}: the chunk at byte {} is left out: {}.", name_, at, at_most(why, 100)));
  }

  /// Where to go on, 0: nowhere.
  std::uint64_t after_damage(std::uint64_t at) {
    const auto next = std::upper_bound(chunks_.begin(), chunks_.end(), at);
    if (next != chunks_.end() && *next < file_.size()) {
      lost_->push_back(
          message("{}: is damaged at byte {}: {} bytes up to the next chunk are left out.", name_, at, *next - at));
      return *next;
    }
    lost_->push_back(message("{}: it is broken off or damaged at byte {} of {}: after {} messages the rest is lost.",
                             name_, at, file_.size(), taken_));
    return 0;
  }

  std::string name_;
  FileBytes file_;
  std::map<std::uint32_t, BagTopic> topics_;  // by connection
  std::vector<std::uint64_t> chunks_;         // where they begin, in order
  Wanted wanted_;
  Take take_;
  std::vector<handsight::Message>* lost_ = nullptr;
  bool is_counted_ = false;  // they are only counted
  std::uint64_t taken_ = 0, nameless_ = 0;
};

}  // namespace

std::unique_ptr<BagFile> open_ros1_bag(const std::filesystem::path& file, const std::string& name) {
  return std::make_unique<Ros1Bag>(file, name);
}

}  // namespace handsight
