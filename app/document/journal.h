// SPDX-License-Identifier: GPL-3.0-or-later
// Every action is written down before it is shown, so that a kill at any moment loses at most the last one. The
// journal of a session lies in the user's state folder ($XDG_STATE_HOME/handsight, else ~/.local/state/handsight), one
// file a session; session.xml changes only when the user saves.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "document/edit.h"

namespace handsight::app {

/// One line of a journal.
struct JournalEntry {
  enum class Kind { done, undone, redone, saved };
  Kind kind = Kind::done;
  Edit edit;           // of `done`
  std::string digest;  // of `saved`: that of session.xml as it was then written
};

/// What a journal held when it was opened.
struct JournalContents {
  std::vector<JournalEntry> entries;
  std::size_t in_file = 0;  // entries that session.xml already holds: those up to the last `saved` with its digest
  std::string notice;       // a sentence for the user; empty: nothing to say
  /// Of a journal made for another content of the file: its entries, and the copy in which they are kept.
  std::vector<JournalEntry> from_before;
  std::filesystem::path kept_in;
};

/// $XDG_STATE_HOME/handsight, else ~/.local/state/handsight.
std::filesystem::path state_folder();

/// A short fingerprint of a file's bytes.
std::string compute_digest(const std::string& bytes);

class Journal {
 public:
  /// Opens (or makes) the journal of a session file whose content has this digest. Entries made for another content,
  /// and everything from a line on that this version does not understand, are set aside under another name, and the
  /// notice says where. InputError where another window has it open, or where it (or what is to be set aside) cannot be
  /// written: nothing of it is touched then.
  /// `session`: for effects by formula.
  Journal(const std::filesystem::path& session_file, const std::string& digest, const Session* session = nullptr);
  ~Journal() = default;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// What was there; empty after the first call.
  JournalContents take_contents();

  /// Appends one entry; it is on the disk when this returns. InputError where it is not.
  void append(const JournalEntry& entry);

  /// Starts anew for this content of the session file: nothing is left to recover.
  void clear(const std::string& digest);
  /// The same, with what stands in it now kept beside it; where.
  std::filesystem::path clear_and_keep(const std::string& digest);

  const std::filesystem::path& file() const { return file_; }

 private:
  void write_line(const std::string& line);
  void start(const std::string& digest);
  void recover(const std::string& digest, const Session* session);
  std::filesystem::path set_aside(const std::string& text, const std::string& why) const;

  /// An open file, closed (and with it unlocked) whatever happens.
  struct File {
    File() = default;
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    int descriptor = -1;
  };

  std::filesystem::path session_file_;
  std::filesystem::path file_;
  File open_;
  JournalContents contents_;
};

}  // namespace handsight::app
