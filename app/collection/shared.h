// SPDX-License-Identifier: GPL-3.0-or-later
// What two sessions of a collection share, told and changed.
#pragma once

#include "session/collection.h"

namespace handsight::app {

struct Shared {
  bool rig = false;   // the same cameras or tracker at the same place
  bool body = false;  // the same markers or board on the same TCP

  bool operator==(const Shared&) const = default;
};

/// Of two entries, by their places.
Shared shared_by(const Collection& collection, std::size_t entry, std::size_t with);

/// The collection in which they share this. Others that shared with `with` go on; `entry` leaves what it shared
/// otherwise where it shares with `with` instead, or no longer.
Collection with_shared(Collection collection, std::size_t entry, std::size_t with, const Shared& shared);

/// The collection with one more session, its folder as the collection's file names it, its title unique.
Collection with_session(Collection collection, const std::string& folder, const std::string& title);

/// The folder of a session's path: its session.xml, or the folder itself.
std::filesystem::path session_folder(const std::filesystem::path& path);

/// The folder that holds both: where a collection of two can be written.
std::filesystem::path common_folder(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace handsight::app
