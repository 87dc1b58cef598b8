// SPDX-License-Identifier: Apache-2.0
#include "readers/ros_bag.h"

#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <memory>

#include "base/error.h"
#include "base/text.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(sqlite3* db) const { sqlite3_close(db); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, Close>;
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw InputError(
      fmt::format("{}: is no ROS 2 bag in sqlite3 that can be read: {}; write it again with `ros2 bag "
                  "convert` (storage sqlite3, no compression).",
                  shown_path(file), shortened(why, 200)));
}

std::vector<fs::path> files_of_bag(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path, error))
    if (entry.path().extension() == ".db3") files.push_back(entry.path());
  // bag_2.db3 stands before bag_10.db3
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    const std::string left = a.filename().string(), right = b.filename().string();
    return left.size() != right.size() ? left.size() < right.size() : left < right;
  });
  return files;
}

Database opened(const fs::path& file) {
  sqlite3* raw = nullptr;
  // A bag may lie where nothing can be written, and nobody else writes a finished one.
  const std::string uri = "file:" + fs::absolute(file).string() + "?immutable=1";
  const int status = fs::absolute(file).string().find_first_of("?#%") == std::string::npos
                         ? sqlite3_open_v2(uri.c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr)
                         : sqlite3_open_v2(file.c_str(), &raw, SQLITE_OPEN_READONLY, nullptr);
  Database db(raw);
  if (status != SQLITE_OK) fail(file, raw ? sqlite3_errmsg(raw) : "it cannot be opened");
  return db;
}

Statement prepared(const Database& db, const fs::path& file, const char* sql) {
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v2(db.get(), sql, -1, &raw, nullptr) != SQLITE_OK) fail(file, sqlite3_errmsg(db.get()));
  return Statement(raw);
}

/// True while there is a row.
bool step(const Statement& statement, const Database& db, const fs::path& file) {
  const int status = sqlite3_step(statement.get());
  if (status != SQLITE_ROW && status != SQLITE_DONE) fail(file, sqlite3_errmsg(db.get()));
  return status == SQLITE_ROW;
}

std::string text_of(const Statement& statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), column));
  return text ? text : "";
}

}  // namespace

bool is_bag(const fs::path& path) {
  if (!fs::is_directory(path)) return path.extension() == ".db3";
  return !files_of_bag(path).empty();
}

std::vector<BagTopic> bag_topics(const fs::path& path) {
  std::map<std::string, BagTopic> all;
  for (const fs::path& file : files_of_bag(path)) {
    const Database db = opened(file);
    const Statement rows = prepared(db, file,
                                    "SELECT name, type, serialization_format, (SELECT COUNT(*) FROM messages WHERE "
                                    "topic_id = topics.id) FROM topics");
    while (step(rows, db, file)) {
      if (text_of(rows, 2) != "cdr") fail(file, "topic " + text_of(rows, 0) + " is serialised as " + text_of(rows, 2));
      BagTopic& topic = all[text_of(rows, 0)];
      topic.name = text_of(rows, 0);
      topic.type = text_of(rows, 1);
      topic.messages += sqlite3_column_int64(rows.get(), 3);
    }
  }
  std::vector<BagTopic> list;
  for (auto& [name, topic] : all) list.push_back(std::move(topic));
  return list;
}

void read_bag(const fs::path& path, const std::string& topic,
              const std::function<void(std::int64_t, std::string_view)>& take) {
  for (const fs::path& file : files_of_bag(path)) {
    const Database db = opened(file);
    const Statement rows = prepared(db, file,
                                    "SELECT timestamp, data FROM messages WHERE topic_id IN (SELECT id FROM topics "
                                    "WHERE name = ?1) ORDER BY timestamp, id");
    sqlite3_bind_text(rows.get(), 1, topic.c_str(), -1, SQLITE_TRANSIENT);
    while (step(rows, db, file))
      take(sqlite3_column_int64(rows.get(), 0), {static_cast<const char*>(sqlite3_column_blob(rows.get(), 1)),
                                                 static_cast<std::size_t>(sqlite3_column_bytes(rows.get(), 1))});
  }
}

}  // namespace handsight
