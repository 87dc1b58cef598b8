// SPDX-License-Identifier: Apache-2.0
// Files that a user brings, each recognised by its content.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "convert/file_kind.h"
#include "print/target.h"
#include "readers/camera_files.h"
#include "readers/pose_files.h"
#include "readers/pose_table.h"
#include "readers/robots/lerobot.h"

namespace handsight {

struct NamedPoses {
  std::string file;
  std::string role;  // what the file calls them ("effector_wrt_world"); empty: nothing
  PoseSeries series;
  Turns turns = {};  // what their turns may be read as; empty: nothing is open
};

/// Everything that was brought.
struct Brought {
  std::optional<JointSeries> joints;
  std::vector<NamedPoses> poses;
  std::optional<PointSeries> points;
  std::vector<double> markers;  // whose point each line of joint readings is measured with; empty: nobody says
  std::optional<HandEyeSamples> samples;
  std::optional<Rig> rig;
  std::vector<RosCamera> cameras;
  std::vector<std::filesystem::path> image_folders;
  std::filesystem::path bag;
  std::optional<Target> target;
  std::vector<Servo> servos;                      // what the readings of joints mean
  std::vector<Message> took, notes;               // what each was taken for; what else is to be said
  std::map<FileKind, std::string> first_of_kind;  // files, by what they were taken for
  Message unnamed_columns;                        // of a table without a header: what it has; empty: there is none
};

/// Reads all files; `robot` null: none was named. `columns` are the names of those of a table without a header
/// (parse_measured_table). InputError where one is wrong, or two say the same.
Brought bring(const std::vector<std::filesystem::path>& files, const Robot* robot, bool degrees,
              const std::string& angles = {}, const std::vector<std::string>& columns = {});

/// Which of two series is the flange's, which the target's: by what their files or columns call them. InputError where
/// these do not say.
std::pair<NamedPoses, NamedPoses> flange_and_target(const std::vector<NamedPoses>& poses);

/// The poses where nothing about them is open. InputError where their angles may be read in several ways.
const PoseSeries& settled_series(const NamedPoses& poses);

/// The cameras of a calibration: OpenCV's (one or several files), Kalibr's camchain, camodocal's or RealSense's camera,
/// or those of one or two cameras of ROS. InputError where they make no rig.
Rig rig_of_files(const std::vector<std::filesystem::path>& files, std::vector<Message>& notes);

/// The same of what was brought.
Rig rig_of_brought(const Brought& brought);

}  // namespace handsight
