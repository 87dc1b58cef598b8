// SPDX-License-Identifier: Apache-2.0
#include "convert/session_parts.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "robot/urdf.h"
#include "session/new_session.h"
#include "session/session_xml.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(message("{}: the folder cannot be made ({}).", shown_path(folder), system_text(error)));
}

std::string make_title(const ConvertOptions& o) { return o.title.empty() ? o.out.filename().string() : o.title; }

/// Seconds since the first observation.
double time_of(const SessionParts& parts, std::size_t i) {
  return parts.times.empty() ? static_cast<double>(i) : parts.times[i] - parts.times.front();
}

/// Nothing half made stays where the session cannot be read back.
Session read_back(const fs::path& file) {
  try {
    return read_session(file);
  } catch (const InputError&) {
    std::error_code error;
    fs::remove(file, error);
    throw;
  }
}

void require_link(const Robot& robot, const std::string& name, const char* option) {
  if (find_link(robot, name) >= 0) return;
  throw InputError(message("{} {}: the robot has no such link; it has: {}.", option, in_quotes(name),
                           shortened(fmt::format("{}", fmt::join(link_names(robot), " ")), 300)));
}

void add_points(const std::vector<std::optional<Vector3>>& points, Session& s, Observation& o) {
  for (std::size_t m = 0; m < points.size(); ++m)
    if (points[m]) o.sightings.push_back({.marker = static_cast<int>(m), .point = points[m]});
  s.marker_count = std::max(s.marker_count, static_cast<int>(points.size()));
}

}  // namespace

Session write_measured_session(const SessionParts& parts, const ConvertOptions& o) {
  const bool is_flange = parts.urdf_text.empty();
  Session s;
  s.robot = is_flange ? poses_robot() : parse_urdf(parts.urdf_text, "robot.urdf", nullptr);
  require_link(s.robot, parts.tcp, "--tcp");
  require_link(s.robot, parts.mount, "--mount");
  s.file = o.out / "session.xml";
  s.title = make_title(o);
  if (!is_flange) s.robot_file = "robot.urdf";
  s.tcp = parts.tcp;
  s.mount = {parts.mount, Rigid{}, true, false};
  s.joints = parts.joints.names;
  if (!parts.target_poses.empty())
    s.pose_sensor = PoseSensor{o.sigma, o.sigma_angle};
  else
    s.sigma_point = o.sigma;
  for (std::size_t i = 0; i < parts.joints.positions.size(); ++i) {
    Observation& observation = s.observations.emplace_back();
    observation.id = static_cast<std::int64_t>(i);
    observation.time = time_of(parts, i);
    observation.position = parts.joints.positions[i];
    if (s.pose_sensor)
      observation.target_pose = parts.target_poses[i];
    else
      add_points(parts.points[i], s, observation);
  }
  ask_whether_to_go_on(o);
  make_folder(o.out);
  if (!is_flange) replace_file(o.out / "robot.urdf", parts.urdf_text);
  replace_file(s.file, session_text(s));
  return read_back(s.file);
}

Session write_camera_session(const SessionParts& parts, const Rig& rig, const std::vector<InstantImages>& images,
                             const ConvertOptions& o, std::vector<Message>& notes) {
  const bool is_flange = parts.urdf_text.empty();
  const Robot robot = is_flange ? poses_robot() : parse_urdf(parts.urdf_text, "robot.urdf", nullptr);
  require_link(robot, parts.tcp, "--tcp");
  require_link(robot, parts.mount, "--mount");
  make_folder(o.out);
  if (!is_flange) replace_file(o.out / "robot.urdf", parts.urdf_text);
  NewSession made;
  made.folder = o.out;
  made.title = make_title(o);
  if (!is_flange) made.urdf = o.out / "robot.urdf";
  made.tcp = parts.tcp;
  made.mount = parts.mount;
  made.rig = rig;
  made.marker_count = o.markers;
  made.target = o.target;
  if (made.target && o.sigma) made.target->sigma = o.sigma;
  made.joints = parts.joints.names;
  made.positions = parts.joints.positions;
  made.images = images;
  Session s = make_session(made, &notes);
  if (!parts.times.empty()) {
    for (std::size_t i = 0; i < s.observations.size(); ++i) s.observations[i].time = time_of(parts, i);
    s.source.reset();  // times are written anew
    replace_file(s.file, session_text(s));
    s = read_back(s.file);
  }
  return s;
}

}  // namespace handsight
