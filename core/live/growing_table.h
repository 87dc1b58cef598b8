// SPDX-License-Identifier: Apache-2.0
// A table that is being written: its lines as they come to their end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "base/message.h"

namespace handsight {

/// Looks at the file again and again. Only lines that have come to their end are read, each once; where the writer has
/// begun again (the file is shorter, or what was read of it is other) all are read anew.
class GrowingTable {
 public:
  /// `unnamed`: the columns where the first line is of numbers; empty: the first line names them whatever it is.
  GrowingTable(std::filesystem::path file, std::vector<std::string> unnamed);

  using Cells = std::vector<std::string>;  // as many as columns
  struct News {
    bool is_anew = false;      // of what was read before nothing holds any more
    std::vector<Cells> lines;  // without cells where a line has not as many as there are columns: it is set aside
  };
  News read();
  void read_anew() { begin_again(); }

  std::string name() const { return file_.filename().string(); }
  bool is_there() const;
  bool has_columns() const { return !columns_.empty(); }
  bool has(const std::string& column) const;
  /// Empty where there is no such column.
  const std::string& cell(const Cells& cells, const std::string& column) const;

  /// A part of the table is not taken, until it is mended or the writer begins again.
  void set_aside(const Message& part, const Message& why);
  void mend(const Message& part) { set_aside_.erase(part.english()); }
  bool is_set_aside(const Message& part) const { return set_aside_.contains(part.english()); }
  /// What is not taken and why, a sentence each, as it came; and what came since this was asked last.
  std::vector<Message> all_set_aside() const;
  std::vector<Message> newly_set_aside();

 private:
  struct Aside {
    std::size_t order;
    Message sentence;
  };
  Message whole() const;
  void begin_again();
  bool has_changed();
  bool goes_on(std::ifstream& in) const;
  void take_line(const std::string& line, News& news);

  std::filesystem::path file_;
  std::vector<std::string> unnamed_, columns_;  // none: no first line yet
  std::uintmax_t read_ = 0;                     // bytes, up to a line's end
  std::string end_of_read_;                     // the last of these bytes
  std::uintmax_t size_ = 0;                     // at the look before
  std::filesystem::file_time_type written_;
  bool is_anew_ = false;
  std::map<std::string, Aside> set_aside_;  // by part, in English
  std::size_t asides_ = 0;
  std::vector<Message> newly_;
};

}  // namespace handsight
