// SPDX-License-Identifier: Apache-2.0
#include "convert/brought.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "readers/pose_matrices.h"
#include "readers/ros_bag.h"
#include "readers/stereo_calibration.h"
#include "session/new_session.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

std::string_view first_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    if (!line.empty() && line.front() != '#' && line != "---") return line;
  }
  return {};
}

/// "name: value", "name:" or "- value": no table begins so.
bool looks_like_yaml(std::string_view text) {
  const std::string_view line = first_line(text);
  return line.starts_with("- ") || line.starts_with("[") || line.ends_with(":") ||
         (line.find(": ") != std::string_view::npos && line.find_first_of(",;\t") == std::string_view::npos) ||
         (line.find(": ") != std::string_view::npos && line.find('[') != std::string_view::npos);
}

std::vector<std::string> names_of(const Robot* robot) {
  return robot ? joint_names(*robot) : std::vector<std::string>();
}

/// What OpenCV's FileStorage writes.
bool is_storage_text(const std::string& text) {
  return first_line(text).starts_with("%YAML") || text.find("!!opencv-matrix") != std::string::npos ||
         text.find("<opencv_storage") != std::string::npos;
}

/// A storage of poses, not of cameras.
FileKind storage_kind(const fs::path& path, const std::string& text) {
  std::vector<std::string> notes;
  const bool has_poses =
      text.find("amera") == std::string::npos && !poses_of_storage(text, shown_path(path.filename()), notes).empty();
  return has_poses ? FileKind::poses : FileKind::storage;
}

/// JSON: a list of poses, or a storage of OpenCV.
FileKind json_kind(const std::string& text) {
  try {
    return is_pose_list(parse_yaml(text, "")) ? FileKind::poses : FileKind::storage;
  } catch (const InputError&) {
    return FileKind::storage;
  }
}

bool has_number(const fs::path& path) {
  const std::string stem = path.stem().string();
  return stem.find_first_of("0123456789") != std::string::npos;
}

[[noreturn]] void refuse_kind(const fs::path& path, const std::string& looks_like) {
  throw InputError(fmt::format(
      "{}: {}; expected a URDF, a folder of images, a table (CSV) of joints, poses or points, a calibration of OpenCV, "
      "ROS or Kalibr, samples of easy_handeye, or a ROS 2 bag in sqlite3.",
      shown_path(path), looks_like));
}

FileKind xml_kind(const fs::path& path, const std::string& text) {
  if (text.find("<robot") != std::string::npos) return FileKind::robot;
  if (text.find("<opencv_storage") != std::string::npos) return storage_kind(path, text);
  if (text.find("<handsight_session") != std::string::npos) refuse_kind(path, "is a session already, use it as it is");
  if (text.find("<sdf") != std::string::npos) refuse_kind(path, "is an SDF of Gazebo; name the URDF of the robot");
  if (text.find("<mujoco") != std::string::npos) refuse_kind(path, "is a MuJoCo model; name the URDF of the robot");
  refuse_kind(path, "is XML of a kind that is not known");
}

FileKind yaml_kind(const fs::path& path, const std::string& text) {
  const YAML::Node yaml = parse_yaml(text, shown_path(path.filename()));
  if (is_camchain(yaml)) return FileKind::camchain;
  if (is_camera_info(yaml)) return FileKind::camera_info;
  if (is_hand_eye_samples(yaml)) return FileKind::samples;
  if (is_pose_list(yaml)) return FileKind::poses;
  refuse_kind(path, "is YAML of a kind that is not known");
}

FileKind table_kind(const fs::path& path, const Table& table, const Robot* robot) {
  const int joints = robot ? joint_columns(table, *robot) : 0;
  if (joints >= 2) return FileKind::joints;
  if (is_pose_table(table, robot != nullptr)) return FileKind::poses;
  if (joints >= 1) return FileKind::joints;
  if (robot && !table.has_header) {
    std::size_t moving = 0;
    for (const Joint& j : robot->joints) moving += j.moves() && !j.is_mimic();
    if (table.width() == moving || table.width() == moving + 1) return FileKind::joints;
  }
  if (is_point_table(table)) return FileKind::points;
  refuse_kind(path, "is a table whose columns are neither joints of the robot nor places (x y z); write a header");
}

}  // namespace

bool has_images(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string ending = entry.path().extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char* known : {".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".bmp", ".tif", ".tiff"})
      if (ending == known) return true;
  }
  return false;
}

FileKind file_kind(const fs::path& path, const Robot* robot) {
  std::error_code error;
  if (!fs::exists(path, error))
    throw InputError(fmt::format("{}: is not there; name a file or folder.", shown_path(path)));
  if (fs::is_directory(path)) {
    if (is_bag(path)) return FileKind::bag;
    if (fs::exists(path / "session.xml")) refuse_kind(path, "holds a session already, use it as it is");
    if (has_images(path)) return FileKind::images;
    if (!pose_files_in(path).empty()) return FileKind::poses;
    refuse_kind(path, "is a folder without images, without files of poses and without a bag");
  }
  if (is_bag(path)) return FileKind::bag;
  const std::string text = read_file(path);
  if (text.starts_with("\x89MCAP"))
    throw InputError(
        fmt::format("{}: is a bag in MCAP, which cannot be read here; write it as sqlite3 with `ros2 bag "
                    "convert -i BAG -o options.yaml` (storage_id: sqlite3).",
                    shown_path(path)));
  if (text.starts_with("#ROSBAG"))
    throw InputError(
        fmt::format("{}: is a bag of ROS 1; convert it with `rosbags-convert`, storage sqlite3.", shown_path(path)));
  const std::string_view begin = first_line(text);
  if (begin.starts_with("<")) return xml_kind(path, text);
  if (has_number(path) && single_pose(text)) return FileKind::pose;
  if (is_storage_text(text)) return storage_kind(path, text);
  if (begin.starts_with("{")) return json_kind(text);
  if (text.find('\0') != std::string::npos) refuse_kind(path, "is no text");
  if (looks_like_yaml(text)) return yaml_kind(path, text);
  if (const auto table = parse_table(text, shown_path(path.filename()), names_of(robot)))
    return table_kind(path, *table, robot);
  refuse_kind(path, "is a text of a kind that is not known");
}

const char* kind_text(FileKind kind) {
  switch (kind) {
    case FileKind::robot:
      return "the robot's URDF";
    case FileKind::images:
      return "a folder of images";
    case FileKind::joints:
      return "a table of joint readings";
    case FileKind::poses:
      return "a table of poses";
    case FileKind::pose:
      return "a file with one pose";
    case FileKind::points:
      return "a table of points";
    case FileKind::samples:
      return "samples of easy_handeye";
    case FileKind::storage:
      return "a calibration of OpenCV";
    case FileKind::camera_info:
      return "a camera_info of ROS";
    case FileKind::camchain:
      return "a camchain of Kalibr";
    case FileKind::bag:
      return "a ROS 2 bag";
  }
  return "";
}

namespace {

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
    throw InputError(fmt::format("{} is {}, and another file is one too; name one of them.", file, kind_text(kind)));
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
    const Table table = *parse_table(text, file, names_of(robot));
    b.notes.insert(b.notes.end(), table.notes.begin(), table.notes.end());
    add_poses(read_pose_table(table, robot != nullptr, o, b.notes), file, b);
  }
}

void bring_table(const fs::path& path, const std::string& file, FileKind kind, const Robot* robot, bool degrees,
                 Brought& b) {
  Table table = *parse_table(read_file(path), file, names_of(robot));
  b.notes.insert(b.notes.end(), table.notes.begin(), table.notes.end());
  if (kind == FileKind::joints) {
    require_new(!b.joints, file, kind);
    b.joints = read_joint_table(std::move(table), *robot, degrees, b.notes);
  } else {
    require_new(!b.points, file, kind);
    b.points = read_point_table(std::move(table), b.notes);
  }
}

void bring_one(const fs::path& path, const std::string& file, FileKind kind, const Robot* robot,
               const PoseTableOptions& o, Brought& b, Waiting& waiting) {
  switch (kind) {
    case FileKind::robot:
      throw InputError(file + ": is a second robot; name one URDF, with --robot or among the files.");
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
      b.cameras.push_back(read_camera_info(parse_yaml(read_file(path), file), file));
      return;
    case FileKind::samples:
      require_new(!b.samples, file, kind);
      b.samples = read_hand_eye_samples(parse_yaml(read_file(path), file), file, b.notes);
      return;
    case FileKind::poses:
      return bring_poses(path, file, robot, o, b);
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
  for (const fs::path& path : files) {
    const FileKind kind = file_kind(path, robot);
    const std::string file = shown_path(path.filename().empty() ? path.parent_path().filename() : path.filename());
    if (kind != FileKind::pose) b.took.push_back(file + ": " + kind_text(kind));
    bring_one(path, file, kind, robot, {angles, degrees}, b, waiting);
  }
  for (const auto& [folder, poses] : waiting.single_poses) {
    b.took.push_back(fmt::format("{}: {} files with a pose each", shown_path(folder.filename()), poses.size()));
    add_poses(read_pose_files(poses, shown_path(folder.filename()), b.notes), shown_path(folder.filename()), b);
  }
  if (!angles.empty() && std::none_of(b.poses.begin(), b.poses.end(), [](const auto& p) { return p.turns.is_told; }))
    throw InputError(fmt::format("--angles {}: no table of poses here has {} numbers for a turn; leave it out.", angles,
                                 angle_count(named_angle_kind(angles).kind)));
  if (!waiting.storages.empty()) b.rig = read_rig_calibration(waiting.storages, &b.notes);
  return b;
}

const PoseSeries& settled_series(const NamedPoses& poses) {
  if (poses.turns.readings.size() > 1 && !poses.turns.first_is_usual)
    throw InputError(fmt::format(
        "{}: {} may be {}, or {}; name the columns roll pitch yaw or rvx rvy rvz, with their "
        "unit ([deg]).",
        poses.file, poses.turns.columns, reading_text(poses.turns.readings[0]), reading_text(poses.turns.readings[1])));
  return poses.series;
}

}  // namespace handsight
