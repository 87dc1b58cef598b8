// SPDX-License-Identifier: Apache-2.0
#include "camera_images_option.h"

#include <cmath>

#include "base/error.h"
#include "camera_calibration/board_knowledge.h"
#include "command.h"

namespace handsight::cli {

void add_camera_images_options(const CommandLine& command, CameraImagesOptions& options) {
  command.option("--camera-images", options.images,
                 "Images of a board by the session's cameras: what they say of the cameras counts too; a folder a "
                 "camera, or files");
  add_target_options(command, options.target, true);
}

std::shared_ptr<const CameraKnowledge> find_camera_images(const CameraImagesOptions& options, const Session& session,
                                                          std::vector<Message>& notes) {
  if (options.images.empty()) {
    if (is_given(options.target))
      throw InputError("--target says what --camera-images show, and there are none; name them, or leave it out.");
    return nullptr;
  }
  if (!session.rig)
    throw InputError(message("{}: has no cameras of which --camera-images could say something; leave them out.",
                             session.file.filename().string()));
  if (!is_given(options.target) && !session.target)
    throw InputError(
        "The session has no target; say with --target what --camera-images show, for example \"charuco "
        "columns=8 rows=6 square=0.03 marker=0.022 dictionary=DICT_5X5_100\".");
  const Target target = is_given(options.target) ? target_from(options.target) : *session.target;
  const GroupedImages grouped = group_by_cameras(
      group_images(std::vector<std::filesystem::path>(options.images.begin(), options.images.end())), *session.rig);
  std::size_t count = 0;
  for (const CameraImages& camera : grouped.cameras) {
    count += camera.files.size();
    for (const auto& file : camera.files) note_input(file);
  }
  notes = grouped.notes;
  Progress progress("board images", count);
  const DetectedImages detected = detect_in_images(grouped, target, [&](std::size_t at) { progress.at(at); });
  return std::make_shared<const CameraKnowledge>(board_knowledge(detected, *session.rig));
}

namespace {

/// Chi-squared of so many numbers is hardly ever so large.
bool is_far(const CameraKnowledge& k, double chi_squared) {
  return chi_squared > k.numbers + 5 * std::sqrt(2.0 * k.numbers);
}

}  // namespace

void print_camera_images(const Output& output, const CameraKnowledge& k, const Rig& fitted) {
  const double chi_squared = disagreement(k, fitted);
  output.line(
      fmt::format("Camera images: {} points in {} images, rms {:.3f} px; the model's cameras are {:.1f} sigma "
                  "from what they say (rms over {} numbers)",
                  k.points, k.images, k.rms_pixel, std::sqrt(chi_squared / k.numbers), k.numbers));
  if (is_far(k, chi_squared))
    output.line(
        fmt::format("! The board images do not agree with the session on its cameras: let more of their numbers "
                    "move (--effects camera_intrinsics lens_distortion{}), or they are of another camera or focus.",
                    fitted.count() == 1 ? ""
                    : is_pair(fitted)   ? " stereo_rig"
                                        : " rig"));
}

Json camera_images_json(const CameraKnowledge& k, const Rig& fitted) {
  const double chi_squared = disagreement(k, fitted);
  return {{"images", k.images},
          {"points", k.points},
          {"rms_pixel", number(k.rms_pixel)},
          {"chi_squared", number(chi_squared)},
          {"numbers", k.numbers},
          {"agree", !is_far(k, chi_squared)}};
}

}  // namespace handsight::cli
