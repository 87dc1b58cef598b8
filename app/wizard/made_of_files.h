// SPDX-License-Identifier: GPL-3.0-or-later
// What the files of the wizard become: a session, or a collection where a bag holds several sensors.
#pragma once

#include <filesystem>
#include <vector>

#include "convert/conversion.h"

namespace handsight::app {

struct MadeOfFiles {
  std::filesystem::path file;  // session.xml or collection.xml
  std::size_t sessions = 1, observations = 0;
  std::vector<Message> notes;
};

/// InputError; ConversionStopped. `is_mount_open`: nobody has chosen the mount in the options, so that of several
/// sensors each camera's frame may tell its own.
MadeOfFiles made_of_files(const std::vector<std::filesystem::path>& files, const ConvertOptions& options,
                          bool is_mount_open);

}  // namespace handsight::app
