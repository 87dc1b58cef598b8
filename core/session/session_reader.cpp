// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <unordered_set>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "print/tag_places_xml.h"
#include "print/target_xml.h"
#include "robot/xml_rigid.h"
#include "session/observation_xml.h"
#include "session/pose_points.h"
#include "session/session_xml.h"
#include "session/touch_xml.h"

namespace handsight {

namespace {

void read_robot_element(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"file", "tcp", "kind", "repeatability"}, {});
  session.repeatability = find_positive(node, "repeatability", bounds::repeatability);
  if (find_choice(node, "kind", {"urdf", "poses"}).value_or(0) == 1) {
    session.robot = poses_robot();
    for (const Joint& joint : session.robot.joints) session.joints.push_back(joint.name);
    session.tcp = find_name(node, "tcp").value_or("flange");
    return;
  }
  session.robot_file = required_name(node, "file");
  session.tcp = required_name(node, "tcp");
}

void read_gravity(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"xyz"}, {});
  session.gravity = Vector3(required_numbers(node, "xyz", 3, bounds::gravity).data());
}

Mount read_mount(const XmlNode& device, const char* tag, Ignored& ignored) {
  const XmlNode node = required_child(device, tag);
  note_unknown(ignored, node, {"xyz", "rpy", "estimate"}, {});
  Mount mount;
  mount.link = required_name(device, "mount");
  mount.mount_from_sensor = read_rigid(node);
  mount.estimate = find_choice(node, "estimate", {"no", "yes"}).value_or(0) == 1;
  mount.known = !mount.estimate || node.element->Attribute("xyz") || node.element->Attribute("rpy");
  return mount;
}

Camera read_camera(const XmlNode& node, Ignored& ignored, std::initializer_list<std::string_view> inside = {}) {
  note_unknown(ignored, node,
               {"name", "width", "height", "model", "fx", "fy", "skew", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4",
                "k5", "k6"},
               inside);
  constexpr int largest_side = 1'000'000;
  const auto distortion = [&](const char* attribute) {
    return find_number(node, attribute, bounds::distortion).value_or(0);
  };
  Camera camera;
  camera.width = static_cast<int>(required_integer(node, "width", 1, largest_side));
  camera.height = static_cast<int>(required_integer(node, "height", 1, largest_side));
  camera.fx = required_positive(node, "fx", bounds::focal_length);
  camera.fy = required_positive(node, "fy", bounds::focal_length);
  camera.cx = required_number(node, "cx", bounds::pixel);
  camera.cy = required_number(node, "cy", bounds::pixel);
  camera.skew = find_number(node, "skew", bounds::pixel).value_or(0);
  camera.k1 = distortion("k1");
  camera.k2 = distortion("k2");
  camera.p1 = distortion("p1");
  camera.p2 = distortion("p2");
  camera.k3 = distortion("k3");
  camera.is_fisheye = find_choice(node, "model", {"brown", "fisheye"}).value_or(0) == 1;
  camera.k4 = distortion("k4");
  camera.k5 = distortion("k5");
  camera.k6 = distortion("k6");
  const bool has_others = camera.p1 != 0 || camera.p2 != 0 || camera.k5 != 0 || camera.k6 != 0;
  if (camera.is_fisheye && has_others)
    refuse(node,
           "has model=\"fisheye\" with one of p1, p2, k5, k6, expected k1 k2 k3 k4: those of Brown's model mean "
           "something else.");
  return camera;
}

void read_pair(const XmlNode& stereo, StereoRig& rig, Ignored& ignored) {
  bool has_left = false, has_right = false;
  for (const XmlNode& node : children(stereo, "camera")) {
    required_text(node, "name");
    const bool is_left = find_choice(node, "name", {"left", "right"}) == 0u;
    bool& has = is_left ? has_left : has_right;
    if (has)
      refuse(node, message("is a second camera with name=\"{}\", expected one left and one right.",
                           is_left ? "left" : "right"));
    has = true;
    (is_left ? rig.left : rig.right) = read_camera(node, ignored);
  }
  if (!has_left || !has_right)
    refuse(stereo,
           message("has no <camera name=\"{}\">, expected one left and one right.", has_left ? "right" : "left"));
}

void read_stereo(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"mount"}, {"mount_from_left", "right_from_left", "camera"});
  session.mount = read_mount(node, "mount_from_left", ignored);
  const XmlNode right = required_child(node, "right_from_left");
  note_unknown(ignored, right, {"xyz", "rpy"}, {});
  StereoRig rig;
  rig.right_from_left = read_rigid(right);
  if (rig.right_from_left.translation.cwiseAbs().maxCoeff() < 1e-9)
    refuse(right, "has no translation, expected the two cameras apart: without a baseline there is no depth.");
  read_pair(node, rig, ignored);
  session.rig = make_rig(rig);
}

/// Letters, digits and _, and none of what else stands as an attribute beside it.
std::string read_camera_name(const XmlNode& node, const Rig& rig) {
  std::string name = required_name(node, "name");
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  if (name.size() > 40 || !std::all_of(name.begin(), name.end(), is_plain))
    refuse(node, message("has name={}, expected at most 40 letters, digits and _.", in_quotes(name)));
  for (const char* taken : {"index", "by", "point", "sigma"})
    if (name == taken)
      refuse(node,
             message("has name=\"{}\", which markers have as an attribute already, expected another name.", name));
  for (const RigCamera& other : rig.cameras)
    if (other.name == name || other.name == name + "_sigma" || other.name + "_sigma" == name)
      refuse(node, message("has name=\"{}\" beside the camera \"{}\", expected names that differ, and none that "
                           "is another's with _sigma behind it.",
                           name, other.name));
  return name;
}

void read_cameras(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"mount"}, {"mount_from_first", "camera"});
  session.mount = read_mount(node, "mount_from_first", ignored);
  Rig& rig = session.rig.emplace();
  for (const XmlNode& child : children(node, "camera")) {
    if (rig.count() == max_cameras) refuse(child, message("is one too many, expected at most {}.", max_cameras));
    RigCamera camera{read_camera_name(child, rig), read_camera(child, ignored, {"from_first"}), Rigid()};
    const auto from_first = find_child(child, "from_first");
    if (from_first) {
      note_unknown(ignored, *from_first, {"xyz", "rpy"}, {});
      camera.camera_from_first = read_rigid(*from_first);
    }
    if (rig.count() == 0 && from_first)
      refuse(*from_first, "stands in the first camera, expected none there: the first is the reference.");
    if (rig.count() > 0 && !from_first)
      refuse(child, "has no <from_first>, expected where it is: X of this camera = R X of the first + t.");
    rig.cameras.push_back(std::move(camera));
  }
  if (rig.count() == 0) refuse(node, "holds no <camera>, expected one to eight.");
}

void read_tracker(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"mount", "sigma"}, {"mount_from_tracker"});
  session.mount = read_mount(node, "mount_from_tracker", ignored);
  session.sigma_point = find_positive(node, "sigma", bounds::sigma_point);
}

void read_pose_sensor(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"mount", "sigma", "sigma_angle"}, {"mount_from_sensor"});
  session.mount = read_mount(node, "mount_from_sensor", ignored);
  session.pose_sensor = PoseSensor{find_positive(node, "sigma", bounds::sigma_point),
                                   find_positive(node, "sigma_angle", bounds::sigma_point)};
}

/// Returns the device's line.
int read_device(const XmlNode& root, Session& session, Ignored& ignored) {
  std::optional<XmlNode> found;
  for (const char* tag : {"stereo", "cameras", "tracker", "pose_sensor", "touch"})
    if (const auto device = find_child(root, tag)) {
      if (found)
        refuse(*device, message("stands beside the <{}> of line {}, expected one of the two.", found->element->Name(),
                                found->line()));
      found = device;
    }
  if (!found)
    refuse(root,
           "has neither <stereo> nor <tracker> nor <cameras> nor <pose_sensor> nor <touch>, expected one of them.");
  const std::string tag = found->element->Name();
  (tag == "stereo"    ? read_stereo
   : tag == "cameras" ? read_cameras
   : tag == "tracker" ? read_tracker
   : tag == "touch"   ? read_touch
                      : read_pose_sensor)(*found, session, ignored);
  return found->line();
}

void read_noise(const XmlNode& node, Session& session) {
  session.sigma_pixel = find_positive(node, "sigma_pixel", bounds::sigma_pixel);
  if (!session.sigma_pixel || !session.is_tracker()) return;
  session.sigma_pixel.reset();
  session.notes.push_back(message("{}, line {}: sigma_pixel has no meaning in a tracker session and is ignored.",
                                  shortened(node.file, 80), node.line()));
}

void read_markers_element(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {"count", "sigma_pixel"}, {});
  session.marker_count = static_cast<int>(required_integer(node, "count", 1, 64));
  read_noise(node, session);
}

/// The target of a pose sensor, whose whole pose is reported.
void read_pose_target(const XmlNode& root, Ignored& ignored) {
  const XmlNode target = required_child(root, "target");
  note_unknown(ignored, target, {"kind"}, {});
  required_text(target, "kind");
  find_choice(target, "kind", {"pose"});
}

/// A board or tags whose points name themselves.
void read_target_element(const XmlNode& node, Session& session, Ignored& ignored) {
  std::vector<std::string> attributes = target_attributes();
  attributes.emplace_back("sigma_pixel");
  note_unknown(ignored, node, attributes, {"tag"});
  for (const XmlNode& tag : children(node, "tag")) note_unknown(ignored, tag, tag_attributes(), {});
  if (required_text(node, "kind") == "pose")
    refuse(node, "has kind=\"pose\", which needs a <pose_sensor> in place of cameras or a tracker.");
  if (session.is_tracker())
    refuse(node, "is found in images, and this session has a <tracker>; expected <cameras>, or <markers count=\"\"/>.");
  const Target target = read_target(node);
  if (point_count(target) > most_session_points)
    refuse(node, message("has {} points, expected at most {}: a fit with more takes minutes and is no surer; use a "
                         "board with fewer squares or tags.",
                         point_count(target), most_session_points));
  set_target(session, target);
  read_noise(node, session);
  if (looks_the_same_turned(target))
    session.notes.push_back(message(
        "{}, line {}: this chessboard looks the same after half a turn; the robot's motion tells how it lies from one "
        "observation to the next, but not which end is the first. One of an even and an odd number of corners cannot "
        "be "
        "mistaken.",
        shortened(node.file, 80), node.line()));
}

/// What the sensor looks at: markers, a target, or a target whose whole pose it tells.
void read_markers_or_target(const XmlNode& root, Session& session, Ignored& ignored) {
  if (session.pose_sensor) return read_pose_target(root, ignored);
  if (session.is_touch() && !find_child(root, "markers")) {
    session.marker_count = 1;  // the probe's tip
    return;
  }
  const auto target = find_child(root, "target"), markers = find_child(root, "markers");
  if (target && markers)
    refuse(*target, message("stands beside the <markers> of line {}, expected one of the two.", markers->line()));
  if (target) return read_target_element(*target, session, ignored);
  read_markers_element(required_child(root, "markers"), session, ignored);
}

void read_joints(const XmlNode& node, Session& session, Ignored& ignored) {
  note_unknown(ignored, node, {}, {}, true);
  const std::string names = inner_text(node);
  std::unordered_set<std::string_view> seen;
  for (const std::string_view name : split_words(names)) {
    if (!seen.insert(name).second)
      refuse(node, message("names joint {} a second time, expected each joint once.", in_quotes(name)));
    session.joints.emplace_back(name);
  }
  if (session.joints.empty()) refuse(node, "names no joint, expected those that the observations' vectors hold.");
}

void read_observations(const XmlNode& node, Session& session, SessionLines& lines, Ignored& ignored) {
  note_unknown(ignored, node, {}, {"observation"});
  std::unordered_set<std::int64_t> ids;
  for (const XmlNode& child : children(node, "observation")) {
    Observation observation = read_observation(child, session, ignored);
    if (!ids.insert(observation.id).second)
      refuse(child, message("has id=\"{}\" a second time, expected each id once.", observation.id));
    if (!session.observations.empty() && observation.time < session.observations.back().time)
      refuse(child, message("has time=\"{}\" after {} of the observation before, expected times that do not go back.",
                            observation.time, session.observations.back().time));
    session.observations.push_back(std::move(observation));
    lines.observations.push_back(child.line());
  }
  if (session.observations.empty()) refuse(node, "holds no observation, expected at least one <observation>.");
}

/// Pixels far outside the image are no error of the format, but hardly right either.
void note_outside(Session& session, std::string_view file) {
  if (session.is_tracker()) return;
  int outside = 0;
  const auto is_outside = [](const Camera& camera, const Vector2& pixel) {
    return pixel.x() < -0.5 || pixel.y() < -0.5 || pixel.x() > camera.width - 0.5 || pixel.y() > camera.height - 0.5;
  };
  for (const Observation& observation : session.observations)
    for (const Sighting& sighting : observation.sightings)
      for (const CameraPoint& seen : sighting.in_cameras)
        outside += is_outside(session.rig->at(seen.camera).camera, seen.pixel);
  if (outside > 0)
    session.notes.push_back(
        message("{}: markers lie outside their camera's image ({} positions).", shortened(file, 80), outside));
}

}  // namespace

Session parse_session(const std::string& text, const std::string& file, SessionLines* lines) {
  const auto document = parse_xml(text, file);
  const XmlNode root = require_root(*document, file, "handsight_session");
  require_version_1(root);
  Ignored ignored;
  note_unknown(ignored, root, {"version", "title"},
               {"robot", "gravity", "stereo", "cameras", "tracker", "pose_sensor", "touch", "target", "markers",
                "joints", "observations"});
  SessionLines found;
  Session session;
  session.title = find_name(root, "title").value_or("");
  const XmlNode robot = required_child(root, "robot");
  found.robot = robot.line();
  read_robot_element(robot, session, ignored);
  if (const auto gravity = find_child(root, "gravity")) read_gravity(*gravity, session, ignored);
  found.device = read_device(root, session, ignored);
  read_markers_or_target(root, session, ignored);
  for (SessionPart& fixture : session.parts) fixture.marker_count = session.marker_count;
  if (!session.robot.is_of_poses) {
    const XmlNode joints = required_child(root, "joints");
    found.joints = joints.line();
    read_joints(joints, session, ignored);
  }
  const auto observations = find_child(root, "observations");
  if (!observations) refuse(root, "has no <observations>, so there is no observation, expected at least one.");
  read_observations(*observations, session, found, ignored);
  note_outside(session, file);
  if (session.pose_sensor) show_poses(session, pose_lever(*session.pose_sensor));
  for (Message& sentence : ignored_sentences(ignored, file)) session.notes.push_back(std::move(sentence));
  session.source = std::make_shared<const std::string>(text);
  if (lines) *lines = std::move(found);
  return session;
}

}  // namespace handsight
