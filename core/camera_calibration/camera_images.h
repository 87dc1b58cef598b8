// SPDX-License-Identifier: Apache-2.0
// Which image is whose, and which were taken together: by folders and names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"

namespace handsight {

/// The images of one camera; `keys` tell the moments: equal keys of two cameras are one frame.
struct CameraImages {
  std::string name;
  std::vector<std::filesystem::path> files;
  std::vector<std::string> keys;
};

struct GroupedImages {
  std::vector<CameraImages> cameras;  // left before right, else by name
  std::vector<std::string> frames;    // keys, in order
  std::vector<Message> notes;         // sentences: what was taken for what, and what was left out
};

/// Folders, each a camera's own (or one with several cameras' images, or with folders of cameras), or files. In names
/// such as left07.png, cam0_000012.png, 000_right.jpg the number that changes most is the moment and the rest is the
/// camera. Images without a number are one camera's, in the order of their names. InputError where there is no image,
/// where two images are the same moment of one camera, or there are more than 8 cameras.
GroupedImages group_images(const std::vector<std::filesystem::path>& paths);

}  // namespace handsight
