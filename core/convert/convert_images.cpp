// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/image_names.h"
#include "base/text.h"
#include "convert/choose_turns.h"
#include "convert/convert_inputs.h"
#include "convert/file_kind.h"
#include "convert/pair_poses.h"
#include "convert/shown_target.h"
#include "convert/turns_by_images.h"
#include "readers/stereo_calibration.h"
#include "vision/image/image_header.h"

namespace handsight {
namespace {

/// The size of a camera's first image.
std::optional<ImageSize> size_of_images(const std::vector<InstantImages>& instants, std::size_t camera) {
  for (const InstantImages& instant : instants)
    if (!instant.files[camera].empty()) return image_size(read_file(instant.files[camera]));
  return std::nullopt;
}

/// Instants and lines of joints or of flange poses, by count.
void match_images(const std::vector<InstantImages>& instants, std::size_t lines, const char* of_what, int cameras) {
  if (instants.size() == lines) return;
  throw InputError(message(
      "There are {} {} and {} {}; expected one for each, in the order of the images' numbers. The first has the number "
      "{}, the last {}.",
      instants.size(), cameras == 2 ? "pairs of images" : "instants with images", lines, of_what,
      instants.front().number, instants.back().number));
}

bool is_of_kalibr_ros_or_makers(const std::filesystem::path& file) {
  try {
    const FileKind kind = file_kind(file, nullptr);
    return kind == FileKind::camchain || is_one_camera(kind);
  } catch (const InputError&) {
    return false;  // the reader of OpenCV's says what is wrong with it
  }
}

/// The folder of each camera: by its name, of two by left and right, else as they were given.
std::vector<std::filesystem::path> folders_by_camera(const Rig& rig, std::vector<std::filesystem::path> folders) {
  if (rig.count() == 2 && folders.size() == 1) return {folders[0], folders[0]};
  if (static_cast<int>(folders.size()) != rig.count())
    throw InputError(
        message("There are {} folders of images and a calibration of {} cameras ({}); name one folder "
                "for each camera, in this order or with its name in the folder's.",
                folders.size(), rig.count(), listed_names(rig)));
  std::vector<std::filesystem::path> ordered;
  const std::vector<std::string> names = telling_names(folders);
  for (const RigCamera& camera : rig.cameras)
    for (std::size_t i = 0; i < folders.size(); ++i)
      if (says(names[i], {camera.name.c_str()})) ordered.push_back(folders[i]);
  std::vector<std::filesystem::path> once = ordered;
  std::sort(once.begin(), once.end());
  const bool each_once = ordered.size() == folders.size() && std::adjacent_find(once.begin(), once.end()) == once.end();
  return each_once ? ordered : folders;
}

}  // namespace

Rig rig_of_brought(const Brought& b) {
  if (b.rig) return *b.rig;
  if (b.cameras.size() == 1) return make_rig(b.cameras[0]);
  if (b.cameras.size() == 2) {
    const bool swapped = says(b.cameras[0].name + b.cameras[0].file, {"right"});
    return make_rig(make_rig(b.cameras[swapped ? 1 : 0], b.cameras[swapped ? 0 : 1]));
  }
  throw InputError(
      b.cameras.empty()
          ? Message("There are images, and no calibration of the cameras; name OpenCV's, Kalibr's or those of ROS, or "
                    "make one "
                    "with `handsight-cli cameras`.")
          : "Files of ROS do not say how more than two cameras lie to each other; name Kalibr's camchain, or make a "
            "calibration with `handsight-cli cameras`.");
}

Rig rig_of_files(const std::vector<std::filesystem::path>& files, std::vector<Message>& notes) {
  if (std::none_of(files.begin(), files.end(), is_of_kalibr_ros_or_makers)) return read_rig_calibration(files, &notes);
  const Brought b = bring(files, nullptr, false, {});
  notes.insert(notes.end(), b.notes.begin(), b.notes.end());
  return rig_of_brought(b);
}

void fit_to_first_images(Rig& rig, const std::vector<InstantImages>& images, std::vector<Message>& notes) {
  for (int c = 0; c < rig.count(); ++c)
    if (const auto size = size_of_images(images, static_cast<std::size_t>(c)))
      fit_to_images(rig.at(c), static_cast<int>(size->width), static_cast<int>(size->height), notes);
}

void require_target(const Rig& rig, const ConvertOptions& o, const std::vector<std::filesystem::path>& folders) {
  if (o.target || is_pair(rig)) return;
  if (static_cast<int>(folders.size()) == rig.count())
    if (const Message shown = shown_target_text(find_images(folders_by_camera(rig, folders))); !shown.empty())
      throw InputError(message("No target is named. {}", shown));
  throw InputError(
      message("With {} {} something must be shown whose points name themselves: say what with --target, for example "
              "\"charuco columns=8 rows=6 square=0.03 marker=0.022 dictionary=DICT_5X5_100\"; markers without names "
              "need two cameras.",
              rig.count(), rig.count() == 1 ? "camera" : "cameras"));
}

namespace {

/// Two cameras without a target: markers are looked for, whatever else the images show.
void say_what_is_shown(const Rig& rig, const ConvertOptions& o, const std::vector<InstantImages>& images,
                       std::vector<Message>& notes) {
  if (o.target || !is_pair(rig)) return;
  if (const Message shown = shown_target_text(images); !shown.empty())
    notes.push_back(message("No target is named: the session is one of markers without names. {}", shown));
}

}  // namespace

/// Cameras and images beside what the parts say of the robot.
Session with_images(const SessionParts& parts, const Brought& b, const ConvertOptions& o, std::vector<Message>& notes) {
  Rig rig = rig_of_brought(b);
  require_target(rig, o, b.image_folders);
  const std::vector<InstantImages> images = find_images(folders_by_camera(rig, b.image_folders));
  say_what_is_shown(rig, o, images, notes);
  match_images(images, parts.joints.positions.size(), "lines of joint readings", rig.count());
  fit_to_first_images(rig, images, notes);
  return write_camera_session(parts, rig, images, o, notes);
}

namespace {

/// By its folders; what it sees by the target's description.
void name_sensor(const Brought& b, const ConvertOptions& o, Conversion& c) {
  for (const std::filesystem::path& folder : b.image_folders)
    c.sensor += (c.sensor.empty() ? "" : ", ") + folder.lexically_normal().string();
  if (o.target) c.target = describe_target(*o.target);
}

}  // namespace

Conversion from_images(const FieldUrdf& robot, const Brought& b, const ConvertOptions& o, Conversion c) {
  if (!b.joints)
    throw InputError(
        "There are images, and no table of joint readings; name a CSV with a line for each instant, or leave the robot "
        "out and name a table of its flange's poses.");
  SessionParts parts;
  require_links(robot, o, parts, c.notes);
  parts.joints = *b.joints;
  parts.times = b.joints->times;
  name_sensor(b, o, c);
  c.session = with_images(parts, b, o, c.notes);
  return c;
}

Conversion from_flange_images(const Brought& b, const ConvertOptions& o, Conversion c) {
  NamedPoses flange = b.poses.front();
  Rig rig = rig_of_brought(b);
  require_target(rig, o, b.image_folders);
  std::vector<InstantImages> images = find_images(folders_by_camera(rig, b.image_folders));
  say_what_is_shown(rig, o, images, c.notes);
  pair_images(flange, images, rig.count(), o.pairing.lag, c.notes);
  fit_to_first_images(rig, images, c.notes);
  SessionParts parts;
  set_flange(parts, flange.series, !o.eye_on_base, c.notes);
  parts.times = flange.series.times;
  c.notes.push_back(message("{}: its poses are taken for base_from_flange; the camera is taken to be {}.",
                            b.poses.front().file,
                            o.eye_on_base ? "on a stand and the target on the flange"
                                          : "on the flange and the target beside the robot (--eye-on-base: the "
                                            "camera stands, the flange carries the target)"));
  name_sensor(b, o, c);
  c.session = write_camera_session(parts, rig, images, o, c.notes);
  if (is_open(flange)) choose_turns_by_images(flange, !o.eye_on_base, c);
  return c;
}

}  // namespace handsight
