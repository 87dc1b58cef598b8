// SPDX-License-Identifier: Apache-2.0
// One recording in the words of every kind of bag: writers of the tests' own, made from the formats' specifications.
#pragma once

#include <bzlib.h>
#include <lz4frame.h>
#include <sqlite3.h>
#include <zstd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/rigid.h"
#include "readers/bags/decompress.h"

namespace handsight::fixture {

/// The same numbers in CDR (ROS 2) or as ROS 1 packs them.
class MessageWriter {
 public:
  explicit MessageWriter(bool ros1) : ros1_(ros1) {
    if (!ros1) bytes_ = std::string("\0\1\0\0", 4);
  }

  template <class T>
  MessageWriter& number(T value) {
    while (!ros1_ && (bytes_.size() - 4) % sizeof(T)) bytes_ += '\0';
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    return *this;
  }
  MessageWriter& count(std::size_t n) { return number(static_cast<std::uint32_t>(n)); }
  MessageWriter& text(const std::string& t) {
    count(t.size() + (ros1_ ? 0 : 1));
    bytes_ += t;
    if (!ros1_) bytes_ += '\0';
    return *this;
  }
  MessageWriter& raw(const std::string& data) {
    count(data.size());
    bytes_ += data;
    return *this;
  }
  MessageWriter& list(const std::vector<double>& all) {
    count(all.size());
    return fixed(all);
  }
  MessageWriter& fixed(const std::vector<double>& all) {
    for (const double x : all) number(x);
    return *this;
  }
  MessageWriter& header(double stamp, const std::string& frame) {
    if (ros1_) count(7);
    const double seconds = std::floor(stamp);
    number(static_cast<std::int32_t>(seconds));
    number(static_cast<std::uint32_t>(std::llround(1e9 * (stamp - seconds))));
    return text(frame);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  bool ros1_;
};

struct RecordedMessage {
  int topic = 0;
  std::int64_t nanoseconds = 0;
  std::string bytes;
};

struct Recording {
  struct Topic {
    std::string name, package, type;
  };
  bool ros1 = false;  // how messages are serialised
  std::vector<Topic> topics;
  std::vector<RecordedMessage> messages;

  std::string type(int t) const {
    const Topic& topic = topics[static_cast<std::size_t>(t)];
    return topic.package + (ros1 ? "/" : "/msg/") + topic.type;
  }
};

inline std::vector<double> list_numbers(const Rigid& motion) {
  const Eigen::Quaterniond q(motion.rotation);
  const Vector3& t = motion.translation;
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

inline Rigid tag_at(int i) { return {rotation_from_rpy({0.1 * i, 0.2, -0.05 * i}), {0.1, 0.01 * i, 0.5}}; }

/// 40 readings of two joints 0.1 s apart, a tag in /tf, a PoseStamped, a camera's calibration and 4 grey images of it.
inline Recording small_recording(bool ros1) {
  Recording r;
  r.ros1 = ros1;
  r.topics = {{"/joint_states", "sensor_msgs", "JointState"},
              {"/tf", "tf2_msgs", "TFMessage"},
              {"/board", "geometry_msgs", "PoseStamped"},
              {"/camera/camera_info", "sensor_msgs", "CameraInfo"},
              {"/camera/image_raw", "sensor_msgs", "Image"},
              {"/robot_description", "std_msgs", "String"},
              {"/chatter", "std_msgs", "Int8"}};
  const auto add = [&](int topic, double time, const MessageWriter& message) {
    r.messages.push_back({topic, static_cast<std::int64_t>(std::llround(1e3 * time)) * 1000000, message.bytes()});
  };
  add(5, 999, MessageWriter(ros1).text("<robot/>"));
  for (int i = 0; i < 40; ++i) {
    const double t = 1000 + 0.1 * i;
    MessageWriter joints(ros1);
    joints.header(t, "").count(2).text("a").text("bb").list({0.01 * i, -0.5}).list({}).list({1, 2});
    add(0, t, joints);
    MessageWriter tf(ros1);
    tf.count(1).header(t, "camera").text("tag_7").fixed(list_numbers(tag_at(i)));
    add(1, t, tf);
    MessageWriter board(ros1);
    board.header(t, "camera").fixed(list_numbers(tag_at(40 - i)));
    add(2, t, board);
    add(6, t, MessageWriter(ros1).number(std::int8_t{3}));
    if (i % 10 != 0) continue;
    MessageWriter info(ros1);
    info.header(t, "camera").count(6).count(8).text("plumb_bob").list({-0.1, 0.01, 0, 0, 0});
    info.fixed({10, 0, 4, 0, 11, 3, 0, 0, 1}).fixed({1, 0, 0, 0, 1, 0, 0, 0, 1});
    info.fixed({10, 0, 4, 0, 0, 11, 3, 0, 0, 0, 1, 0}).count(0).count(0);
    add(3, t, info);
    MessageWriter image(ros1);
    image.header(t, "camera").count(6).count(8).text("mono8").number(std::uint8_t{0}).count(8);
    image.raw(std::string(48, static_cast<char>('a' + i / 10)));
    add(4, t, image);
  }
  return r;
}

// ---- Compression

inline std::string zstd_of(const std::string& bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
  return out;
}

inline std::string lz4_of(const std::string& bytes) {
  LZ4F_preferences_t wanted{};
  wanted.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
  std::string out(LZ4F_compressFrameBound(bytes.size(), &wanted), '\0');
  out.resize(LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), &wanted));
  return out;
}

inline std::string bz2_of(std::string bytes) {
  auto size = static_cast<unsigned>(bytes.size() + bytes.size() / 100 + 700);
  std::string out(size, '\0');
  BZ2_bzBuffToBuffCompress(out.data(), &size, bytes.data(), static_cast<unsigned>(bytes.size()), 9, 0, 0);
  out.resize(size);
  return out;
}

inline std::string compressed(const std::string& how, const std::string& bytes) {
  return how == "zstd" ? zstd_of(bytes) : how == "lz4" ? lz4_of(bytes) : how == "bz2" ? bz2_of(bytes) : bytes;
}

template <class T>
std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

inline std::string prefixed(const std::string& text) { return raw(static_cast<std::uint32_t>(text.size())) + text; }

inline void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

// ---- MCAP, version 0

struct McapStyle {
  std::string compression;  // of chunks
  bool chunked = true, summary = true, sums = true;
  std::size_t per_chunk = 30;  // messages
};

inline std::uint32_t crc_bit_by_bit(const std::string& bytes) {
  std::uint32_t sum = ~0u;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320u : 0u);
  }
  return ~sum;
}

inline std::string mcap_record(std::uint8_t opcode, const std::string& content) {
  return raw(opcode) + raw(static_cast<std::uint64_t>(content.size())) + content;
}

class McapWriter {
 public:
  McapWriter(const Recording& r, const McapStyle& style) : r_(r), style_(style) {
    out_ = magic() + mcap_record(1, prefixed(r.ros1 ? "ros1" : "ros2") + prefixed("handsight's tests"));
    if (!style.chunked) out_ += channels();
    for (std::size_t i = 0; i < r.messages.size(); i += style.per_chunk) write_some(i);
    out_ += mcap_record(15, raw(style.sums ? crc_bit_by_bit(out_) : 0u));
    end();
  }
  std::string bytes() const { return out_; }
  std::vector<std::uint64_t> chunks() const { return chunks_; }

 private:
  static std::string magic() { return "\x89MCAP0\r\n"; }

  std::string channels() const {
    std::string all;
    for (std::size_t t = 0; t < r_.topics.size(); ++t) {
      const auto id = static_cast<std::uint16_t>(t + 1);
      all += mcap_record(3, raw(id) + prefixed(r_.type(static_cast<int>(t))) +
                                prefixed(r_.ros1 ? "ros1msg" : "ros2msg") + prefixed("# the definition"));
      all += mcap_record(4, raw(static_cast<std::uint16_t>(10 * t)) + raw(id) + prefixed(r_.topics[t].name) +
                                prefixed(r_.ros1 ? "ros1" : "cdr") + prefixed(prefixed("k") + prefixed("v")));
    }
    return all;
  }

  void write_some(std::size_t first) {
    std::string records = style_.chunked && first == 0 ? channels() : "";
    std::map<std::uint16_t, std::string> indices;
    const std::size_t last = std::min(first + style_.per_chunk, r_.messages.size());
    for (std::size_t i = first; i < last; ++i) {
      const RecordedMessage& m = r_.messages[i];
      const auto channel = static_cast<std::uint16_t>(10 * m.topic);
      indices[channel] += raw(m.nanoseconds) + raw(static_cast<std::uint64_t>(records.size()));
      records += mcap_record(
          5, raw(channel) + raw(static_cast<std::uint32_t>(i)) + raw(m.nanoseconds) + raw(m.nanoseconds) + m.bytes);
      ++counts_[channel];
    }
    if (!style_.chunked) {
      out_ += records;
      return;
    }
    const std::string packed = compressed(style_.compression, records);
    const std::uint64_t at = out_.size();
    const std::string times = raw(r_.messages[first].nanoseconds) + raw(r_.messages[last - 1].nanoseconds);
    out_ += mcap_record(6, times + raw(static_cast<std::uint64_t>(records.size())) +
                               raw(style_.sums ? crc_bit_by_bit(records) : 0u) + prefixed(style_.compression) +
                               raw(static_cast<std::uint64_t>(packed.size())) + packed);
    const std::uint64_t length = out_.size() - at;
    std::string offsets;
    for (const auto& [channel, entries] : indices) {
      offsets += raw(channel) + raw(static_cast<std::uint64_t>(out_.size()));
      out_ += mcap_record(7, raw(channel) + prefixed(entries));
    }
    chunks_.push_back(at);
    index_ += mcap_record(8, times + raw(at) + raw(length) + prefixed(offsets) + raw(out_.size() - at - length) +
                                 prefixed(style_.compression) + raw(static_cast<std::uint64_t>(packed.size())) +
                                 raw(static_cast<std::uint64_t>(records.size())));
  }

  void end() {
    const std::uint64_t begin = out_.size();
    std::string counts;
    for (const auto& [channel, count] : counts_) counts += raw(channel) + raw(static_cast<std::uint64_t>(count));
    std::string summary;
    if (style_.summary)
      summary =
          channels() + index_ +
          mcap_record(11, raw(static_cast<std::uint64_t>(r_.messages.size())) +
                              raw(static_cast<std::uint16_t>(r_.topics.size())) +
                              raw(static_cast<std::uint32_t>(r_.topics.size())) + raw(0u) + raw(0u) +
                              raw(static_cast<std::uint32_t>(chunks_.size())) + raw(r_.messages.front().nanoseconds) +
                              raw(r_.messages.back().nanoseconds) + prefixed(counts));
    const std::string footer = std::string("\2") + raw(std::uint64_t{20}) +
                               raw(style_.summary ? begin : std::uint64_t{0}) + raw(std::uint64_t{0});
    out_ += summary + footer + raw(style_.sums && style_.summary ? crc_bit_by_bit(summary + footer) : 0u) + magic();
  }

  const Recording& r_;
  McapStyle style_;
  std::string out_, index_;
  std::map<std::uint16_t, int> counts_;
  std::vector<std::uint64_t> chunks_;
};

inline std::string mcap_of(const Recording& r, const McapStyle& style = {}) { return McapWriter(r, style).bytes(); }

// ---- ROS 1, bag version 2.0

inline std::string field(const std::string& name, const std::string& value) { return prefixed(name + "=" + value); }
inline std::string bag_record(const std::string& head, const std::string& data) {
  return prefixed(head) + prefixed(data);
}

inline std::string ros1_connections(const Recording& r) {
  std::string all;
  for (std::size_t t = 0; t < r.topics.size(); ++t)
    all += bag_record(
        field("op", "\7") + field("conn", raw(static_cast<std::uint32_t>(t))) + field("topic", r.topics[t].name),
        field("topic", r.topics[t].name) + field("type", r.type(static_cast<int>(t))) +
            field("md5sum", std::string(32, '0')) + field("message_definition", "int8 data = not it"));
  return all;
}

/// As `rosbag record` leaves it; never closed: without an index, as in .bag.active.
inline std::string ros1_bag_of(const Recording& r, const std::string& compression, bool closed = true,
                               std::size_t per_chunk = 30) {
  const auto head = [&](std::uint64_t index, std::uint32_t chunks) {
    std::string fields = field("op", "\3") + field("index_pos", raw(index)) +
                         field("conn_count", raw(static_cast<std::uint32_t>(closed ? r.topics.size() : 0))) +
                         field("chunk_count", raw(chunks));
    return "#ROSBAG V2.0\n" + bag_record(fields, std::string(4096 - 8 - fields.size(), ' '));
  };
  std::string out = head(0, 0), infos;
  std::uint32_t chunks = 0;
  for (std::size_t first = 0; first < r.messages.size(); first += per_chunk) {
    std::string records = first == 0 ? ros1_connections(r) : "";
    std::map<std::uint32_t, std::uint32_t> counts;
    std::map<std::uint32_t, std::string> indices;
    for (std::size_t i = first; i < std::min(first + per_chunk, r.messages.size()); ++i) {
      const RecordedMessage& m = r.messages[i];
      const auto connection = static_cast<std::uint32_t>(m.topic);
      const std::string time = raw(static_cast<std::uint32_t>(m.nanoseconds / 1000000000)) +
                               raw(static_cast<std::uint32_t>(m.nanoseconds % 1000000000));
      indices[connection] += time + raw(static_cast<std::uint32_t>(records.size()));
      ++counts[connection];
      records += bag_record(field("op", "\2") + field("conn", raw(connection)) + field("time", time), m.bytes);
    }
    std::string per_connection;
    for (const auto& [connection, count] : counts) per_connection += raw(connection) + raw(count);
    infos += bag_record(field("op", "\6") + field("ver", raw(1u)) +
                            field("chunk_pos", raw(static_cast<std::uint64_t>(out.size()))) +
                            field("start_time", raw(std::uint64_t{0})) + field("end_time", raw(std::uint64_t{0})) +
                            field("count", raw(static_cast<std::uint32_t>(counts.size()))),
                        per_connection);
    out += bag_record(field("op", "\5") + field("compression", compression) +
                          field("size", raw(static_cast<std::uint32_t>(records.size()))),
                      compressed(compression, records));
    for (const auto& [connection, entries] : indices)
      out += bag_record(field("op", "\4") + field("ver", raw(1u)) + field("conn", raw(connection)) +
                            field("count", raw(counts[connection])),
                        entries);
    ++chunks;
  }
  if (!closed) return out;
  const std::string whole_head = head(out.size(), chunks);
  return whole_head + out.substr(whole_head.size()) + ros1_connections(r) + infos;
}

// ---- sqlite3

inline void write_sqlite_bag(const std::filesystem::path& file, const Recording& r, bool zstd_messages = false) {
  std::filesystem::create_directories(file.parent_path());
  sqlite3* db = nullptr;
  if (sqlite3_open(file.c_str(), &db) != SQLITE_OK) throw std::runtime_error("no database");
  const auto run = [&](const std::string& sql) { sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr); };
  run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT "
      "NOT "
      "NULL, offered_qos_profiles TEXT NOT NULL)");
  run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB "
      "NOT "
      "NULL)");
  run("BEGIN");
  for (std::size_t t = 0; t < r.topics.size(); ++t)
    run("INSERT INTO topics VALUES(" + std::to_string(t) + ", '" + r.topics[t].name + "', '" +
        r.type(static_cast<int>(t)) + "', 'cdr', '')");
  for (const RecordedMessage& m : r.messages) {
    const std::string bytes = zstd_messages ? zstd_of(m.bytes) : m.bytes;
    sqlite3_stmt* s = nullptr;
    sqlite3_prepare_v2(db, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?1, ?2, ?3)", -1, &s, nullptr);
    sqlite3_bind_int(s, 1, m.topic);
    sqlite3_bind_int64(s, 2, m.nanoseconds);
    sqlite3_bind_blob(s, 3, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
    sqlite3_step(s);
    sqlite3_finalize(s);
  }
  run("COMMIT");
  sqlite3_close(db);
}

}  // namespace handsight::fixture
