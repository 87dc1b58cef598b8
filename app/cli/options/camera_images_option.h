// SPDX-License-Identifier: Apache-2.0
// Images of a board beside a session: what they say of its cameras.
#pragma once

#include <memory>

#include "base/message.h"
#include "camera/camera_knowledge.h"
#include "printing/json_values.h"
#include "printing/outputs.h"
#include "session/session.h"
#include "target_option.h"

namespace handsight::cli {

struct CameraImagesOptions {
  std::vector<std::string> images;
  TargetOptions target;
};

/// --camera-images FOLDER... and --target, what they show (else the session's own target).
void add_camera_images_options(const CommandLine& command, CameraImagesOptions& options);

/// Null where no images are named; InputError where they are not of the session's cameras. What was taken for what is
/// told once they are of use, in `notes`.
std::shared_ptr<const CameraKnowledge> find_camera_images(const CameraImagesOptions& options, const Session& session,
                                                          std::vector<Message>& notes);

/// How far the rig of a fit is from what the images say, in lines and as JSON.
void print_camera_images(const Output& output, const CameraKnowledge& knowledge, const Rig& fitted);
Json camera_images_json(const CameraKnowledge& knowledge, const Rig& fitted);

}  // namespace handsight::cli
