// SPDX-License-Identifier: Apache-2.0
#include "convert/brought.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "convert/recorder_columns.h"
#include "readers/kalibr_target.h"
#include "readers/maker_cameras.h"
#include "readers/mocap_csv.h"
#include "readers/pose_matrices.h"
#include "readers/stereo_calibration.h"
#include "robot/robot.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// What is read when all files are known.
struct Waiting {
  std::vector<fs::path> storages;
  std::map<fs::path, std::vector<fs::path>> single_poses;  // by their folder
};

void add_poses(std::vector<ReadPoses> read, const std::string& file, Brought& b) {
  for (ReadPoses& one : read)
    b.poses.push_back({file, std::move(one.role), std::move(one.series), std::move(one.turns)});
}

void require_new(bool is_new, const std::string& file, FileKind kind) {
  if (!is_new)
    throw InputError(message("{} is {}, and another file is one too; name one of them.", file, kind_text(kind)));
}

void bring_poses(const fs::path& path, const std::string& file, const Robot* robot, const PoseTableOptions& o,
                 Brought& b) {
  if (fs::is_directory(path)) return add_poses(read_pose_files(pose_files_in(path), file, b.notes), file, b);
  const std::string text = read_file(path);
  if (is_storage_text(text)) {
    add_poses(poses_of_storage(text, file, b.notes), file, b);
  } else if (looks_like_yaml(text) || first_line(text).starts_with("{")) {
    add_poses(read_pose_list(parse_yaml(text, file), file, b.notes), file, b);
  } else {
    const Table table = *parse_recorded_table(text, file, robot ? joint_names(*robot) : std::vector<std::string>());
    b.notes.insert(b.notes.end(), table.notes.begin(), table.notes.end());
    add_poses(read_pose_table(table, robot != nullptr, o, b.notes), file, b);
  }
}

void bring_table(const fs::path& path, const std::string& file, FileKind kind, const Robot* robot, bool degrees,
                 Brought& b) {
  Table table = *parse_recorded_table(read_file(path), file, robot ? joint_names(*robot) : std::vector<std::string>());
  b.notes.insert(b.notes.end(), table.notes.begin(), table.notes.end());
  if (kind == FileKind::joints) {
    require_new(!b.joints, file, kind);
    if (!b.servos.empty()) set_radians(table, b.servos, std::exchange(degrees, false), b.notes);
    b.joints = read_joint_table(std::move(table), *robot, degrees, b.notes);
  } else {
    require_new(!b.points, file, kind);
    b.points = read_point_table(std::move(table), b.notes);
  }
}

void bring_mocap(const fs::path& path, const std::string& file, const PoseTableOptions& o, Brought& b) {
  const std::string text = read_file(path);
  MocapTables all = is_motive_csv(text) ? read_motive_csv(text, file) : read_vicon_csv(text, file);
  b.notes.insert(b.notes.end(), all.notes.begin(), all.notes.end());
  for (const MocapBody& body : all.bodies) {
    auto read = read_pose_table(body.table, true, o, b.notes);
    for (ReadPoses& one : read) one.role = "mocap " + body.name;
    add_poses(std::move(read), file, b);
  }
  if (all.markers.columns.empty()) return;
  require_new(!b.points, file, FileKind::points);
  b.points = read_point_table(std::move(all.markers), b.notes);
}

RosCamera camera_of_yaml(const YAML::Node& yaml, const std::string& file) {
  return is_camera_info(yaml) ? read_camera_info(yaml, file) : read_echoed_camera_info(yaml, file);
}

void bring_cameras(const fs::path& path, const std::string& file, FileKind kind, Brought& b) {
  const std::string text = read_file(path);
  if (kind == FileKind::ost) {
    for (RosCamera& camera : read_ost(text, file)) b.cameras.push_back(std::move(camera));
  } else if (kind == FileKind::camodocal) {
    b.cameras.push_back(read_camodocal(text, file));
  } else if (kind == FileKind::camera_info) {
    b.cameras.push_back(camera_of_yaml(parse_yaml(text, file), file));
  } else if (is_realsense_listing(text)) {
    b.cameras.push_back(read_realsense_listing(text, file, b.notes));
  } else {
    b.cameras.push_back(read_realsense(parse_yaml(text, file), file, b.notes));
  }
}

void bring_one(const fs::path& path, const std::string& file, FileKind kind, const Robot* robot,
               const PoseTableOptions& o, Brought& b, Waiting& waiting) {
  switch (kind) {
    case FileKind::robot:
      throw InputError(message("{}: is a second robot; name one URDF, with --robot or among the files.", file));
    case FileKind::images:
      b.image_folders.push_back(path);
      if (const auto poses = pose_files_in(path); poses.size() > 2) waiting.single_poses[path] = poses;
      return;
    case FileKind::storage:
      waiting.storages.push_back(path);
      return;
    case FileKind::bag:
      require_new(b.bag.empty(), file, kind);
      b.bag = path;
      return;
    case FileKind::camchain:
      require_new(!b.rig, file, kind);
      b.rig = read_camchain(parse_yaml(read_file(path), file), file, b.notes);
      return;
    case FileKind::camera_info:
    case FileKind::ost:
    case FileKind::realsense:
    case FileKind::camodocal:
      return bring_cameras(path, file, kind, b);
    case FileKind::target:
      require_new(!b.target, file, kind);
      b.target = read_kalibr_target(parse_yaml(read_file(path), file), file);
      b.notes.push_back(message("{}: {}.", file, describe_target(*b.target)));
      return;
    case FileKind::samples:
      require_new(!b.samples, file, kind);
      b.samples = read_hand_eye_samples(parse_yaml(read_file(path), file), file, b.notes);
      return;
    case FileKind::poses:
      return bring_poses(path, file, robot, o, b);
    case FileKind::servos:
      return;  // known before any table is read
    case FileKind::mocap:
      return bring_mocap(path, file, o, b);
    case FileKind::pose:
      waiting.single_poses[path.parent_path()].push_back(path);
      return;
    case FileKind::joints:
    case FileKind::points:
      return bring_table(path, file, kind, robot, o.degrees, b);
  }
}

}  // namespace

Brought bring(const std::vector<fs::path>& files, const Robot* robot, bool degrees, const std::string& angles) {
  Brought b;
  Waiting waiting;
  if (!angles.empty()) named_angle_kind(angles);  // refused before anything is read
  std::vector<FileKind> kinds;
  for (const fs::path& path : files) {
    kinds.push_back(file_kind(path, robot));
    const std::string name = shown_path(path.filename());
    if (kinds.back() == FileKind::servos) b.servos = read_lerobot_calibration(parse_yaml(read_file(path), name), name);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path& path = files[i];
    const FileKind kind = kinds[i];
    const std::string file = shown_path(path.filename().empty() ? path.parent_path().filename() : path.filename());
    if (kind != FileKind::pose) b.took.push_back(message("{}: {}", file, kind_text(kind)));
    bring_one(path, file, kind, robot, {angles, degrees}, b, waiting);
  }
  for (const auto& [folder, poses] : waiting.single_poses) {
    b.took.push_back(message("{}: {} files with a pose each", shown_path(folder.filename()), poses.size()));
    add_poses(read_pose_files(poses, shown_path(folder.filename()), b.notes), shown_path(folder.filename()), b);
  }
  if (!angles.empty() &&
      std::none_of(b.poses.begin(), b.poses.end(), [](const auto& p) { return p.turns.is_reported; }))
    throw InputError(message("--angles {}: no table of poses here has {} numbers for a turn; leave it out.", angles,
                             angle_count(named_angle_kind(angles).kind)));
  if (!waiting.storages.empty()) b.rig = read_rig_calibration(waiting.storages, &b.notes);
  return b;
}

const PoseSeries& settled_series(const NamedPoses& poses) {
  if (poses.turns.readings.size() > 1 && !poses.turns.first_is_usual)
    throw InputError(message(
        "{}: {} may be {}, or {}; name the columns roll pitch yaw or rvx rvy rvz, with their "
        "unit ([deg]).",
        poses.file, poses.turns.columns, reading_text(poses.turns.readings[0]), reading_text(poses.turns.readings[1])));
  return poses.series;
}

}  // namespace handsight
