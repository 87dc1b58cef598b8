// SPDX-License-Identifier: Apache-2.0
// Which files in folders are the images of one instant, by their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/message.h"

namespace handsight {

/// The two images of one instant; one may be missing (empty).
struct ImageFiles {
  std::int64_t number = 0;  // the date and time, else the last number, in the files' names
  std::filesystem::path left, right;
};

/// Pairs the images of two folders by the date and time, else the last number, in their names, ascending. With both
/// folders the same, names tell the sides apart: "left" or "right" in them, else a last letter l or r. InputError where
/// there is no image, or a side has a number twice. Names that begin with a dot are those of files that are still
/// written.
std::vector<ImageFiles> find_image_pairs(const std::filesystem::path& left_folder,
                                         const std::filesystem::path& right_folder);

/// The images of one instant by camera; missing ones are empty.
struct InstantImages {
  std::int64_t number = 0;  // the date and time, else the last number, in the files' names
  std::vector<std::filesystem::path> files;
};

std::vector<InstantImages> list_instants(const std::vector<ImageFiles>& pairs);

/// The images of each camera's folder, by the date and time, else the last number, in their names, ascending; two
/// folders as `find_image_pairs` has it. InputError where a folder has no image or a number twice.
std::vector<InstantImages> find_images(const std::vector<std::filesystem::path>& folders);

/// The same by the cameras' names, which may end in a number of their own: it is not the instant's. Where cameras share
/// a folder, the camera's name must be in the file's, whatever the case (of two in it the one that the other is part
/// of); of two cameras the sides will do, too. What find_images refuses is reported in `refusals`, and leaves out no
/// more than a number that is there twice; a file that is old gives way to one that is not.
using IsOldImage = std::function<bool(std::size_t camera, const std::filesystem::path& file)>;
std::vector<InstantImages> find_camera_folders(const std::vector<std::string>& cameras,
                                               const std::vector<std::filesystem::path>& folders,
                                               const IsOldImage& is_old, std::vector<Message>& refusals);

}  // namespace handsight
