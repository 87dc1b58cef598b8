// SPDX-License-Identifier: Apache-2.0
// Bags of ROS 2, written by hand: CDR messages in sqlite3.
#pragma once

#include <sqlite3.h>

#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "geometry/rigid.h"

namespace handsight::fixture {

/// Writes CDR, little endian or big, numbers at multiples of their size.
class CdrWriter {
 public:
  explicit CdrWriter(bool big = false) : big_(big) {
    bytes_ = std::string("\0", 1) + (big ? '\0' : '\1') + std::string(2, '\0');
  }

  template <class T>
  CdrWriter& number(T value) {
    while ((bytes_.size() - 4) % sizeof(T)) bytes_ += '\0';
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes_ += raw[big_ ? sizeof(T) - 1 - i : i];
    return *this;
  }
  CdrWriter& text(const std::string& t) {
    number(static_cast<std::uint32_t>(t.size() + 1));
    bytes_ += t + '\0';
    return *this;
  }
  CdrWriter& raw(const std::string& data) {
    number(static_cast<std::uint32_t>(data.size()));
    bytes_ += data;
    return *this;
  }
  CdrWriter& numbers(const std::vector<double>& all, bool with_count = true) {
    if (with_count) number(static_cast<std::uint32_t>(all.size()));
    for (const double x : all) number(x);
    return *this;
  }
  CdrWriter& header(double stamp, const std::string& frame) {
    const double seconds = std::floor(stamp);
    number(static_cast<std::int32_t>(seconds));
    number(static_cast<std::uint32_t>(std::llround(1e9 * (stamp - seconds)) % 1000000000));
    return text(frame);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  bool big_;
};

inline std::string joint_state(double stamp, const std::vector<std::string>& names, const std::vector<double>& position,
                               bool big = false) {
  CdrWriter w(big);
  w.header(stamp, "").number(static_cast<std::uint32_t>(names.size()));
  for (const std::string& n : names) w.text(n);
  return w.numbers(position).numbers({}).numbers({}).bytes();
}

inline std::string transform(double stamp, const std::string& parent, const std::string& child, const Rigid& motion) {
  const Eigen::Quaterniond q(motion.rotation);
  return CdrWriter()
      .number(std::uint32_t{1})
      .header(stamp, parent)
      .text(child)
      .numbers({motion.translation.x(), motion.translation.y(), motion.translation.z(), q.x(), q.y(), q.z(), q.w()},
               false)
      .bytes();
}

inline std::string camera_info(const Camera& c, const Matrix3& r, double p3, const std::string& frame = "camera") {
  CdrWriter w;
  w.header(5, frame).number(static_cast<std::uint32_t>(c.height)).number(static_cast<std::uint32_t>(c.width));
  w.text("plumb_bob").numbers({c.k1, c.k2, c.p1, c.p2, c.k3});
  w.numbers({c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1}, false);
  const Matrix3 by_rows = r.transpose();
  w.numbers({by_rows.data(), by_rows.data() + 9}, false).numbers({800, 0, 400, p3, 0, 800, 300, 0, 0, 0, 1, 0}, false);
  return w.number(std::uint32_t{0}).number(std::uint32_t{0}).bytes();
}

/// Of 8 x 6 pixels.
inline Camera small_camera() {
  Camera camera;
  camera.width = 8;
  camera.height = 6;
  camera.fx = camera.fy = 10;
  camera.cx = 4;
  camera.cy = 3;
  camera.k1 = -0.1;
  return camera;
}

/// An image of that size.
inline std::string small_image(double stamp, const std::string& encoding, std::uint32_t step) {
  return CdrWriter()
      .header(stamp, "left")
      .number(std::uint32_t{6})
      .number(std::uint32_t{8})
      .text(encoding)
      .number(std::uint8_t{0})
      .number(step)
      .raw(std::string(6 * step, 'x'))
      .bytes();
}

/// A folder with one .db3 as `ros2 bag record` leaves it.
class BagWriter {
 public:
  explicit BagWriter(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    if (sqlite3_open((folder / "bag_0.db3").c_str(), &db_) != SQLITE_OK) throw std::runtime_error("no database");
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT "
        "NOT NULL, offered_qos_profiles TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data "
        "BLOB "
        "NOT NULL)");
    run("BEGIN");
  }
  ~BagWriter() {
    run("COMMIT");
    sqlite3_close(db_);
  }
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  int topic(const std::string& name, const std::string& type) {
    run("INSERT INTO topics(name, type, serialization_format, offered_qos_profiles) VALUES('" + name + "', '" + type +
        "', 'cdr', '')");
    return static_cast<int>(sqlite3_last_insert_rowid(db_));
  }
  void message(int topic, double stamp, const std::string& bytes) {
    sqlite3_stmt* s = nullptr;
    sqlite3_prepare_v2(db_, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?1, ?2, ?3)", -1, &s, nullptr);
    sqlite3_bind_int(s, 1, topic);
    sqlite3_bind_int64(s, 2, static_cast<sqlite3_int64>(1e9 * stamp));
    sqlite3_bind_blob(s, 3, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
    sqlite3_step(s);
    sqlite3_finalize(s);
  }

 private:
  void run(const std::string& sql) { sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr); }
  sqlite3* db_ = nullptr;
};

}  // namespace handsight::fixture
