// SPDX-License-Identifier: Apache-2.0
#include "convert/file_kind.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "convert/foreign_files.h"
#include "convert/recorder_columns.h"
#include "readers/bags/bag.h"
#include "readers/camera_files.h"
#include "readers/kalibr_target.h"
#include "readers/maker_cameras.h"
#include "readers/mocap_csv.h"
#include "readers/pose_files.h"
#include "readers/pose_matrices.h"
#include "readers/robots/lerobot.h"
#include "readers/robots/robot_file.h"
#include "session/new_session.h"

namespace handsight {

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

bool looks_like_yaml(std::string_view text) {
  const std::string_view line = first_line(text);
  return line.starts_with("- ") || line.starts_with("[") || line.ends_with(":") ||
         (line.find(": ") != std::string_view::npos && line.find_first_of(",;\t") == std::string_view::npos) ||
         (line.find(": ") != std::string_view::npos && line.find('[') != std::string_view::npos);
}

bool is_storage_text(const std::string& text) {
  return first_line(text).starts_with("%YAML") || text.find("!!opencv-matrix") != std::string::npos ||
         text.find("<opencv_storage") != std::string::npos;
}

namespace {

namespace fs = std::filesystem;

std::vector<std::string> list_names(const Robot* robot) {
  return robot ? joint_names(*robot) : std::vector<std::string>();
}

/// A storage of poses, not of cameras.
FileKind storage_kind(const fs::path& path, const std::string& text) {
  std::vector<Message> notes;
  const bool has_poses =
      text.find("amera") == std::string::npos && !poses_of_storage(text, shown_path(path.filename()), notes).empty();
  return has_poses ? FileKind::poses : FileKind::storage;
}

/// JSON: a camera of RealSense, servos of LeRobot, a list of poses, or a storage of OpenCV.
FileKind json_kind(const std::string& text) {
  try {
    const YAML::Node yaml = parse_yaml(text, "");
    if (is_realsense(yaml)) return FileKind::realsense;
    if (is_lerobot_calibration(yaml)) return FileKind::servos;
    return is_pose_list(yaml) ? FileKind::poses : FileKind::storage;
  } catch (const InputError&) {
    return FileKind::storage;
  }
}

bool has_number(const fs::path& path) {
  const std::string stem = path.stem().string();
  return stem.find_first_of("0123456789") != std::string::npos;
}

[[noreturn]] void refuse_kind(const fs::path& path, const char* looks_like) {
  throw InputError(message(
      "{}: {}; expected a URDF, a folder of images, a table (CSV) of joints, poses or points, a calibration of OpenCV, "
      "ROS or Kalibr, samples of easy_handeye, or a bag of ROS.",
      shown_path(path), looks_like));
}

FileKind xml_kind(const fs::path& path, const std::string& text) {
  if (is_robot_text(text)) return FileKind::robot;
  if (text.find("<opencv_storage") != std::string::npos) return storage_kind(path, text);
  if (text.find("<handsight_session") != std::string::npos) refuse_kind(path, "is a session already, use it as it is");
  if (text.find("<sdf") != std::string::npos) refuse_kind(path, "is an SDF of Gazebo; name the URDF of the robot");
  refuse_kind(path, "is XML of a kind that is not known");
}

FileKind yaml_kind(const fs::path& path, const std::string& text) {
  const YAML::Node yaml = parse_yaml(text, shown_path(path.filename()));
  if (is_camchain(yaml)) return FileKind::camchain;
  if (is_camera_info(yaml) || is_echoed_camera_info(yaml)) return FileKind::camera_info;
  if (is_kalibr_target(yaml)) return FileKind::target;
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

std::string first_bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(512, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace

bool is_one_camera(FileKind kind) {
  return kind == FileKind::camera_info || kind == FileKind::ost || kind == FileKind::realsense ||
         kind == FileKind::camodocal;
}

bool has_images(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string ending = entry.path().extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char* known : {".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".bmp", ".tif", ".tiff", ".webp"})
      if (ending == known) return true;
  }
  return false;
}

FileKind file_kind(const fs::path& path, const Robot* robot) {
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(message("{}: is not there; name a file or folder.", shown_path(path)));
  if (fs::is_directory(path)) {
    if (is_bag(path)) return FileKind::bag;
    if (fs::exists(path / "session.xml")) refuse_kind(path, "holds a session already, use it as it is");
    if (has_images(path)) return FileKind::images;
    if (!pose_files_in(path).empty()) return FileKind::poses;
    refuse_kind(path, "is a folder without images, without files of poses and without a bag");
  }
  if (is_bag(path)) return FileKind::bag;
  refuse_foreign_file(path, first_bytes_of(path));
  const std::string text = read_file(path);
  const std::string_view begin = first_line(text);
  if (begin.starts_with("<")) return xml_kind(path, text);
  if (is_motive_csv(text) || is_vicon_csv(text)) return FileKind::mocap;
  if (is_ost(text)) return FileKind::ost;
  if (is_camodocal(text)) return FileKind::camodocal;
  if (is_realsense_listing(text)) return FileKind::realsense;
  if (has_number(path) && single_pose(text)) return FileKind::pose;
  if (is_storage_text(text)) return storage_kind(path, text);
  if (begin.starts_with("{")) return json_kind(text);
  if (text.find('\0') != std::string::npos) refuse_kind(path, "is no text");
  if (looks_like_yaml(text)) return yaml_kind(path, text);
  if (const auto table = parse_recorded_table(text, shown_path(path.filename()), list_names(robot)))
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
    case FileKind::servos:
      return "servos of LeRobot";
    case FileKind::mocap:
      return "motion capture of Motive or Vicon";
    case FileKind::ost:
      return "a calibration of ROS's camera_calibration";
    case FileKind::realsense:
      return "a camera of RealSense";
    case FileKind::camodocal:
      return "a camera of camodocal";
    case FileKind::target:
      return "a target of Kalibr";
    case FileKind::camchain:
      return "a camchain of Kalibr";
    case FileKind::bag:
      return "a bag of ROS";
  }
  return "";
}

}  // namespace handsight
