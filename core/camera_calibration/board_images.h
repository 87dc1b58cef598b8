// SPDX-License-Identifier: Apache-2.0
// From image files to the points that a bundle is adjusted to.
#pragma once

#include <functional>

#include "base/message.h"
#include "camera_calibration/bundle_parts.h"
#include "camera_calibration/camera_images.h"
#include "print/target.h"

namespace handsight {

/// What became of one image.
struct ReadImage {
  int camera = 0, frame = 0;
  std::filesystem::path file;
  int points = 0, dropped = 0;  // seen; left out because they did not agree with the rest
  Message reason;               // why there are none
  std::vector<int> repeated;    // numbers of single tags that are there several times, which are left out
};

struct DetectedImages {
  BoardImages board;
  std::vector<std::pair<int, int>> sizes;  // px, of each camera's images
  std::vector<std::string> names;
  std::vector<ReadImage> images;
};

/// Finds the target in every image. A set of single tags has a frame for each tag and moment, since where the tags are
/// to each other is not known. InputError where an image cannot be read or has another size than the camera's others.
/// `progress` hears how many images are done.
DetectedImages detect_in_images(const GroupedImages& grouped, const Target& target,
                                const std::function<void(std::size_t)>& progress = {});

/// What the images show where hardly one of them shows the target; empty where most do, and where nothing can be said.
/// With the words of the options that say it.
Message shown_in_its_place(const DetectedImages& detected, const Target& target);

}  // namespace handsight
