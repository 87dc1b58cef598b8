// SPDX-License-Identifier: Apache-2.0
// A session's folder: its file, its robot, and where its images may lie.
#include <algorithm>
#include <cstdlib>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "robot/urdf.h"
#include "session/session_xml.h"

namespace handsight {

namespace fs = std::filesystem;

namespace {

std::string file_name(const Session& session) {
  return session.file.empty() ? "session.xml" : session.file.filename().string();
}

[[noreturn]] void refuse_joint(const Session& session, const SessionLines& lines, const std::string& name,
                               const char* why) {
  refuse(file_name(session), lines.joints,
         message("<joints> names {}, {}, expected joints of the robot that move by themselves.", in_quotes(name), why));
}

void require_link(const Session& session, int line, std::string_view what, const std::string& name) {
  if (find_link(session.robot, name) < 0)
    refuse(file_name(session), line,
           message("{}={} is no link of the robot, expected the name of a link in {}.", what, in_quotes(name),
                   in_quotes(session.robot_file, 100)));
}

/// The session's file, where `path` may be its folder.
fs::path file_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    if (!fs::exists(path, error))
      throw InputError(message("{}: there is no such file or folder, expected a session's folder or its session.xml.",
                               shown_path(path)));
    return path;
  }
  fs::path file = path / "session.xml";
  if (!fs::exists(file, error) && fs::exists(path / "collection.xml", error))
    throw InputError(
        message("{}: the folder holds a collection of several sessions, expected one session's folder; open one of "
                "them here, or give the collection to handsight-cli fit or improve.",
                shown_path(path)));
  if (!fs::exists(file, error))
    throw InputError(message("{}: the folder holds no session.xml, expected a session's folder.", shown_path(path)));
  return file;
}

bool is_inside(const fs::path& file, const fs::path& home) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(home, error);
  return !error && std::mismatch(real.begin(), real.end(), file.begin(), file.end()).first == real.end();
}

/// A session that comes from somewhere must not have any file of this computer read and told of.
void require_allowed(const fs::path& robot, const Session& session, const SessionLines& lines) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(robot, error);
  const fs::path home = fs::weakly_canonical(folder(session).empty() ? "." : folder(session), error);
  bool is_allowed = !error && is_inside(real, home);
  for (fs::path above = home; !is_allowed && above.has_relative_path(); above = above.parent_path())
    is_allowed = is_inside(real, above.parent_path() / "robots");  // what several sessions share
  const char* const named = std::getenv(robot_folders_variable);
  std::string_view rest = named ? named : "";
  while (!is_allowed && !rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(one.size() + 1, rest.size()));
    is_allowed = fs::path(one).is_absolute() && is_inside(real, one);
  }
  if (!is_allowed)
    refuse(file_name(session), lines.robot,
           message("<robot> has file={}, which leads out of the session's folder, expected a URDF file inside it, in "
                   "a folder \"robots\" beside or above it, or in one that the environment variable {} names.",
                   in_quotes(session.robot_file, 150), robot_folders_variable));
}

Robot read_robot_of(Session& session, const SessionLines& lines) {
  if (session.robot.is_of_poses) return session.robot;
  const fs::path path = folder(session) / session.robot_file;
  require_allowed(path, session, lines);
  std::error_code error;
  if (!fs::is_regular_file(path, error))
    refuse(file_name(session), lines.robot,
           message("<robot> has file={}, which is not there, expected a URDF file, its "
                   "path relative to the session's folder.",
                   in_quotes(session.robot_file, 150)));
  return read_urdf(path, &session.notes);
}

}  // namespace

void bind_robot(Session& session, Robot robot, const SessionLines& lines) {
  session.robot = std::move(robot);
  for (const std::string& name : session.joints) {
    const int index = find_joint(session.robot, name);
    if (index < 0) refuse_joint(session, lines, name, "which the robot does not have");
    const Joint& joint = session.robot.joints[static_cast<std::size_t>(index)];
    if (!joint.moves()) refuse_joint(session, lines, name, "which is fixed");
    if (joint.is_mimic()) refuse_joint(session, lines, name, "which follows other joints (<mimic>)");
  }
  require_link(session, lines.robot, "<robot> tcp", session.tcp);
  std::vector<Mount*> mounts{&session.mount};
  for (Mount& mount : session.other_mounts) mounts.push_back(&mount);
  for (Mount* mount : mounts) {
    if (mount->link.empty() && session.is_touch()) mount->link = session.robot.links.front().name;
    require_link(session, lines.device, fmt::format("<{}> mount", device_tag(session)), mount->link);
  }
}

void check_image_paths(const Session& session, const SessionLines& lines) {
  std::error_code error;
  const fs::path home = fs::weakly_canonical(folder(session), error);
  if (error) return;  // nothing can be read there, whatever the paths say
  for (std::size_t i = 0; i < session.observations.size(); ++i)
    for (const std::string& image : session.observations[i].images) {
      if (image.empty()) continue;
      const fs::path real = fs::weakly_canonical(home / image, error);
      const bool is_inside =
          !error && std::mismatch(home.begin(), home.end(), real.begin(), real.end()).first == home.end();
      if (!is_inside)
        refuse(file_name(session), i < lines.observations.size() ? lines.observations[i] : 0,
               message("the image {} of observation {} leads out of the session's folder, expected "
                       "images inside it.",
                       in_quotes(image, 150), session.observations[i].id));
    }
}

std::vector<fs::path> list_files(const Session& session) {
  const fs::path home = folder(session);
  std::vector<fs::path> files{session.file};
  for (const std::string& name : {session.robot_file, std::string("truth.xml"), std::string("effects.xml")})
    if (!name.empty()) files.push_back(home / name);
  for (const Observation& o : session.observations)
    for (const std::string& image : o.images)
      if (!image.empty()) files.push_back(home / image);
  return files;
}

void require_no_session_file(const Session& session, const fs::path& output) {
  std::error_code error;
  for (const fs::path& file : list_files(session))
    if (fs::equivalent(file, output, error))
      throw InputError(
          message("{}: belongs to the session and is not written over; name another file.", shown_path(output)));
}

Session read_session(const fs::path& path) {
  const fs::path file = file_of(path);
  SessionLines lines;
  Session session = parse_session(read_file(file), file.filename().string(), &lines);
  session.file = file;
  Robot robot = read_robot_of(session, lines);
  bind_robot(session, std::move(robot), lines);
  check_image_paths(session, lines);
  session.effect_definitions = find_effect_definitions(file.parent_path(), user_effects_folder(), session.notes);
  return session;
}

}  // namespace handsight
