// SPDX-License-Identifier: Apache-2.0
#include "live/growing_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <utility>

#include "base/text.h"
#include "readers/csv.h"
#include "readers/texts/cells.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t remembered = 256;  // bytes: some lines, by which a table is known again

std::vector<std::string> texts_of(const std::vector<std::string_view>& cells) {
  std::vector<std::string> texts;
  for (const std::string_view cell : cells) texts.emplace_back(unquoted(cell));
  return texts;
}

}  // namespace

GrowingTable::GrowingTable(fs::path file, std::vector<std::string> unnamed)
    : file_(std::move(file)), unnamed_(std::move(unnamed)) {}

bool GrowingTable::is_there() const {
  std::error_code error;
  return fs::exists(file_, error);
}

bool GrowingTable::has(const std::string& column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

const std::string& GrowingTable::cell(const Cells& cells, const std::string& column) const {
  static const std::string none;
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  return found == columns_.end() || cells.empty() ? none : cells[static_cast<std::size_t>(found - columns_.begin())];
}

void GrowingTable::set_aside(const Message& part, const Message& why) {
  Message sentence = message("{} is set aside: {}.", part, why);
  const auto known = set_aside_.find(part.english());
  if (known != set_aside_.end() && known->second.sentence == sentence) return;
  newly_.push_back(sentence);
  set_aside_[part.english()] = {asides_++, std::move(sentence)};
}

std::vector<Message> GrowingTable::all_set_aside() const {
  std::vector<const Aside*> in_order;
  for (const auto& [part, aside] : set_aside_) in_order.push_back(&aside);
  std::sort(in_order.begin(), in_order.end(), [](const Aside* a, const Aside* b) { return a->order < b->order; });
  std::vector<Message> sentences;
  for (const Aside* aside : in_order) sentences.push_back(aside->sentence);
  return sentences;
}

std::vector<Message> GrowingTable::newly_set_aside() { return std::exchange(newly_, {}); }

/// The part that is all of it.
Message GrowingTable::whole() const { return message("The file {}", name()); }

void GrowingTable::begin_again() {
  read_ = size_ = 0;
  end_of_read_.clear();
  columns_.clear();
  set_aside_.clear();
  is_anew_ = true;
}

bool GrowingTable::has_changed() {
  std::error_code error;
  const auto size = fs::file_size(file_, error);
  const auto written = error ? written_ : fs::last_write_time(file_, error);
  if (error && is_there())
    set_aside(whole(), "it is a pipe or a device, which may never end");  // a pipe would be waited at for ever
  if (error || (size == size_ && written == written_)) return false;
  // Of the same size, but written since: something in the middle may be other.
  if (size < read_ || size == size_) begin_again();
  size_ = size;
  written_ = written;
  return true;
}

/// Does the file still have, where reading ended, what it had?
bool GrowingTable::goes_on(std::ifstream& in) const {
  std::string there(end_of_read_.size(), '\0');
  in.seekg(static_cast<std::streamoff>(read_ - there.size()));
  in.read(there.data(), static_cast<std::streamsize>(there.size()));
  return in.good() && there == end_of_read_;
}

void GrowingTable::take_line(const std::string& line, News& news) {
  std::vector<std::string_view> cells = cells_of_line(line);
  if (cells.empty()) return;
  // Many programs end each line with a separator.
  if (cells.back().empty() && (columns_.empty() || cells.size() == columns_.size() + 1)) cells.pop_back();
  if (columns_.empty()) {
    const bool is_header = unnamed_.empty() || names_columns(cells);
    columns_ = is_header ? texts_of(cells) : unnamed_;
    if (is_header) return;
  }
  const bool is_whole = cells.size() == columns_.size();
  news.lines.push_back(is_whole ? texts_of(cells) : Cells{});
  if (!is_whole)
    set_aside(message("The line {} of {}", in_quotes(line, 80), name()),
              message("it has {} columns, expected {}", cells.size(), columns_.size()));
}

GrowingTable::News GrowingTable::read() {
  News news;
  if (has_changed()) {
    std::ifstream in(file_, std::ios::binary);
    if (!in) {
      set_aside(whole(), "it cannot be opened");
      size_ = std::numeric_limits<std::uintmax_t>::max();  // asked again at the next look
      return news;
    }
    mend(whole());
    if (!goes_on(in)) {
      const auto size = size_;
      begin_again();
      size_ = size;
      in.clear();
      in.seekg(0);
    }
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    text.resize(text.rfind('\n') + 1);                                           // npos + 1 is 0
    std::size_t begin = read_ == 0 && text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // spreadsheets' byte order mark
    while (begin < text.size()) {
      const std::size_t end = text.find('\n', begin);
      take_line(text.substr(begin, end - begin), news);
      begin = end + 1;
    }
    read_ += text.size();
    end_of_read_ += text;
    end_of_read_.erase(0, end_of_read_.size() - std::min(end_of_read_.size(), remembered));
  }
  news.is_anew = std::exchange(is_anew_, false);
  return news;
}

}  // namespace handsight
