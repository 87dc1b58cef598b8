// SPDX-License-Identifier: Apache-2.0
// collection.xml: several sessions of one robot, and what they share.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"

namespace handsight {

/// One <session> of a collection.
struct CollectionEntry {
  std::string folder;            // as the file says
  std::string title;             // title="", else the last part of the folder; unique
  std::string rig, body;         // JoinedMember's
  std::vector<std::string> own;  // effects ("joint_offset:arm_3") that are this session's though they are the robot's
};

struct Collection {
  std::filesystem::path file;
  std::string title;
  std::vector<CollectionEntry> entries;
  std::vector<Message> notes;  // what the reader ignored, a sentence each
};

/// Is the path a collection: a file of that kind, or a folder that holds a collection.xml and no session.xml?
bool is_collection(const std::filesystem::path& path);

/// Reads the file alone, or that of the folder. InputError where it is none, names no session, names one twice, or
/// names a folder that is neither inside the collection's folder nor beside it.
Collection read_collection(const std::filesystem::path& path);

/// The same of a text that stands, or will stand, in that file.
Collection parse_collection(const std::string& text, const std::filesystem::path& file);

/// The path of a session's folder as a collection in `file` names it. InputError where it is neither inside the
/// collection's folder nor beside it.
std::string folder_in_collection(const std::filesystem::path& session_folder, const std::filesystem::path& file);

/// Where the session of an entry lies.
std::filesystem::path find_folder(const Collection& collection, const CollectionEntry& entry);

/// The text of a collection's file; the order of the sessions is that of their parts.
std::string collection_text(const Collection& collection);

}  // namespace handsight
