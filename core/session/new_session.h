// SPDX-License-Identifier: Apache-2.0
// A new session from what a user has: folders of images or a table of poses, a URDF, joint angles, a calibration.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "session/find_images.h"
#include "session/session.h"

namespace handsight {

struct NewSession {
  std::filesystem::path folder;  // where the session is made; may be there, but without a session.xml
  std::string title;
  std::filesystem::path urdf;  // empty: no more is known of the robot than where its flange is (set_flange_poses)
  std::string tcp, mount;      // links
  bool mount_is_known = false;
  Rigid mount_from_sensor;  // where it is known
  Rig rig;                  // with image sizes; no camera: a sensor that tells poses
  int marker_count = 3;
  std::optional<Target> target;     // whose points are the markers
  std::vector<std::string> joints;  // the order of `positions`
  std::vector<Eigen::VectorXd> positions;
  std::vector<InstantImages> images;  // of cameras: one for each position, in the same order
  std::vector<Rigid> target_poses;    // of a sensor that tells poses: sensor_from_target, one for each position
};

/// A robot of which only the flange's pose is known, base_from_flange at each instant: its "joints" are those of
/// poses_robot. Links are "base" and "flange".
void set_flange_poses(NewSession& parts, const std::vector<Rigid>& flange_poses);

/// Writes the folder: the URDF and the images (copied where they lie elsewhere), session.xml last. An observation whose
/// pair is not whole has no images and is named in the notes; with a target, and with more than two cameras, the images
/// that are there count. InputError where something does not fit together, named before anything is written; the
/// session that is returned is the one that was read back.
Session make_session(const NewSession& parts, std::vector<Message>* notes = nullptr);

/// The path by which a session names a file: relative to its folder. Copied into `into` (in that folder) where it lies
/// elsewhere. InputError where it cannot be copied.
std::string bring_into(const std::filesystem::path& file, const std::filesystem::path& session_folder,
                       const std::filesystem::path& into);

/// Those of joint_names that the table's first line names, in its order; all of them where it names none (a table
/// without a header).
std::vector<std::string> joints_of_table(const std::filesystem::path& table, const Robot& robot);

}  // namespace handsight
