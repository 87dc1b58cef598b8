// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QCryptographicHash>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

namespace handsight::app {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

std::string hash(const std::string& bytes) {
  return QCryptographicHash::hash(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())),
                                  QCryptographicHash::Sha256)
      .toHex()
      .left(32)
      .toStdString();
}

std::string find_line(const JournalEntry& entry) {
  switch (entry.kind) {
    case JournalEntry::Kind::done:
      return "do " + edit_text(entry.edit);
    case JournalEntry::Kind::undone:
      return "undo";
    case JournalEntry::Kind::redone:
      return "redo";
    case JournalEntry::Kind::saved:
      return "saved " + entry.digest;
  }
  return {};
}

std::optional<JournalEntry> parse_line(const std::string& line, const Session* session) {
  JournalEntry entry;
  if (line == "undo") {
    entry.kind = JournalEntry::Kind::undone;
  } else if (line == "redo") {
    entry.kind = JournalEntry::Kind::redone;
  } else if (line.starts_with("saved ")) {
    entry.kind = JournalEntry::Kind::saved;
    entry.digest = line.substr(6);
  } else if (line.starts_with("do ")) {
    entry.edit = parse_edit(line.substr(3), session);
  } else {
    return std::nullopt;
  }
  return entry;
}

/// The whole lines of the text; what follows the last line end was cut off by a kill.
std::vector<std::string> whole_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  return lines;
}

struct Read {
  std::string base;  // digest of the session file that the entries start from
  std::vector<JournalEntry> entries;
  std::size_t good_bytes = 0;
  std::size_t not_understood = 0;  // whole lines from the first one that this version cannot read
  bool is_foreign = false;         // not a journal of this version at all
};

Read read_entries(const std::string& text, const Session* session) {
  Read read;
  const std::vector<std::string> lines = whole_lines(text);
  read.is_foreign = !lines.empty() && !lines[0].starts_with("handsight journal 1 ");
  if (lines.empty() || read.is_foreign) return read;
  read.base = lines[0].substr(20, 32);
  read.good_bytes = lines[0].size() + 1;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    try {
      const auto entry = parse_line(lines[i], session);
      if (!entry) break;
      read.entries.push_back(*entry);
    } catch (const InputError&) {
      break;
    }
    read.good_bytes += lines[i].size() + 1;
  }
  read.not_understood = lines.size() - 1 - read.entries.size();
  return read;
}

}  // namespace

fs::path state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && fs::path(state).is_absolute()) return fs::path(state) / "handsight";
  const char* home = std::getenv("HOME");
  return fs::path(home ? home : "/tmp") / ".local" / "state" / "handsight";
}

std::string compute_digest(const std::string& bytes) { return hash(bytes); }

Journal::Journal(const fs::path& session_file, const std::string& digest, const Session* session)
    : session_file_(fs::weakly_canonical(session_file)) {
  const fs::path folder = state_folder() / "journals";
  std::error_code error;
  fs::create_directories(folder, error);
  file_ = folder / (hash(session_file_.string()) + ".journal");
  open_.descriptor = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (open_.descriptor < 0)
    throw InputError(
        message("{}: the journal of this session cannot be written ({}); make its folder writable or "
                "set XDG_STATE_HOME to another.",
                shown_path(file_), system_text(errno)));
  if (::flock(open_.descriptor, LOCK_EX | LOCK_NB) != 0)
    throw InputError(message("{}: the session is open in another window of Handsight; work there or close it.",
                             shown_path(session_file_)));
  recover(digest, session);
}

Journal::File::~File() {
  if (descriptor >= 0) ::close(descriptor);
}

/// A copy beside the journal, under a name that is not taken by another one.
fs::path Journal::set_aside(const std::string& text, const std::string& why) const {
  fs::path aside = file_.string() + "." + hash(text).substr(0, 8) + ".aside";
  try {
    replace_file(aside, text);
  } catch (const InputError&) {
    throw InputError(
        message("{}: {}, and it cannot be set aside in {}; make room there, or move the journal away yourself.",
                shown_path(file_), why, shown_path(aside)));
  }
  return aside;
}

void Journal::recover(const std::string& digest, const Session* session) {
  const std::string text = read_file(file_);
  Read read = read_entries(text, session);
  if (read.is_foreign) {
    const fs::path aside = set_aside(text, "the journal is of another version of Handsight");
    contents_.notice = fmt::format(
        "The journal of this session is of another version of Handsight and was left unread; it is kept in {}.",
        shown_path(aside));
    return start(digest);
  }
  bool matches = read.base == digest;
  for (std::size_t i = read.entries.size(); i-- > 0 && contents_.in_file == 0;)
    if (read.entries[i].kind == JournalEntry::Kind::saved && read.entries[i].digest == digest) {
      contents_.in_file = i + 1;
      matches = true;
    }
  const bool is_whole = read.not_understood == 0;
  if (read.good_bytes == 0 || (!matches && read.entries.empty() && is_whole)) return start(digest);
  if (!matches) {
    const fs::path aside = set_aside(text, "session.xml was changed by another program");
    contents_ = {};
    if (is_whole) contents_.from_before = read.entries;
    contents_.kept_in = aside;
    contents_.notice =
        fmt::format("session.xml was changed by another program; {} unsaved actions from before that are kept in {}.",
                    read.entries.size() + read.not_understood, shown_path(aside));
    return start(digest);
  }
  if (!is_whole) {
    const fs::path aside = set_aside(text, "the journal has lines that this version does not understand");
    contents_.notice = fmt::format(
        "Line {} of the journal is no action that this version of Handsight understands: the {} before it are done, "
        "the "
        "{} from it on are not; the whole journal is kept in {}.",
        read.entries.size() + 2, read.entries.size(), read.not_understood, shown_path(aside));
  }
  if (::ftruncate(open_.descriptor, static_cast<off_t>(read.good_bytes)) != 0)
    throw InputError(message("{}: the journal cannot be repaired: {}.", shown_path(file_), system_text(errno)));
  contents_.entries = std::move(read.entries);
}

JournalContents Journal::take_contents() { return std::exchange(contents_, {}); }

void Journal::append(const JournalEntry& entry) { write_line(find_line(entry)); }

void Journal::clear(const std::string& digest) { start(digest); }

fs::path Journal::clear_and_keep(const std::string& digest) {
  fs::path kept = set_aside(read_file(file_), "session.xml was changed by another program");
  start(digest);
  return kept;
}

void Journal::start(const std::string& digest) {
  if (::ftruncate(open_.descriptor, 0) != 0)
    throw InputError(message("{}: the journal cannot be written: {}.", shown_path(file_), system_text(errno)));
  write_line("handsight journal 1 " + digest + " " + session_file_.string());
}

void Journal::write_line(const std::string& line) {
  const std::string text = line + "\n";
  const off_t before = ::lseek(open_.descriptor, 0, SEEK_END);
  const ssize_t written = ::write(open_.descriptor, text.data(), text.size());
  if (written == static_cast<ssize_t>(text.size()) && ::fdatasync(open_.descriptor) == 0) return;
  const int error = written < 0 || written == static_cast<ssize_t>(text.size()) ? errno : ENOSPC;
  // Half a line would swallow the next one.
  const bool is_whole = before >= 0 && ::ftruncate(open_.descriptor, before) == 0;
  if (!is_whole && ::write(open_.descriptor, "\n", 1) != 1)
    throw InputError(
        message("{}: the last action could not be written down ({}), and half of it stands there; save "
                "the session and open it again.",
                shown_path(file_), system_text(error)));
  throw InputError(message("{}: the last action could not be written down ({}); make room and save the session.",
                           shown_path(file_), system_text(error)));
}

}  // namespace handsight::app
