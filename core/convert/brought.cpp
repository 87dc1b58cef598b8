// SPDX-License-Identifier: Apache-2.0
#include "convert/brought.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/letters.h"
#include "base/text.h"
#include "convert/file_kind.h"
#include "convert/listed_rows.h"
#include "convert/points_of_body.h"
#include "convert/rows_of_two.h"
#include "readers/kalibr_target.h"
#include "readers/maker_cameras.h"
#include "readers/mocap/mocap_csv.h"
#include "readers/pose_list.h"
#include "readers/pose_matrices.h"
#include "readers/stereo_calibration.h"
#include "readers/texts/camera_texts.h"
#include "readers/texts/cells.h"
#include "readers/texts/plain_text.h"
#include "readers/yaml_text.h"
#include "robot/robot.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// What is read when all files are known.
struct Waiting {
  std::vector<StereoCalibrationText> storages;
  std::vector<Table> beside_joints;                        // what else tables of joints have
  std::map<fs::path, std::vector<fs::path>> single_poses;  // by their folder
};

void add_poses(std::vector<ReadPoses> read, const std::string& file, Brought& b) {
  for (ReadPoses& one : read)
    b.poses.push_back({file, std::move(one.role), std::move(one.series), std::move(one.turns)});
}

void require_new(bool is_new, const std::string& file, FileKind kind, const Brought& b) {
  if (is_new) return;
  const auto at = b.first_of_kind.find(kind);
  const Message other = at == b.first_of_kind.end() ? Message("another file") : verbatim(at->second);
  if (kind == FileKind::joints)
    throw InputError(message(
        "{} is a table of joint readings, and {} is one too; name one of them. (Tables of touches, one for each "
        "fixture: say what each is, --fixture \"plane {}\".)",
        file, other, shortened(std::filesystem::path(file).stem().string(), 40)));
  throw InputError(message("{} is {}, and {} is one too; name one of them.", file, kind_text(kind), other));
}

Table without_columns(Table t, const std::vector<std::size_t>& columns) {
  for (auto c = columns.rbegin(); c != columns.rend(); ++c) {
    const auto at = static_cast<std::ptrdiff_t>(*c);
    t.columns.erase(t.columns.begin() + at);
    for (auto& row : t.rows) row.erase(row.begin() + at);
  }
  return t;
}

/// In YAML or JSON, as ROS, MoveIt and people write them; what is told otherwise is a table.
bool is_list_of_poses(const std::string& text, const std::string& file) {
  if (!looks_like_yaml(text) && !first_line(text).starts_with("{")) return false;
  try {
    return !has_several_documents(text) && is_pose_list(parse_yaml(text, file));
  } catch (const InputError&) {
    return false;
  }
}

/// What who brings tables says of them.
struct TableOptions {
  PoseTableOptions poses;
  std::vector<std::string> columns;  // of a table without a header
};

Table table_of_file(const fs::path& path, const std::string& file, const Robot* robot, const TableOptions& o) {
  return *parse_measured_table(read_text(path), file, robot ? joint_names(*robot) : std::vector<std::string>(),
                               o.columns);
}

/// Rows of the flange and rows of the target in one table.
void bring_both(const std::vector<RowsOf>& both, const std::string& file, const Robot* robot, const TableOptions& o,
                Brought& b) {
  b.notes.push_back(
      message("{}: its rows with {} are taken for poses of the flange, those with {} for poses of the "
              "target, paired in their order.",
              file, in_quotes(both[0].word), in_quotes(both[1].word)));
  for (std::size_t i = 0; i < both.size(); ++i) {
    std::vector<ReadPoses> read = read_pose_table(both[i].table, robot != nullptr, o.poses, b.notes);
    for (ReadPoses& one : read) one.role = i == 0 ? "flange" : "target";
    add_poses(std::move(read), file, b);
  }
}

void bring_poses(const fs::path& path, const std::string& file, const Robot* robot, const TableOptions& o, Brought& b) {
  if (fs::is_directory(path)) return add_poses(read_pose_files(pose_files_in(path), file, b.notes), file, b);
  const std::string text = read_text(path);
  if (is_storage_text(text)) {
    const auto rows = pose_rows_of_storage(text, file);
    add_poses(rows ? read_pose_table(*rows, false, o.poses, b.notes) : poses_of_storage(text, file, b.notes), file, b);
  } else if (is_list_of_poses(text, file)) {
    add_poses(read_pose_list(parse_yaml(text, file), file, b.notes), file, b);
  } else {
    const Table table = table_of_file(path, file, robot, o);
    b.notes.insert(b.notes.end(), table.notes.begin(), table.notes.end());
    if (const auto both = rows_of_two(table); !both.empty()) return bring_both(both, file, robot, o, b);
    add_poses(read_pose_table(table, robot != nullptr, o.poses, b.notes), file, b);
  }
}

/// Is it what the robot itself says of its hand? That measures nothing.
bool is_of_robot(const std::string& role) {
  const std::string name = lower_case(role);
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  return has("flange") || has("tcp") || has("actual") || has("effector") || has("gripper") || has("robot") ||
         has("tool0") || has("base_");
}

/// Of a table of joint readings what is no joint and nothing else either.
void say_what_is_left_out(const Table& table, Brought& b) {
  const auto others = table.width() - find_column(table, {"time", "timestamp", "t", "stamp"}).has_value();
  if (table.has_header && others > 0)
    b.notes.push_back(message("{}: {} columns are no joints of the robot and are left out.", table.file, others));
}

/// Poses or points in the table of joint readings itself; false: there are none.
bool bring_places(const Table& table, const PoseTableOptions& o, Brought& b) {
  if (is_pose_table(table, true)) {
    std::vector<Message> notes;
    std::vector<ReadPoses> read = read_pose_table(table, true, o, notes);
    std::erase_if(read, [](const ReadPoses& one) { return is_of_robot(one.role); });
    if (read.empty()) return false;
    b.notes.insert(b.notes.end(), notes.begin(), notes.end());
    add_poses(std::move(read), table.file, b);
  } else if (is_point_table(table)) {
    b.points = read_point_table(table, b.notes);
  } else {
    return false;
  }
  b.notes.push_back(
      message("{}: the places in it are taken for what a sensor measured of the hand; where they are the controller's "
              "own they measure nothing.",
              table.file));
  return true;
}

/// Where nothing else was measured it may stand beside the joint readings.
void bring_what_stands_beside(const std::vector<Table>& tables, const PoseTableOptions& o, Brought& b) {
  const bool is_measured = !b.poses.empty() || b.points || !b.image_folders.empty() || b.samples || !b.bag.empty();
  const bool may_be = !is_measured && tables.size() == 1 && tables.front().has_header;
  if (may_be && bring_places(tables.front(), o, b)) return;
  for (const Table& table : tables) say_what_is_left_out(table, b);
}

/// What stands in a table without a header, where joints may be among it, and how to say it.
Message unnamed_columns(const Table& table, const Robot& robot) {
  return message(
      "{}: has {} columns and no header, so that nobody can say which are the joints; name them in a first line, or "
      "with "
      "--table-columns \"{} x y z\" (a name each; - is left out; joint[deg], x[mm] say the unit).",
      table.file, table.width(), shortened(fmt::format("{}", fmt::join(joint_names(robot), " ")), 150));
}

void bring_table(const fs::path& path, const std::string& file, FileKind kind, const Robot* robot,
                 const TableOptions& o, Waiting& waiting, Brought& b) {
  Table table = table_of_file(path, file, robot, o);
  bool degrees = o.poses.degrees;
  b.notes.insert(b.notes.end(), table.notes.begin(), table.notes.end());
  if (kind == FileKind::joints) {
    require_new(!b.joints, file, kind, b);
    auto taken = list_joint_columns(table, *robot);
    if (const auto column = find_column(table, {"marker", "smr", "reflector", "marker_id"})) {
      for (const auto& row : table.rows) b.markers.push_back(row[*column]);
      taken.push_back(*column);
    }
    waiting.beside_joints.push_back(without_columns(table, taken));
    if (!b.servos.empty()) set_radians(table, b.servos, std::exchange(degrees, false), b.notes);
    b.joints = read_joint_table(std::move(table), *robot, degrees, b.notes);
    if (!b.joints->times.empty()) b.markers.clear();  // rows may stand in another order now
  } else {
    if (robot && !table.has_header) b.unnamed_columns = unnamed_columns(table, *robot);
    PointSeries points = read_point_table(std::move(table), b.notes);
    if (!b.points) {
      b.points = std::move(points);
      return;
    }
    auto both = with_more_markers(*b.points, points);
    require_new(both.has_value(), file, kind, b);
    b.points = std::move(*both);
    b.notes.push_back(
        message("{}: its points keep their distances from those of the files before it: they are taken "
                "for further markers of the same body (number {} on).",
                file, b.points->points.front().size() - points.points.front().size()));
  }
}

void bring_mocap(const fs::path& path, const std::string& file, const PoseTableOptions& o, Brought& b) {
  MocapTables all = *read_mocap(read_text(path), file);
  b.notes.insert(b.notes.end(), all.notes.begin(), all.notes.end());
  for (const MocapBody& body : all.bodies) {
    auto read = read_pose_table(body.table, true, o, b.notes);
    for (ReadPoses& one : read) one.role = "mocap " + body.name;
    add_poses(std::move(read), file, b);
  }
  if (all.markers.columns.empty()) return;
  require_new(!b.points, file, FileKind::points, b);
  b.points = read_point_table(std::move(all.markers), b.notes);
}

RosCamera camera_of_yaml(const YAML::Node& yaml, const std::string& file) {
  return is_camera_info(yaml) ? read_camera_info(yaml, file) : read_echoed_camera_info(yaml, file);
}

void bring_cameras(const fs::path& path, const std::string& file, FileKind kind, Brought& b) {
  const std::string text = read_text(path);
  if (kind == FileKind::ost) {
    for (RosCamera& camera : read_ost(text, file)) b.cameras.push_back(std::move(camera));
  } else if (kind == FileKind::camodocal) {
    b.cameras.push_back(read_camodocal(text, file));
  } else if (kind == FileKind::named) {
    b.cameras.push_back(read_named_camera(text, file, b.notes));
  } else if (kind == FileKind::camera_info) {
    b.cameras.push_back(camera_of_yaml(parse_yaml(text, file), file));
  } else if (is_realsense_listing(text)) {
    b.cameras.push_back(read_realsense_listing(text, file, b.notes));
  } else {
    b.cameras.push_back(read_realsense(parse_yaml(text, file), file, b.notes));
  }
}

void bring_one(const fs::path& path, const std::string& file, FileKind kind, const Robot* robot, const TableOptions& o,
               Brought& b, Waiting& waiting) {
  switch (kind) {
    case FileKind::robot:
      throw InputError(message("{}: is a second robot; name one URDF, with --robot or among the files.", file));
    case FileKind::images:
      b.image_folders.push_back(path);
      if (const auto poses = pose_files_in(path); poses.size() > 2) waiting.single_poses[path] = poses;
      return;
    case FileKind::storage:
      waiting.storages.push_back({read_file(path), file});
      return;
    case FileKind::matrix:
      waiting.storages.push_back({*camera_entries(read_text(path), path.stem().string()), file});
      return;
    case FileKind::bag:
      require_new(b.bag.empty(), file, kind, b);
      b.bag = path;
      return;
    case FileKind::camchain:
      require_new(!b.rig, file, kind, b);
      b.rig = read_camchain(parse_yaml(read_text(path), file), file, b.notes);
      return;
    case FileKind::camera_info:
    case FileKind::ost:
    case FileKind::realsense:
    case FileKind::camodocal:
    case FileKind::named:
      return bring_cameras(path, file, kind, b);
    case FileKind::target:
      require_new(!b.target, file, kind, b);
      b.target = read_kalibr_target(parse_yaml(read_text(path), file), file);
      b.notes.push_back(message("{}: {}.", file, describe_target(*b.target)));
      return;
    case FileKind::samples:
      require_new(!b.samples, file, kind, b);
      b.samples = read_hand_eye_samples(parse_yaml(read_text(path), file), file, b.notes);
      return;
    case FileKind::poses:
      return bring_poses(path, file, robot, o, b);
    case FileKind::servos:
      return;  // known before any table is read
    case FileKind::mocap:
      return bring_mocap(path, file, o.poses, b);
    case FileKind::pose:
      waiting.single_poses[path.parent_path()].push_back(path);
      return;
    case FileKind::joints:
    case FileKind::points:
      return bring_table(path, file, kind, robot, o, waiting, b);
  }
}

}  // namespace

Brought bring(const std::vector<fs::path>& files, const Robot* robot, bool degrees, const std::string& angles,
              const std::vector<std::string>& columns) {
  Brought b;
  Waiting waiting;
  if (!angles.empty()) named_angle_kind(angles);  // refused before anything is read
  std::vector<FileKind> kinds;
  for (const fs::path& path : files) {
    kinds.push_back(file_kind(path, robot, columns));
    const std::string name = shown_path(path.filename());
    if (kinds.back() == FileKind::servos) b.servos = read_lerobot_calibration(parse_yaml(read_text(path), name), name);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    const fs::path& path = files[i];
    const FileKind kind = kinds[i];
    const std::string file = shown_path(path.filename().empty() ? path.parent_path().filename() : path.filename());
    if (kind != FileKind::pose) b.took.push_back(message("{}: {}", file, kind_text(kind)));
    bring_one(path, file, kind, robot, {{angles, degrees}, columns}, b, waiting);
    b.first_of_kind.try_emplace(kind, file);
  }
  for (const auto& [folder, poses] : waiting.single_poses) {
    b.took.push_back(message("{}: {} files with a pose each", shown_path(folder.filename()), poses.size()));
    add_poses(read_pose_files(poses, shown_path(folder.filename()), b.notes), shown_path(folder.filename()), b);
  }
  bring_what_stands_beside(waiting.beside_joints, {angles, degrees}, b);
  if (!angles.empty() &&
      std::none_of(b.poses.begin(), b.poses.end(), [](const auto& p) { return p.turns.is_reported; }))
    throw InputError(message("--angles {}: no table of poses here has {} numbers for a turn; leave it out.", angles,
                             angle_count(named_angle_kind(angles).kind)));
  if (!waiting.storages.empty()) b.rig = parse_rig_calibration(waiting.storages, &b.notes);
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
