// SPDX-License-Identifier: Apache-2.0
#include "convert/file_kind.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "base/letters.h"
#include "base/text.h"
#include "convert/foreign_files.h"
#include "convert/listed_rows.h"
#include "readers/bags/bag.h"
#include "readers/camera_files.h"
#include "readers/kalibr_target.h"
#include "readers/maker_cameras.h"
#include "readers/mocap/mocap_csv.h"
#include "readers/pose_files.h"
#include "readers/pose_list.h"
#include "readers/pose_matrices.h"
#include "readers/robots/lerobot.h"
#include "readers/robots/robot_file.h"
#include "readers/texts/camera_texts.h"
#include "readers/texts/cells.h"
#include "readers/texts/plain_text.h"
#include "readers/yaml_text.h"
#include "session/new_session.h"

namespace handsight {

bool is_storage_text(const std::string& text) {
  return first_line(text).starts_with("%YAML") || text.find("!!opencv-matrix") != std::string::npos ||
         text.find("<opencv_storage") != std::string::npos;
}

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_kind(const fs::path& path, const char* looks_like) {
  throw InputError(message(
      "{}: {}; expected a URDF, a folder of images, a table (CSV) of joints, poses or points, a calibration of OpenCV, "
      "ROS or Kalibr, samples of easy_handeye, or a bag of ROS.",
      shown_path(path), looks_like));
}

std::vector<std::string> list_names(const Robot* robot) {
  return robot ? joint_names(*robot) : std::vector<std::string>();
}

/// A storage of poses, not of cameras.
FileKind storage_kind(const fs::path& path, const std::string& text) {
  std::vector<Message> notes;
  const std::string file = shown_path(path.filename());
  const bool has_poses = text.find("amera") == std::string::npos &&
                         (pose_rows_of_storage(text, file) || !poses_of_storage(text, file, notes).empty());
  return has_poses ? FileKind::poses : FileKind::storage;
}

FileKind table_kind(const fs::path& path, const Table& table, const Robot* robot);

/// A list of maps with joint readings (and, it may be, poses), or with poses that are told otherwise; nothing: no such
/// list.
std::optional<FileKind> listed_kind(const fs::path& path, const std::string& text, const Robot* robot) {
  const auto table = parse_listed_rows(text, shown_path(path.filename()), list_names(robot));
  return table ? std::optional(table_kind(path, *table, robot)) : std::nullopt;
}

/// A list of maps with the readings of joints, and whatever else.
bool holds_joints(const std::string& text, const Robot* robot) {
  if (!robot) return false;
  try {
    const auto table = parse_listed_rows(text, "", list_names(robot));
    return table && joint_columns(*table, *robot) >= 2;
  } catch (const InputError&) {
    return false;
  }
}

bool is_yaml_of_poses(const std::string& text) {
  try {
    return is_pose_list(parse_yaml(text, ""));
  } catch (const InputError&) {
    return false;
  }
}

/// Does a storage say anything that only cameras have?
bool is_likely_camera(const std::string& text) {
  constexpr std::array words{"amera", "istortion", "dist", "mtx", "ntrinsic", "\"K", "\"M1", "\"M2", "\"D", "opencv"};
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// JSON: a camera of RealSense, servos of LeRobot, a list of poses, or a storage of OpenCV.
FileKind json_kind(const fs::path& path, const std::string& text, const Robot* robot) {
  if (holds_joints(text, robot)) return FileKind::joints;
  try {
    const YAML::Node yaml = parse_yaml(text, "");
    if (is_realsense(yaml)) return FileKind::realsense;
    if (is_lerobot_calibration(yaml)) return FileKind::servos;
    if (is_pose_list(yaml)) return FileKind::poses;
  } catch (const InputError&) {
    return listed_kind(path, text, robot).value_or(FileKind::storage);
  }
  if (const auto kind = listed_kind(path, text, robot)) return *kind;
  if (!is_likely_camera(text)) refuse_kind(path, "is JSON of a kind that is not known");
  return FileKind::storage;
}

/// A line a message: {"topic":"/tf","sequence":3,"log_time":...,"publish_time":...,"data":{...}}.
bool is_printed_mcap(std::string_view first) {
  return first.starts_with("{") && first.find("\"topic\"") != std::string_view::npos &&
         first.find("\"log_time\"") != std::string_view::npos && first.find("\"data\"") != std::string_view::npos;
}

bool has_number(const fs::path& path) {
  const std::string stem = path.stem().string();
  return stem.find_first_of("0123456789") != std::string::npos;
}

FileKind xml_kind(const fs::path& path, const std::string& text) {
  if (is_robot_text(text)) return FileKind::robot;
  if (text.find("<opencv_storage") != std::string::npos) return storage_kind(path, text);
  if (text.find("<handsight_session") != std::string::npos) refuse_kind(path, "is a session already, use it as it is");
  if (text.find("<sdf") != std::string::npos) refuse_kind(path, "is an SDF of Gazebo; name the URDF of the robot");
  refuse_kind(path, "is XML of a kind that is not known");
}

/// Is an entry of the map a camera's matrix?
bool holds_camera_matrix(const YAML::Node& yaml) {
  return yaml.IsMap() && std::any_of(yaml.begin(), yaml.end(), [](const auto& entry) {
           const auto n = entry.second.IsSequence() ? yaml_numbers(entry.second) : std::nullopt;
           return n && n->size() == 9 && (*n)[0] > 1 && (*n)[4] > 1 && (*n)[8] == 1;
         });
}

FileKind yaml_kind(const fs::path& path, const std::string& text, const Robot* robot) {
  if (holds_joints(text, robot)) return FileKind::joints;
  if (const auto table = parse_printed_rows(text, ""); table && !is_yaml_of_poses(text))
    return table_kind(path, *table, robot);
  const YAML::Node yaml = parse_yaml(text, shown_path(path.filename()));
  if (is_camchain(yaml)) return FileKind::camchain;
  if (is_camera_info(yaml) || is_echoed_camera_info(yaml)) return FileKind::camera_info;
  if (is_kalibr_target(yaml)) return FileKind::target;
  if (is_hand_eye_samples(yaml)) return FileKind::samples;
  if (is_pose_list(yaml) && !has_several_documents(text)) return FileKind::poses;
  if (holds_camera_matrix(yaml)) return FileKind::storage;
  if (const auto kind = listed_kind(path, text, robot)) return *kind;
  refuse_kind(path, "is YAML of a kind that is not known");
}

[[noreturn]] void refuse_columns(const fs::path& path, const Table& table, const Robot* robot) {
  if (!table.has_header)
    refuse_kind(path,
                "is a table whose columns are neither joints of the robot nor places (x y z); write a header, or name "
                "the columns "
                "with --table-columns");
  std::vector<std::string> names;
  for (const TableColumn& column : table.columns) names.push_back(column.name);
  const std::string columns = shortened(fmt::format("{}", fmt::join(names, " ")), 150);
  if (!robot)
    throw InputError(
        message("{}: its columns ({}) are no places (x y z) with or without a turn; joint readings need the robot they "
                "are of: name its URDF with --robot.",
                shown_path(path), columns));
  throw InputError(
      message("{}: its columns ({}) are neither joints of the robot ({}) nor places (x y z); name them so in the first "
              "line.",
              shown_path(path), columns, shortened(fmt::format("{}", fmt::join(joint_names(*robot), " ")), 200)));
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
  refuse_columns(path, table, robot);
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
         kind == FileKind::camodocal || kind == FileKind::named;
}

bool is_image_name(const fs::path& file) {
  constexpr std::array endings{".png", ".jpg", ".jpeg", ".pgm", ".ppm", ".bmp", ".tif", ".tiff", ".webp"};
  return std::find(endings.begin(), endings.end(), lower_case(file.extension().string())) != endings.end();
}

bool has_images(const fs::path& folder) {
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  return std::any_of(begin(entries), end(entries), [](const auto& entry) { return is_image_name(entry.path()); });
}

FileKind file_kind(const fs::path& path, const Robot* robot, const std::vector<std::string>& columns) {
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
  const std::string text = read_text(path);
  const std::string_view begin = first_line(text);
  if (begin.empty()) refuse_kind(path, "is empty");
  if (begin.starts_with("<")) return xml_kind(path, text);
  if (is_mocap(text)) return FileKind::mocap;
  if (is_ost(text)) return FileKind::ost;
  if (is_camodocal(text)) return FileKind::camodocal;
  if (is_realsense_listing(text)) return FileKind::realsense;
  if (camera_entries(text, path.stem().string())) return FileKind::matrix;
  if ((begin.starts_with("%") || looks_like_yaml(text)) && is_named_camera(text)) return FileKind::named;
  if (has_number(path) && !poses_of_instant(text).empty()) return FileKind::pose;
  if (is_storage_text(text)) return storage_kind(path, text);
  if (is_printed_mcap(begin))
    refuse_kind(
        path,
        "holds messages of a bag as `mcap cat --json` prints them; name the bag itself (.mcap), which is read as "
        "it is");
  if (begin.starts_with("{")) return json_kind(path, text, robot);
  if (text.find('\0') != std::string::npos) refuse_kind(path, "is no text");
  if (looks_like_yaml(text)) return yaml_kind(path, text, robot);
  if (const auto table = parse_measured_table(text, shown_path(path.filename()), list_names(robot), columns))
    return table_kind(path, *table, robot);
  if (text.find_first_of("\r\n", static_cast<std::size_t>(begin.data() + begin.size() - text.data())) ==
          std::string::npos ||
      first_line(std::string_view(text).substr(static_cast<std::size_t>(begin.data() + begin.size() - text.data())))
          .empty())
    refuse_kind(path, "has one line, and nothing below it");
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
      return "motion capture of Motive, Vicon or Qualisys";
    case FileKind::ost:
      return "a calibration of ROS's camera_calibration";
    case FileKind::realsense:
      return "a camera of RealSense";
    case FileKind::camodocal:
      return "a camera of camodocal";
    case FileKind::named:
      return "a camera by its numbers' names";
    case FileKind::matrix:
      return "numbers of a camera";
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
