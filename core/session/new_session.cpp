// SPDX-License-Identifier: Apache-2.0
#include "session/new_session.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "robot/urdf.h"
#include "session/session_xml.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

bool lies_below(const fs::path& file, const fs::path& folder) {
  const fs::path relative = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(folder));
  return !relative.empty() && *relative.begin() != "..";
}

void check_count(const NewSession& parts, std::size_t measured, const char* what) {
  if (parts.positions.size() == measured) return;
  throw InputError(message("There are {} {} for {} {}; each instant needs one of each, in the same order.",
                           parts.positions.size(), parts.urdf.empty() ? "poses of the flange" : "lines of joint angles",
                           measured, what));
}

void check_cameras(const NewSession& parts) {
  for (const RigCamera& c : parts.rig.cameras)
    if (c.camera.width <= 0 || c.camera.height <= 0)
      throw InputError(message("The size of the images is not known; the {}calibration does not name it.",
                               parts.rig.count() == 2 ? "stereo " : ""));
  for (const InstantImages& instant : parts.images)
    if (static_cast<int>(instant.files.size()) != parts.rig.count())
      throw InputError(message("There are images of {} cameras and a calibration of {}; each camera needs both.",
                               instant.files.size(), parts.rig.count()));
}

void check_parts(const NewSession& parts, const Robot& robot) {
  if (fs::exists(parts.folder / "session.xml"))
    throw InputError(message("{}: there is a session already; take another folder.", shown_path(parts.folder)));
  const bool has_cameras = parts.rig.count() > 0;
  if (has_cameras)
    check_count(parts, parts.images.size(), "images");
  else
    check_count(parts, parts.target_poses.size(), "poses of the target");
  if (parts.positions.empty()) throw InputError("A session needs at least one observation; there is no pose.");
  for (const std::string& link : {parts.tcp, parts.mount})
    if (find_link(robot, link) < 0)
      throw InputError(
          parts.urdf.empty()
              ? message("There is no link {}: a robot of poses has \"base\" and \"flange\".", in_quotes(link))
              : message("{}: has no link {}.", shown_path(parts.urdf), in_quotes(link)));
  check_cameras(parts);
}

/// The folder of each camera's images in the session: one for all unless their names are the same.
std::vector<fs::path> folders_of_images(const NewSession& parts) {
  bool twins = false;
  for (const InstantImages& instant : parts.images)
    for (std::size_t i = 0; i < instant.files.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        twins = twins || (!instant.files[i].empty() && instant.files[i].filename() == instant.files[j].filename());
  std::vector<fs::path> folders;
  for (const RigCamera& camera : parts.rig.cameras)
    folders.push_back(twins ? fs::path("images") / camera.name : fs::path("images"));
  return folders;
}

/// The images of one instant into the session. A pair of anonymous markers is whole or not at all.
void bring_images(const NewSession& parts, const InstantImages& instant, const std::vector<fs::path>& into,
                  Observation& o, std::vector<Message>* notes) {
  const auto is_missing = [](const fs::path& file) { return file.empty(); };
  const bool is_whole = std::none_of(instant.files.begin(), instant.files.end(), is_missing);
  if (!is_whole && !parts.target && parts.rig.count() == 2) {
    const auto there = std::find_if_not(instant.files.begin(), instant.files.end(), is_missing);
    if (notes && there != instant.files.end())
      notes->push_back(message("{} has no partner and is left out; observation {} has no images.",
                               there->filename().string(), o.id));
    return;
  }
  for (std::size_t c = 0; c < instant.files.size(); ++c)
    if (!instant.files[c].empty()) o.images[c] = bring_into(instant.files[c], parts.folder, into[c]);
}

/// Cameras' names stand as attributes, which begin with no digit.
Rig with_names_for_xml(Rig rig, std::vector<Message>* notes) {
  for (RigCamera& camera : rig.cameras) {
    if (camera.name.empty() || std::isdigit(static_cast<unsigned char>(camera.name[0])) == 0) continue;
    const std::string name = "camera_" + camera.name;
    if (notes) notes->push_back(message("The camera {} is called {} in the session.", camera.name, name));
    camera.name = name;
  }
  return rig;
}

Session observed_session(const NewSession& parts, const Robot& robot, std::vector<Message>* notes) {
  Session s;
  s.file = parts.folder / "session.xml";
  s.title = parts.title;
  if (!robot.is_of_poses) s.robot_file = bring_into(parts.urdf, parts.folder, "");
  s.tcp = parts.tcp;
  s.mount = {parts.mount, parts.mount_from_sensor, !parts.mount_is_known, parts.mount_is_known};
  if (parts.rig.count() > 0)
    s.rig = with_names_for_xml(parts.rig, notes);
  else
    s.pose_sensor = PoseSensor{};
  s.marker_count = parts.marker_count;
  if (parts.target) set_target(s, *parts.target);
  s.joints = parts.joints;
  const std::vector<fs::path> into = folders_of_images(parts);
  for (std::size_t i = 0; i < parts.positions.size(); ++i) {
    Observation o;
    o.id = static_cast<std::int64_t>(i);
    o.time = static_cast<double>(i);
    o.position = parts.positions[i];
    if (s.rig)
      bring_images(parts, parts.images[i], into, o, notes);
    else
      o.target_pose = parts.target_poses[i];
    s.observations.push_back(std::move(o));
  }
  s.robot = robot;
  return s;
}

}  // namespace

std::string bring_into(const fs::path& file, const fs::path& folder, const fs::path& into) {
  if (lies_below(file, folder))
    return fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(folder)).generic_string();
  std::error_code error;
  fs::create_directories(folder / into, error);
  const fs::path name = into / file.filename();
  replace_file(folder / name, read_file(file));
  return name.generic_string();
}

std::vector<std::string> joints_of_table(const fs::path& table, const Robot& robot) {
  const std::string text = read_file(table);
  std::string line;
  for (std::size_t begin = 0; begin < text.size() && line.empty();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    line = text.substr(begin, end - begin);
    line.resize(std::min(line.find('#'), line.size()));
    for (char& c : line)
      if (c == ',' || c == ';' || c == '"' || c == '\'' || c == '\r') c = ' ';
    if (split_words(line).empty()) line.clear();
    begin = end + 1;
  }
  const std::vector<std::string> all = joint_names(robot);
  std::vector<std::string> named;
  for (const std::string_view word : split_words(line))
    if (std::find(all.begin(), all.end(), word) != all.end()) named.emplace_back(word);
  return named.empty() ? all : named;
}

void set_flange_poses(NewSession& parts, const std::vector<Rigid>& flange_poses) {
  parts.urdf.clear();
  parts.joints = joint_names(poses_robot());
  parts.positions.clear();
  for (const Rigid& pose : flange_poses) parts.positions.emplace_back(make_position(pose));
}

Session make_session(const NewSession& parts, std::vector<Message>* notes) {
  const Robot robot = parts.urdf.empty() ? poses_robot() : read_urdf(parts.urdf, notes);
  check_parts(parts, robot);
  std::error_code error;
  fs::create_directories(parts.folder, error);
  if (error)
    throw InputError(message("{}: the folder cannot be made ({}).", shown_path(parts.folder), system_text(error)));
  const Session s = observed_session(parts, robot, notes);
  replace_file(s.file, session_text(s));
  try {
    return read_session(s.file);
  } catch (const InputError&) {
    fs::remove(s.file, error);
    throw;
  }
}

}  // namespace handsight
