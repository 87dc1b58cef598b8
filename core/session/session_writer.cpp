// SPDX-License-Identifier: Apache-2.0
#include <unordered_map>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "print/target_xml.h"
#include "robot/xml_rigid.h"
#include "session/observation_xml.h"
#include "session/session_xml.h"
#include "session/touch_xml.h"

namespace handsight {

namespace {

using tinyxml2::XMLElement;

void set(XMLElement& element, const char* attribute, double number) {
  element.SetAttribute(attribute, format_number(number).c_str());
}

void write_mount(XMLElement& device, const char* tag, const Mount& mount) {
  device.SetAttribute("mount", mount.link.c_str());
  XMLElement& element = *device.InsertNewChildElement(tag);
  if (mount.known) write_rigid(element, mount.mount_from_sensor);
  element.SetAttribute("estimate", mount.estimate ? "yes" : "no");
}

XMLElement& write_camera(XMLElement& parent, const std::string& name, const Camera& camera) {
  XMLElement& element = *parent.InsertNewChildElement("camera");
  element.SetAttribute("name", name.c_str());
  element.SetAttribute("width", camera.width);
  element.SetAttribute("height", camera.height);
  const std::pair<const char*, double> numbers[] = {
      {"fx", camera.fx}, {"fy", camera.fy}, {"skew", camera.skew}, {"cx", camera.cx}, {"cy", camera.cy},
      {"k1", camera.k1}, {"k2", camera.k2}, {"p1", camera.p1},     {"p2", camera.p2}, {"k3", camera.k3}};
  if (camera.is_fisheye) element.SetAttribute("model", "fisheye");
  for (const auto& [attribute, number] : numbers)
    if (!camera.is_fisheye || attribute[0] != 'p') set(element, attribute, number);
  if (camera.is_fisheye || camera.k4 != 0 || camera.k5 != 0 || camera.k6 != 0) set(element, "k4", camera.k4);
  if (camera.k5 != 0 || camera.k6 != 0) set(element, "k5", camera.k5);
  if (camera.k6 != 0) set(element, "k6", camera.k6);
  return element;
}

void write_cameras(XMLElement& device, const Session& session) {
  write_mount(device, "mount_from_first", session.mount);
  for (int c = 0; c < session.rig->count(); ++c) {
    const RigCamera& camera = session.rig->at(c);
    XMLElement& element = write_camera(device, camera.name, camera.camera);
    if (c > 0) write_rigid(*element.InsertNewChildElement("from_first"), camera.camera_from_first);
  }
}

void write_device(XMLElement& root, const Session& session) {
  if (session.is_touch()) return write_touch(root, session);
  XMLElement& device = *root.InsertNewChildElement(device_tag(session));
  if (session.pose_sensor) {
    if (session.pose_sensor->sigma) set(device, "sigma", *session.pose_sensor->sigma);
    if (session.pose_sensor->sigma_angle) set(device, "sigma_angle", *session.pose_sensor->sigma_angle);
    return write_mount(device, "mount_from_sensor", session.mount);
  }
  if (session.is_tracker()) {
    if (session.sigma_point) set(device, "sigma", *session.sigma_point);
    return write_mount(device, "mount_from_tracker", session.mount);
  }
  if (!is_left_and_right(*session.rig)) return write_cameras(device, session);
  write_mount(device, "mount_from_left", session.mount);
  write_rigid(*device.InsertNewChildElement("right_from_left"), session.rig->at(1).camera_from_first);
  for (const RigCamera& camera : session.rig->cameras) write_camera(device, camera.name, camera.camera);
}

void write_markers_or_target(XMLElement& root, const Session& session) {
  if (session.pose_sensor) return root.InsertNewChildElement("target")->SetAttribute("kind", "pose");
  if (session.is_touch() && session.marker_count == 1) return;
  XMLElement& element = *root.InsertNewChildElement(session.target ? "target" : "markers");
  if (session.target)
    write_target(element, *session.target);
  else
    element.SetAttribute("count", session.marker_count);
  if (session.sigma_pixel) set(element, "sigma_pixel", *session.sigma_pixel);
}

std::string text_from_scratch(const Session& session) {
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewDeclaration());
  XMLElement& root = *document.NewElement("handsight_session");
  document.InsertEndChild(&root);
  root.SetAttribute("version", 1);
  root.SetAttribute("title", session.title.c_str());
  XMLElement& robot = *root.InsertNewChildElement("robot");
  if (session.robot.is_of_poses)
    robot.SetAttribute("kind", "poses");
  else
    robot.SetAttribute("file", session.robot_file.c_str());
  robot.SetAttribute("tcp", session.tcp.c_str());
  if (session.repeatability) set(robot, "repeatability", *session.repeatability);
  root.InsertNewChildElement("gravity")->SetAttribute("xyz", format_numbers({session.gravity.data(), 3}).c_str());
  write_device(root, session);
  write_markers_or_target(root, session);
  if (!session.robot.is_of_poses)
    root.InsertNewChildElement("joints")->SetText(fmt::format("{}", fmt::join(session.joints, " ")).c_str());
  XMLElement& observations = *root.InsertNewChildElement("observations");
  for (const Observation& observation : session.observations) write_observation(observations, session, observation);
  return xml_text(document);
}

/// Readers refuse a time that goes back: elements that are out of order are moved, with nothing touched where
/// none is.
void bring_to_order(XMLElement& parent, const std::vector<Observation>& observations) {
  std::unordered_map<std::int64_t, XMLElement*> elements;
  bool in_order = true;
  std::size_t place = 0;
  for (auto* element = parent.FirstChildElement("observation"); element;
       element = element->NextSiblingElement("observation"), ++place) {
    const std::int64_t id = element->Int64Attribute("id", -1);
    elements[id] = element;
    in_order = in_order && place < observations.size() && observations[place].id == id;
  }
  if (in_order) return;
  for (const Observation& observation : observations) parent.InsertEndChild(elements.at(observation.id));
}

/// The text as it was read, with the markers and decisions of `session`.
std::string updated_text(const Session& session) {
  const auto document = parse_xml(*session.source, session.file.filename().string());
  XMLElement* root = document->RootElement();
  check(root != nullptr, "the session's source holds no element");
  XMLElement* parent = root->FirstChildElement("observations");
  check(parent != nullptr, "the session's source holds no <observations>");
  std::unordered_map<std::int64_t, const Observation*> wanted;
  for (const Observation& observation : session.observations) wanted.emplace(observation.id, &observation);
  XMLElement* next = nullptr;
  for (auto* element = parent->FirstChildElement("observation"); element; element = next) {
    next = element->NextSiblingElement("observation");
    const auto found = wanted.find(element->Int64Attribute("id", -1));
    if (found == wanted.end()) {
      parent->DeleteChild(element);
      continue;
    }
    update_observation(*element, session, *found->second);
    wanted.erase(found);
  }
  for (const Observation& observation : session.observations)
    if (wanted.contains(observation.id)) write_observation(*parent, session, observation);
  bring_to_order(*parent, session.observations);
  return xml_text(*document);
}

}  // namespace

std::string session_text(const Session& session) {
  if (!session.parts.empty() && !session.is_touch())
    throw InputError(
        "A collection of several sessions is not written as one; change and save its sessions one by one.");
  return session.source ? updated_text(session) : text_from_scratch(session);
}

void save_session(const Session& session) { replace_file(session.file, session_text(session)); }

void replace_session(const Session& session) {
  if (!session.source) return save_session(session);
  replace_unchanged_file(session.file, session_text(session), digest_of_content(*session.source));
}

}  // namespace handsight
