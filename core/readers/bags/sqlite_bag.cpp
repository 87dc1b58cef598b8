// SPDX-License-Identifier: Apache-2.0
// Bags of ROS 2 in sqlite3, one .db3.
#include <sqlite3.h>

#include <map>

#include "base/error.h"
#include "base/text.h"
#include "readers/bags/bag.h"
#include "readers/bags/messages.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(sqlite3* db) const { sqlite3_close(db); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, Close>;
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

std::string make_text(const Statement& statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), column));
  return text ? text : "";
}

class SqliteBag : public BagFile {
 public:
  SqliteBag(const fs::path& file, std::string name) : name_(std::move(name)) {
    sqlite3* raw = nullptr;
    // A bag may lie where nothing can be written, and nobody else writes a finished one.
    const std::string path = fs::absolute(file).string(), uri = "file:" + path + "?immutable=1";
    const int status = path.find_first_of("?#%") == std::string::npos
                           ? sqlite3_open_v2(uri.c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr)
                           : sqlite3_open_v2(file.c_str(), &raw, SQLITE_OPEN_READONLY, nullptr);
    db_.reset(raw);
    if (status != SQLITE_OK) fail(raw ? verbatim(sqlite3_errmsg(raw)) : "it cannot be opened");
    find_topics();
  }

  std::vector<BagTopic> topics() override {
    std::vector<BagTopic> all;
    for (const auto& [id, topic] : topics_) all.push_back(topic);
    return all;
  }

  void read(const Wanted& wanted, const Take& take, std::vector<Message>& lost) override {
    std::string ids;
    for (const auto& [id, topic] : topics_)
      if (wanted(topic)) ids += (ids.empty() ? "" : ", ") + std::to_string(id);
    if (ids.empty()) return;
    const Statement rows = prepared(
        ("SELECT topic_id, timestamp, data FROM messages WHERE topic_id IN (" + ids + ") ORDER BY timestamp, id")
            .c_str());
    std::int64_t taken = 0;
    for (int status; (status = sqlite3_step(rows.get())) != SQLITE_DONE; ++taken) {
      if (status != SQLITE_ROW)
        return lost.push_back(message("{}: is damaged ({}): after {} messages the rest is lost.", name_,
                                      shortened(sqlite3_errmsg(db_.get()), 80), taken));
      take(topics_.at(sqlite3_column_int64(rows.get(), 0)), sqlite3_column_int64(rows.get(), 1),
           {static_cast<const char*>(sqlite3_column_blob(rows.get(), 2)),
            static_cast<std::size_t>(sqlite3_column_bytes(rows.get(), 2))});
    }
  }

 private:
  [[noreturn]] void fail(const Message& why) const {
    throw InputError(
        message("{}: is no ROS 2 bag in sqlite3 that can be read: {}; expected what `ros2 bag record` "
                "writes: copy it again, or write it anew with `ros2 bag convert`.",
                name_, at_most(why, 200)));
  }

  Statement prepared(const char* sql) const {
    sqlite3_stmt* raw = nullptr;
    if (sqlite3_prepare_v2(db_.get(), sql, -1, &raw, nullptr) != SQLITE_OK) fail(verbatim(sqlite3_errmsg(db_.get())));
    return Statement(raw);
  }

  void find_topics() {
    const Statement rows = prepared(
        "SELECT id, name, type, serialization_format, (SELECT COUNT(*) FROM messages WHERE topic_id = topics.id) FROM "
        "topics");
    for (int status; (status = sqlite3_step(rows.get())) != SQLITE_DONE;) {
      if (status != SQLITE_ROW) fail(verbatim(sqlite3_errmsg(db_.get())));
      topics_[sqlite3_column_int64(rows.get(), 0)] = {
          shortened(make_text(rows, 1), longest_topic), ros::find_type(make_text(rows, 2)),
          shortened(make_text(rows, 3), 20), sqlite3_column_int64(rows.get(), 4)};
    }
  }

  std::string name_;
  Database db_;
  std::map<std::int64_t, BagTopic> topics_;
};

}  // namespace

std::unique_ptr<BagFile> open_sqlite_bag(const fs::path& file, const std::string& name) {
  return std::make_unique<SqliteBag>(file, name);
}

}  // namespace handsight
