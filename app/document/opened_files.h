// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a document is made of: a session's, or a collection's with those of its sessions.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "session/collection.h"
#include "session/joined.h"

namespace handsight::app {

/// As they were read, or last written.
struct OpenedFiles {
  std::filesystem::path file;            // session.xml, or the collection's
  std::optional<Collection> collection;  // absent: one session by itself
  std::vector<JoinedMember> members;     // of a collection, in its order

  bool is_collection() const { return collection.has_value(); }
};

/// A session and its files. InputError where they cannot be read, or the sessions not be joined.
struct OpenedSession {
  OpenedFiles files;
  Session session;
};
OpenedSession open_files(const std::filesystem::path& path);

/// What the files hold now, in one text that differs where one of them does.
std::string make_content(const OpenedFiles& files);

/// The collection as its file says it now, or would: what of it can change in the window.
std::string shared_text(const OpenedFiles& files);

/// The same sessions with the labels and decisions that the joined session has of them.
std::vector<JoinedMember> members_with(const OpenedFiles& files, const Session& joined);

/// Another collection in the same file, of sessions of which some are known already (or none: `files` without
/// members); those that are new are read.
/// InputError where they cannot be read or joined.
OpenedSession rejoined(const OpenedFiles& files, const Session& joined, const std::string& collection_text);

/// A file and what is to stand in it.
struct FileText {
  std::filesystem::path file;
  std::string text;
};

/// What a save writes: the sessions that have changed, and the collection where it has.
struct SavedFiles {
  OpenedFiles files;            // as they then are
  std::vector<FileText> texts;  // to be written
  std::string content;          // make_content once they are
};
SavedFiles saved_files(const OpenedFiles& files, const Session& joined, bool is_collection_changed);

/// Writes them, each whole or not at all. InputError where one cannot be written.
void write_files(const SavedFiles& saved);

}  // namespace handsight::app
