// SPDX-License-Identifier: Apache-2.0
#include "convert/convert.h"

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "convert/convert_inputs.h"
#include "convert/file_kind.h"
#include "convert/opened_folders.h"
#include "convert/points_of_body.h"
#include "estimation/report/session_warnings.h"
#include "readers/bags/bag.h"
#include "readers/robots/robot_file.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

/// Files of gigabytes are not read whole to see that they are no robots.
bool begins_with_bracket(const fs::path& file) {
  std::ifstream stream(file);
  char first = 0;
  stream >> first;  // "<", or the mark of UTF-8 before it
  return first == '<' || first == '\xEF';
}

/// The robot of --robot, among the files, or in the bag; takes it out of the files.
std::optional<FieldUrdf> find_robot(std::vector<fs::path>& files, const std::optional<Bag>& bag,
                                    const ConvertOptions& o, Conversion& c) {
  if (!o.robot.empty()) return robot_of_file(o.robot);
  for (auto f = files.begin(); f != files.end(); ++f)
    if (fs::is_regular_file(*f) && !is_bag(*f) && begins_with_bracket(*f) && is_robot_text(read_file(*f))) {
      FieldUrdf robot = robot_of_file(*f);
      c.took.push_back(message("{}: {}", f->filename().string(), kind_text(FileKind::robot)));
      files.erase(f);
      return robot;
    }
  if (const std::string text = bag ? find_robot_description(*bag) : ""; !text.empty()) {
    c.notes.emplace_back("The robot is the one that the bag publishes as robot_description.");
    return field_urdf(text, "robot_description");
  }
  return std::nullopt;
}

/// By what the file calls the poses, or by the file.
bool is_called(const NamedPoses& p, const std::string& name) {
  return p.role == name || p.role == name + "_" || p.role == "mocap " + name || p.file == name ||
         fs::path(p.file).stem() == name;
}

/// Of several rigid bodies the one that --target-frame names.
void choose_target(Brought& b, const std::string& name) {
  const auto is_it = [&](const NamedPoses& p) { return is_called(p, name); };
  if (b.joints && b.poses.size() > 1 && std::any_of(b.poses.begin(), b.poses.end(), is_it))
    std::erase_if(b.poses, [&](const NamedPoses& p) { return !is_it(p); });
}

std::string list_names(const std::vector<NamedPoses>& poses) {
  std::string names;
  const bool of_files =
      std::any_of(poses.begin(), poses.end(), [&](const NamedPoses& p) { return p.file != poses.front().file; });
  for (const NamedPoses& p : poses)
    names += (names.empty() ? "" : ", ") + (p.role.empty() ? p.file
                                            : of_files     ? fmt::format("{} of {}", p.role, p.file)
                                                           : p.role);
  return names;
}

/// Of two tables of poses the flange's and the target's: as --target-frame says, or their names.
std::pair<NamedPoses, NamedPoses> flange_and_target(const std::vector<NamedPoses>& poses, const std::string& target) {
  const bool first = is_called(poses[0], target), second = is_called(poses[1], target);
  if (target.empty() || (first && second)) return flange_and_target(poses);
  if (!first && !second)
    throw InputError(message("--target-frame {}: no table of poses is called so; there are: {}.", in_quotes(target),
                             shortened(list_names(poses), 200)));
  return first ? std::pair(poses[1], poses[0]) : std::pair(poses[0], poses[1]);
}

/// The first bag among the files, open.
std::optional<Bag> find_bag(const std::vector<fs::path>& files) {
  const auto found = std::find_if(files.begin(), files.end(), is_bag);
  return found == files.end() ? std::nullopt : std::optional(open_bag(*found));
}

/// The points as the markers of one body, where each line has one of them.
PointSeries points_of_body(const Brought& b, std::vector<Message>& notes) {
  if (!b.markers.empty()) return markers_by_number(*b.points, b.markers);
  const auto markers = markers_line_by_line(*b.points, b.joints->positions.size());
  if (!markers) return *b.points;
  notes.push_back(
      message("There are {} measurements for each line of joint readings, and they keep their distances: "
              "they are taken for the markers 0 to {} of one body.",
              markers->points.front().size(), markers->points.front().size() - 1));
  return *markers;
}

Conversion assemble(const std::optional<FieldUrdf>& robot, const std::optional<Bag>& bag, const Brought& b,
                    const ConvertOptions& o, Conversion c) {
  if (bag) return from_bag(robot, *bag, b, o, std::move(c));
  if (b.samples) {
    const bool in_hand = b.samples->kind_is_known ? b.samples->eye_in_hand : !o.eye_on_base;
    NamedPoses flange{"samples", "robot", {.poses = b.samples->base_from_effector}},
        target{"samples", "tracking", {.poses = b.samples->camera_from_target}};
    if (!b.samples->kind_is_known && o.eye_on_base)
      for (Rigid& pose : flange.series.poses) pose = inverse(pose);
    return from_flange(std::move(flange), std::move(target), in_hand, o, std::move(c));
  }
  if (b.poses.size() > 2 && !b.joints)
    throw InputError(message("There are {} tables of poses ({}); expected the flange's and the target's.",
                             b.poses.size(), shortened(list_names(b.poses), 200)));
  if (!b.joints && b.poses.size() == 2) {
    auto [flange, target] = flange_and_target(b.poses, o.target_frame);
    return from_flange(std::move(flange), std::move(target), !o.eye_on_base, o, std::move(c));
  }
  if (!robot && !b.joints && b.poses.size() == 1 && b.points && b.image_folders.empty())
    return from_flange_points(b.poses[0], *b.points, !o.eye_on_base, o, std::move(c));
  if (!robot && !b.joints && b.poses.size() == 1 && b.image_folders.empty())
    throw InputError(
        message("{}: holds the only poses that are here; name those of the other (of the flange, of the target) too, "
                "points that a sensor measured, or a folder of images of a board.",
                b.poses[0].file));
  if (!robot && !b.joints && b.poses.size() == 1 && !b.image_folders.empty())
    return from_flange_images(b, o, std::move(c));
  if (!robot) throw InputError("There is no robot; name its URDF with --robot, or a table of its flange's poses.");
  if (!b.image_folders.empty()) return from_images(*robot, b, o, std::move(c));
  if (!b.joints && !b.unnamed_columns.empty()) throw InputError(b.unnamed_columns);
  if (!b.joints) throw InputError("There are no joint readings; name a table (CSV) of them, a column a joint.");
  if (b.points) {
    const PointSeries points = points_of_body(b, c.notes);
    return from_points(*robot, *b.joints, points, {}, o, std::move(c));
  }
  if (b.poses.size() == 1) return from_poses(*robot, *b.joints, b.poses[0], o, std::move(c));
  if (b.poses.size() > 1)
    throw InputError(message("There are {} things with poses ({}); say with --target-frame which is on the hand.",
                             b.poses.size(), shortened(list_names(b.poses), 200)));
  throw InputError(
      "There is nothing that a sensor measured: no images, no points, no poses of a target. Name their folder "
      "or file too.");
}

}  // namespace

namespace {

Conversion converted(const std::vector<fs::path>& given, ConvertOptions o) {
  if (fs::exists(o.out / "session.xml"))
    throw InputError(message("{}: there is a session already; take another folder.", shown_path(o.out)));
  Conversion c;
  const OpenedFolders opened = opened_folders(given);
  std::vector<fs::path> files = opened.files;
  const std::optional<Bag> bag = find_bag(files);
  if (!bag && !o.camera.empty())
    throw InputError(message("--camera {}: names images of a bag, and no bag is among the files; leave it out.",
                             in_quotes(o.camera)));
  const std::optional<FieldUrdf> robot = find_robot(files, bag, o, c);
  if (robot) c.notes.insert(c.notes.end(), robot->notes.begin(), robot->notes.end());
  leave_out_unknown(files, opened.found, robot ? &robot->robot : nullptr, c.notes);
  if (are_touches(files, robot ? &robot->robot : nullptr, o)) return from_touches(robot, files, o, std::move(c));
  Brought b = bring(files, robot ? &robot->robot : nullptr, o.degrees, o.angles, o.columns);
  choose_target(b, o.target_frame);
  c.took.insert(c.took.end(), b.took.begin(), b.took.end());
  c.notes.insert(c.notes.end(), b.notes.begin(), b.notes.end());
  ask_whether_to_go_on(o);
  if (!o.target) o.target = b.target;
  c = assemble(robot, bag, b, o, std::move(c));
  for (const Message& model_uncertainty : session_warnings(c.session)) c.notes.push_back(model_uncertainty);
  return c;
}

/// Nothing half made stays where there was no folder before.
void remove_what_was_made(const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder, error);
}

}  // namespace

Conversion convert(const std::vector<fs::path>& given, const ConvertOptions& o) {
  const bool is_new = !fs::exists(o.out);
  try {
    return converted(given, o);
  } catch (...) {
    if (is_new && !o.out.empty()) remove_what_was_made(o.out);
    throw;
  }
}

}  // namespace handsight
