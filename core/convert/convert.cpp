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

Conversion assemble(const std::optional<FieldUrdf>& robot, const Brought& b, const ConvertOptions& o, Conversion c) {
  if (!b.bag.empty()) return from_bag(robot, b, o, std::move(c));
  if (b.samples) {
    const bool in_hand = b.samples->kind_is_known ? b.samples->eye_in_hand : !o.eye_on_base;
    PoseSeries flange{{}, b.samples->base_from_effector};
    if (!b.samples->kind_is_known && o.eye_on_base)
      for (Rigid& pose : flange.poses) pose = inverse(pose);
    return from_flange(flange, {{}, b.samples->camera_from_target}, in_hand, o, std::move(c));
  }
  if (!b.joints && b.poses.size() == 2) {
    const auto [flange, target] = flange_and_target(b.poses);
    return from_flange(flange, target, !o.eye_on_base, o, std::move(c));
  }
  if (!robot && !b.joints && b.poses.size() == 1 && !b.image_folders.empty())
    return from_flange_images(b, o, std::move(c));
  if (!robot) throw InputError("There is no robot; name its URDF with --robot, or a table of its flange's poses.");
  if (!b.image_folders.empty()) return from_images(*robot, b, o, std::move(c));
  if (!b.joints) throw InputError("There are no joint readings; name a table (CSV) of them, a column a joint.");
  if (b.points) return from_points(*robot, *b.joints, *b.points, {}, o, std::move(c));
  if (b.poses.size() == 1) return from_poses(*robot, *b.joints, b.poses[0].series, o, std::move(c));
  throw InputError(
      "There is nothing that a sensor measured: no images, no points, no poses of a target. Name their folder "
      "or file too.");
}

}  // namespace

Conversion convert(const std::vector<fs::path>& given, const ConvertOptions& o) {
  if (fs::exists(o.out / "session.xml"))
    throw InputError(fmt::format("{}: there is a session already; take another folder.", shown_path(o.out)));
  Conversion c;
  std::vector<fs::path> files = given;
  const std::optional<FieldUrdf> robot = find_robot(files, o, c);
  if (robot) c.notes.insert(c.notes.end(), robot->notes.begin(), robot->notes.end());
  const Brought b = bring(files, robot ? &robot->robot : nullptr, o.degrees);
  c.took.insert(c.took.end(), b.took.begin(), b.took.end());
  c.notes.insert(c.notes.end(), b.notes.begin(), b.notes.end());
  ask_whether_to_go_on(o);
  c = assemble(robot, b, o, std::move(c));
  for (const std::string& doubt : session_doubts(c.session)) c.notes.push_back(doubt);
  return c;
}

}  // namespace handsight
