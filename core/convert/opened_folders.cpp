// SPDX-License-Identifier: Apache-2.0
#include "convert/opened_folders.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "convert/file_kind.h"
#include "convert/sample_folders.h"
#include "readers/bags/bag.h"
#include "readers/pose_matrices.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// What file_kind knows as a whole.
bool is_one_thing(const fs::path& folder) {
  return is_bag(folder) || fs::exists(folder / "session.xml") || has_images(folder) || !pose_files_in(folder).empty();
}

/// Files and the folders that are one thing, by name.
std::vector<fs::path> contents_of(const fs::path& folder) {
  std::vector<fs::path> inside;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().starts_with(".")) continue;
    const bool is_folder = entry.is_directory(error);
    const bool is_to_read = is_folder ? is_one_thing(entry.path()) && !fs::exists(entry.path() / "session.xml")
                                      : entry.is_regular_file(error);
    if (is_to_read) inside.push_back(entry.path());
  }
  std::sort(inside.begin(), inside.end());
  return inside;
}

bool is_known(const fs::path& file, const Robot* robot) {
  try {
    file_kind(file, robot);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

OpenedFolders opened_folders(const std::vector<fs::path>& named) {
  OpenedFolders opened;
  std::error_code error;
  for (const fs::path& path : named) {
    if (fs::is_directory(path, error) && !is_one_thing(path)) refuse_sample_folders(path);
    const auto inside =
        fs::is_directory(path, error) && !is_one_thing(path) ? contents_of(path) : std::vector<fs::path>{};
    if (inside.empty()) opened.files.push_back(path);
    opened.files.insert(opened.files.end(), inside.begin(), inside.end());
    opened.found.insert(opened.found.end(), inside.begin(), inside.end());
  }
  return opened;
}

void leave_out_unknown(std::vector<fs::path>& files, const std::vector<fs::path>& found, const Robot* robot,
                       std::vector<Message>& notes) {
  std::string left_out;
  std::erase_if(files, [&](const fs::path& file) {
    if (std::find(found.begin(), found.end(), file) == found.end() || is_known(file, robot)) return false;
    left_out += (left_out.empty() ? "" : ", ") + shown_path(file.filename());
    return true;
  });
  if (!left_out.empty()) notes.push_back(message("Left out, as nothing that is read: {}.", shortened(left_out, 200)));
}

}  // namespace handsight
