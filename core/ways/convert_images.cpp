// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "vision/image_header.h"
#include "ways/convert_ways.h"

namespace handsight {
namespace {

/// The size of the first image of a folder.
std::optional<ImageSize> size_of_images(const std::vector<ImageFiles>& pairs) {
  for (const ImageFiles& pair : pairs)
    if (!pair.left.empty()) return image_size(read_file(pair.left));
  return std::nullopt;
}

/// Pairs and joint lines, by count or by the images' numbers.
void match_images(std::vector<ImageFiles>& pairs, const JointSeries& joints) {
  if (pairs.size() == joints.positions.size()) return;
  throw InputError(
      fmt::format("There are {} pairs of images and {} lines of joint readings; expected one line for each "
                  "pair, in the order of the images' numbers. The first pair has the number {}, the last {}.",
                  pairs.size(), joints.positions.size(), pairs.front().number, pairs.back().number));
}

StereoRig rig_of_brought(const Brought& b) {
  if (b.rig) return *b.rig;
  if (b.cameras.size() == 2) {
    const bool swapped = says(b.cameras[0].name + b.cameras[0].file, {"right"});
    return rig_of(b.cameras[swapped ? 1 : 0], b.cameras[swapped ? 0 : 1]);
  }
  throw InputError(
      b.cameras.empty()
          ? "There are images, and no calibration of the two cameras; name OpenCV's, Kalibr's or two of ROS."
          : "There is a calibration of one camera alone; a session with images needs two cameras and the way "
            "from one to the other.");
}

}  // namespace

void fit_to_first_image(StereoRig& rig, const std::vector<ImageFiles>& images, std::vector<std::string>& notes) {
  if (const auto size = size_of_images(images))
    fit_to_images(rig, static_cast<int>(size->width), static_cast<int>(size->height), notes);
}

Conversion from_images(const FieldUrdf& robot, const Brought& b, const ConvertOptions& o, Conversion c) {
  if (b.image_folders.size() > 2)
    throw InputError("There are more than two folders of images; name the left one and the right one.");
  if (!b.joints)
    throw InputError("There are images, and no table of joint readings; name a CSV with a line for each pair.");
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  const bool swapped = b.image_folders.size() == 2 && says(b.image_folders[0].filename().string(), {"right"});
  std::vector<ImageFiles> pairs =
      find_image_pairs(b.image_folders[swapped ? 1 : 0],
                       b.image_folders.size() == 2 ? b.image_folders[swapped ? 0 : 1] : b.image_folders[0]);
  match_images(pairs, *b.joints);
  StereoRig rig = rig_of_brought(b);
  fit_to_first_image(rig, pairs, c.notes);
  parts.joints = *b.joints;
  parts.times = b.joints->times;
  c.session = write_stereo_session(parts, rig, pairs, o, c.notes);
  return c;
}

}  // namespace handsight
