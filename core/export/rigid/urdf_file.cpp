// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/urdf_file.h"

#include <algorithm>

#include "base/numbers.h"
#include "base/text.h"
#include "base/xml.h"
#include "robot/xml_rigid.h"

namespace handsight {
namespace {

using tinyxml2::XMLElement;

bool is_identity(const Rigid& m) { return m.rotation.isIdentity(0) && m.translation.isZero(0); }

void set_origin(XMLElement& parent, const Rigid& motion) {
  XMLElement* origin = parent.FirstChildElement("origin");
  if (!origin) {
    origin = parent.GetDocument()->NewElement("origin");
    parent.InsertFirstChild(origin);
  }
  write_rigid(*origin, motion);
}

Rigid origin_of(const XMLElement& parent) {
  const XMLElement* origin = parent.FirstChildElement("origin");
  return origin ? read_rigid(XmlNode{origin, "the robot"}) : Rigid{};
}

XMLElement* named(XMLElement& root, const char* tag, const std::string& name) {
  for (XMLElement* e = root.FirstChildElement(tag); e; e = e->NextSiblingElement(tag))
    if (e->Attribute("name") && e->Attribute("name") == name) return e;
  check(false, "the URDF has no <{}> {}", tag, name);
  return nullptr;
}

/// What a link holds moves with its true frame, which is link_from_true away from the link's.
void move_contents(XMLElement& link, const Rigid& link_from_true) {
  for (const char* tag : {"inertial", "visual", "collision"})
    for (XMLElement* e = link.FirstChildElement(tag); e; e = e->NextSiblingElement(tag))
      set_origin(*e, link_from_true * origin_of(*e));
}

void set_mimics(XMLElement& element, const Joint& joint, const std::vector<JointChange>& changes, double error) {
  std::size_t i = 0;
  for (XMLElement* e = element.FirstChildElement("mimic"); e && i < joint.mimics.size();
       e = e->NextSiblingElement("mimic"), ++i) {
    const Mimic& m = joint.mimics[i];
    const double multiplier = m.multiplier + error;
    const double offset = m.offset + multiplier * changes[static_cast<std::size_t>(m.joint)].angle;
    if (multiplier != m.multiplier) e->SetAttribute("multiplier", format_number(multiplier).c_str());
    if (offset != m.offset) e->SetAttribute("offset", format_number(offset).c_str());
  }
}

/// Moves every joint's origin; returns where the true frame of every link is in the link's frame of the file.
std::vector<Rigid> move_joints(XMLElement& root, const Robot& robot, const std::vector<JointChange>& changes) {
  std::vector<Rigid> link_from_true(robot.links.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    const JointChange& c = changes[j];
    XMLElement& element = *named(root, "joint", joint.name);
    Rigid frame = link_from_true[static_cast<std::size_t>(joint.parent_link)] * joint.parent_from_joint *
                  small_motion<double>(c.frame);
    if (joint.kind == JointKind::prismatic)
      frame.translation += frame.rotation * (joint.axis * c.angle);
    else if (joint.moves())
      frame.rotation = frame.rotation * rotation_about<double>(joint.axis, c.angle);
    // Craig's Rz(theta) Tz(d) runs along the joint's axis, so that it may stand before the motion.
    frame = frame * joint.joint_from_child;
    const Rigid after = inverse(joint.joint_from_child) * small_motion<double>(c.after) * joint.joint_from_child;
    const bool has_after = !c.after.isZero(0);
    Rigid& child = link_from_true[static_cast<std::size_t>(joint.child_link)];
    if (has_after) {
      child = after;
      move_contents(*named(root, "link", robot.links[static_cast<std::size_t>(joint.child_link)].name), child);
    }
    XMLElement* const dh = element.FirstChildElement("dh");
    const bool is_moved =
        !is_identity(link_from_true[static_cast<std::size_t>(joint.parent_link)]) || !c.frame.isZero(0) || c.angle != 0;
    if (dh || is_moved) set_origin(element, frame);
    if (dh) {
      element.DeleteChild(dh);
      if (XMLElement* axis = element.FirstChildElement("axis")) element.DeleteChild(axis);
      element.InsertNewChildElement("axis")->SetAttribute("xyz", "0 0 1");
    }
    set_mimics(element, joint, changes, c.multiplier_error);
  }
  return link_from_true;
}

/// A link of its own at a place on another; its name is the first of these that is free.
std::string add_link(XMLElement& root, const Robot& robot, const std::string& parent, const Rigid& parent_from_link,
                     const std::string& name) {
  std::string free = name;
  while (find_link(robot, free) >= 0 || find_joint(robot, free + "_joint") >= 0) free.insert(0, "handsight_");
  root.InsertNewChildElement("link")->SetAttribute("name", free.c_str());
  XMLElement& joint = *root.InsertNewChildElement("joint");
  joint.SetAttribute("name", (free + "_joint").c_str());
  joint.SetAttribute("type", "fixed");
  joint.InsertNewChildElement("parent")->SetAttribute("link", parent.c_str());
  joint.InsertNewChildElement("child")->SetAttribute("link", free.c_str());
  set_origin(joint, parent_from_link);
  return free;
}

/// What is fitted again without springs has none.
void delete_springs(XMLElement& root) {
  for (XMLElement* e = root.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint"))
    while (XMLElement* spring = e->FirstChildElement("stiffness")) e->DeleteChild(spring);
}

std::string comment_text(const UrdfFile& file, const CalibratedRobot& robot) {
  std::string text = fmt::format(" Calibrated by Handsight from {}. {} is the hand, {} the marker body.",
                                 in_quotes(robot.calibration.session, 200), file.hand_link, file.body_link);
  if (!file.sensor_link.empty()) text += fmt::format(" {} is the sensor.", file.sensor_link);
  text += file.not_said.empty() ? " Everything that was found is in this file. "
                                : " A URDF cannot say, so that it is not in this file:";
  for (const Message& s : file.not_said) text += "\n  " + printable(s.english());
  if (!file.fit.left_out.empty())
    text += fmt::format(
        "\n  Its origins are fitted again without that, to where the whole model has the hand: {} are left; as it was "
        "written the robot misses {:.3f} mm rms.",
        missed_text(file.fit), 1e3 * file.fit.nominal.rms);
  for (std::size_t at; (at = text.find("--")) != std::string::npos;) text.replace(at, 2, "- -");
  return text + "\n";
}

}  // namespace

UrdfFile urdf_file(const CalibratedRobot& robot, Holds holds) {
  if (robot.urdf_text.empty())
    throw InputError("The robot's URDF text is not at hand; name the file with --robot to export it calibrated.");
  const std::string text = is_utf8(robot.urdf_text) ? robot.urdf_text : utf8_or_latin1(robot.urdf_text);
  const auto document = parse_xml(text, robot.urdf_file);
  XMLElement& root = *document->RootElement();
  const Robot& r = robot.chain.robot;
  UrdfFile file;
  file.fit = rigid_fit(robot, holds);
  const Sites& said = file.fit.sites;
  const std::vector<Rigid> link_from_true = move_joints(root, r, said.robot.joints);
  delete_springs(root);
  file.not_said = file.fit.left_out;
  file.not_said.insert(file.not_said.end(), file.fit.remarks.begin(), file.fit.remarks.end());
  const auto calibrated = [&](const std::string& link, const Rigid& from_true) {
    return is_identity(from_true) ? link : add_link(root, r, link, from_true, link + "_calibrated");
  };
  const Rigid& mount_from_true = link_from_true[static_cast<std::size_t>(robot.chain.mount_link)];
  const std::string tcp = calibrated(
      robot.tcp, link_from_true[static_cast<std::size_t>(robot.chain.tcp_link)] * small_motion<double>(said.hand));
  file.hand_link = robot.of_hand ? calibrated(robot.mount, mount_from_true) : tcp;
  file.body_link = add_link(root, r, tcp, robot.model.tcp_from_body * small_motion<double>(said.body), "body");
  if (robot.model.mount_from_sensor)
    file.sensor_link = add_link(root, r, robot.mount,
                                mount_from_true * *robot.model.mount_from_sensor * small_motion<double>(said.mount) *
                                    small_motion<double>(said.drift),
                                robot.rig ? robot.rig->at(0).name + "_camera" : "sensor");
  root.InsertFirstChild(document->NewComment(comment_text(file, robot).c_str()));
  file.text = xml_text(*document);
  return file;
}

}  // namespace handsight
