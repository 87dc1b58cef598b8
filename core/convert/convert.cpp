// SPDX-License-Identifier: Apache-2.0
#include "convert/convert.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "convert/convert_ways.h"
#include "estimation/report/session_doubts.h"
#include "readers/ros_bag.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

bool is_urdf(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return begin != std::string::npos && text[begin] == '<' && text.find("<robot") != std::string::npos;
}

/// The robot of --robot, among the files, or in the bag; takes it out of the files.
std::optional<FieldUrdf> find_robot(std::vector<fs::path>& files, const ConvertOptions& o, Conversion& c) {
  if (!o.robot.empty()) return field_urdf(read_file(o.robot), o.robot.filename().string());
  for (auto f = files.begin(); f != files.end(); ++f)
    if (fs::is_regular_file(*f) && !is_bag(*f) && is_urdf(read_file(*f))) {
      const std::string name = f->filename().string();
      FieldUrdf robot = field_urdf(read_file(*f), name);
      c.took.push_back(name + ": " + kind_text(FileKind::robot));
      files.erase(f);
      return robot;
    }
  for (const fs::path& f : files)
    if (is_bag(f))
      if (const std::string text = robot_description_of(f); !text.empty()) {
        c.notes.emplace_back("The robot is the one that the bag publishes as robot_description.");
        return field_urdf(text, "robot_description");
      }
  return std::nullopt;
}

std::string names_of(const std::vector<NamedPoses>& poses) {
  std::string names;
  for (const NamedPoses& p : poses) names += (names.empty() ? "" : ", ") + (p.role.empty() ? p.file : p.role);
  return names;
}

Conversion assemble(const std::optional<FieldUrdf>& robot, const Brought& b, const ConvertOptions& o, Conversion c) {
  if (!b.bag.empty()) return from_bag(robot, b, o, std::move(c));
  if (b.samples) {
    const bool in_hand = b.samples->kind_is_known ? b.samples->eye_in_hand : !o.eye_on_base;
    NamedPoses flange{"samples", "robot", {.poses = b.samples->base_from_effector}},
        target{"samples", "tracking", {.poses = b.samples->camera_from_target}};
    if (!b.samples->kind_is_known && o.eye_on_base)
      for (Rigid& pose : flange.series.poses) pose = inverse(pose);
    return from_flange(std::move(flange), std::move(target), in_hand, o, std::move(c));
  }
  if (b.poses.size() > 2)
    throw InputError(fmt::format("There are {} tables of poses ({}); expected the flange's and the target's.",
                                 b.poses.size(), shortened(names_of(b.poses), 200)));
  if (!b.joints && b.poses.size() == 2) {
    auto [flange, target] = flange_and_target(b.poses);
    return from_flange(std::move(flange), std::move(target), !o.eye_on_base, o, std::move(c));
  }
  if (!robot && !b.joints && b.poses.size() == 1 && b.image_folders.empty())
    throw InputError(
        fmt::format("{}: holds the only poses that are here{}; name those of the other (of the flange, of the target) "
                    "too, or a folder "
                    "of images of a board.",
                    b.poses[0].file, b.points ? " (what has x y z without a whole turn is a table of points)" : ""));
  if (!robot && !b.joints && b.poses.size() == 1 && !b.image_folders.empty())
    return from_flange_images(b, o, std::move(c));
  if (!robot) throw InputError("There is no robot; name its URDF with --robot, or a table of its flange's poses.");
  if (!b.image_folders.empty()) return from_images(*robot, b, o, std::move(c));
  if (!b.joints) throw InputError("There are no joint readings; name a table (CSV) of them, a column a joint.");
  if (b.points) return from_points(*robot, *b.joints, *b.points, {}, o, std::move(c));
  if (b.poses.size() == 1) return from_poses(*robot, *b.joints, b.poses[0], o, std::move(c));
  throw InputError(
      "There is nothing that a sensor measured: no images, no points, no poses of a target. Name their folder "
      "or file too.");
}

}  // namespace

namespace {

Conversion converted(const std::vector<fs::path>& given, const ConvertOptions& o) {
  if (fs::exists(o.out / "session.xml"))
    throw InputError(fmt::format("{}: there is a session already; take another folder.", shown_path(o.out)));
  Conversion c;
  std::vector<fs::path> files = given;
  const std::optional<FieldUrdf> robot = find_robot(files, o, c);
  if (robot) c.notes.insert(c.notes.end(), robot->notes.begin(), robot->notes.end());
  const Brought b = bring(files, robot ? &robot->robot : nullptr, o.degrees, o.angles);
  c.took.insert(c.took.end(), b.took.begin(), b.took.end());
  c.notes.insert(c.notes.end(), b.notes.begin(), b.notes.end());
  ask_whether_to_go_on(o);
  c = assemble(robot, b, o, std::move(c));
  for (const std::string& doubt : session_doubts(c.session)) c.notes.push_back(doubt);
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
