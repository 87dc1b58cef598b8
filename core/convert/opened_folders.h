// SPDX-License-Identifier: Apache-2.0
// A folder that holds a recording whole: its files and folders in its place.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"
#include "robot/robot.h"

namespace handsight {

/// Files as they were named, and those of folders that are neither of images, of poses nor a bag.
struct OpenedFolders {
  std::vector<std::filesystem::path> files;
  std::vector<std::filesystem::path> found;  // those of `files` that nobody named
};
OpenedFolders opened_folders(const std::vector<std::filesystem::path>& named);

/// Takes out of `files` what was found, not named, and is nothing that is read (a README, a program); says so.
/// `robot` null: none is known.
void leave_out_unknown(std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& found,
                       const Robot* robot, std::vector<Message>& notes);

}  // namespace handsight
