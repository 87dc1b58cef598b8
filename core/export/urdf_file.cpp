// SPDX-License-Identifier: Apache-2.0
#include "export/urdf_file.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/numbers.h"
#include "base/text.h"
#include "base/xml.h"
#include "effects/units.h"
#include "robot/xml_rigid.h"

namespace handsight {
namespace {

using tinyxml2::XMLElement;

/// All numbers of the sites, in one order.
std::vector<double> flat(const Sites& s) {
  std::vector<double> all;
  const auto add = [&](const auto& v) { all.insert(all.end(), v.data(), v.data() + v.size()); };
  for (const JointChange& c : s.robot.joints) {
    all.insert(all.end(), {c.angle, c.multiplier_error, c.share, c.compliance, c.lateral_compliance, c.gap});
    add(c.frame);
    add(c.after);
  }
  all.insert(all.end(), {s.robot.tilt_x, s.robot.tilt_y, s.robot.payload_mass});
  add(s.robot.base_compliance);
  add(s.robot.payload_moment);
  add(s.mount);
  add(s.drift);
  for (const CameraChange& c : s.cameras) {
    add(c.motion);
    add(c.numbers);
  }
  add(s.hand);
  add(s.body);
  for (const Vector3& m : s.markers) add(m);
  return all;
}

/// Does the term move its sites by the same amount in every pose after the session?
bool is_the_same_everywhere(const Chain& chain, const EffectTerm& term) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> first;
  for (int draw = 0; draw < 4; ++draw) {
    Eigen::VectorXd position(static_cast<Eigen::Index>(chain.joints.size()));
    for (double& q : position) q = uniform(random);
    Circumstances c = circumstances_at(chain, position);
    for (double& v : c.velocity) v = uniform(random);
    for (double& a : c.approach) a = uniform(random);
    const std::vector<double> here = flat(moved_sites(c, {term}));
    if (draw == 0) first = here;
    if (here != first) return false;
  }
  return true;
}

/// What is left of the sites when all that a URDF can say is taken out.
bool has_more_than_a_urdf_says(Sites s) {
  for (JointChange& c : s.robot.joints) {
    c.angle = c.multiplier_error = 0;
    c.frame.setZero();
    c.after.setZero();
  }
  s.hand.setZero();
  s.body.setZero();
  s.mount.setZero();
  s.drift.setZero();
  const std::vector<double> rest = flat(s);
  return std::any_of(rest.begin(), rest.end(), [](double x) { return x != 0; });
}

struct Sayable {
  Sites sites;
  std::vector<std::string> not_said;
};

std::string numbers_of(const EffectTerm& term, const Robot& robot) {
  const Effect& effect = effect_of(term);
  std::string text;
  for (std::size_t p = 0; p < term.values.size(); ++p)
    text += fmt::format("{}{} {:.4g} {}", p ? ", " : "", effect.parameters[p].name, term.values[p],
                        unit_at(effect, p, term.joint, robot));
  return text;
}

Sayable sayable(const CalibratedRobot& robot) {
  Sayable s;
  std::vector<EffectTerm> said;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.chain.joints.size()));
  const Circumstances c = circumstances_at(robot.chain, zero);
  for (const EffectTerm& term : robot.model.effects) {
    if (std::all_of(term.values.begin(), term.values.end(), [](double v) { return v == 0; })) continue;
    const bool is_constant = is_the_same_everywhere(robot.chain, term);
    if (is_constant) said.push_back(term);
    if (is_constant && !has_more_than_a_urdf_says(moved_sites(c, {term}))) continue;
    const std::string where = place_name(effect_of(term), term.joint, robot.chain.robot);
    s.not_said.push_back(fmt::format("{}{} ({})", term.id, where.empty() ? "" : " of " + where,
                                     shortened(numbers_of(term, robot.chain.robot), 300)));
  }
  s.sites = moved_sites(c, said);
  s.sites.robot.joints.resize(robot.chain.robot.joints.size());
  for (const Joint& joint : robot.chain.robot.joints) {
    if (joint.stiffness > 0)
      s.not_said.push_back(
          fmt::format("the spring of {}: <stiffness> stays in the file, other readers pass it over", joint.name));
    if (joint.mimics.size() > 1)
      s.not_said.push_back(fmt::format("{} follows {} joints: other readers may take one of its <mimic> alone",
                                       joint.name, joint.mimics.size()));
  }
  return s;
}

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

std::string comment_text(const UrdfFile& file, const CalibratedRobot& robot) {
  std::string text = fmt::format(" Calibrated by Handsight from {}. {} is the hand, {} the marker body.",
                                 in_quotes(robot.calibration.session, 200), file.hand_link, file.body_link);
  if (!file.sensor_link.empty()) text += fmt::format(" {} is the sensor.", file.sensor_link);
  text += file.not_said.empty() ? " Everything that was found is in this file. "
                                : " A URDF cannot say, so that it is not in this file:";
  for (const std::string& s : file.not_said) text += "\n  " + printable(s);
  for (std::size_t at; (at = text.find("--")) != std::string::npos;) text.replace(at, 2, "- -");
  return text + "\n";
}

}  // namespace

UrdfFile urdf_file(const CalibratedRobot& robot) {
  if (robot.urdf_text.empty())
    throw InputError("The robot's URDF text is not at hand; name the file with --robot to export it calibrated.");
  const std::string text = is_utf8(robot.urdf_text) ? robot.urdf_text : utf8_or_latin1(robot.urdf_text);
  const auto document = parse_xml(text, robot.urdf_file);
  XMLElement& root = *document->RootElement();
  const Robot& r = robot.chain.robot;
  const Sayable said = sayable(robot);
  const std::vector<Rigid> link_from_true = move_joints(root, r, said.sites.robot.joints);
  UrdfFile file;
  file.not_said = said.not_said;
  const auto calibrated = [&](const std::string& link, const Rigid& from_true) {
    return is_identity(from_true) ? link : add_link(root, r, link, from_true, link + "_calibrated");
  };
  const Rigid& mount_from_true = link_from_true[static_cast<std::size_t>(robot.chain.mount_link)];
  const std::string tcp = calibrated(robot.tcp, link_from_true[static_cast<std::size_t>(robot.chain.tcp_link)] *
                                                    small_motion<double>(said.sites.hand));
  file.hand_link = robot.of_hand ? calibrated(robot.mount, mount_from_true) : tcp;
  file.body_link = add_link(root, r, tcp, robot.model.tcp_from_body * small_motion<double>(said.sites.body), "body");
  if (robot.model.mount_from_sensor)
    file.sensor_link = add_link(root, r, robot.mount,
                                mount_from_true * *robot.model.mount_from_sensor *
                                    small_motion<double>(said.sites.mount) * small_motion<double>(said.sites.drift),
                                robot.rig ? robot.rig->at(0).name + "_camera" : "sensor");
  root.InsertFirstChild(document->NewComment(comment_text(file, robot).c_str()));
  file.text = xml_text(*document);
  return file;
}

}  // namespace handsight
