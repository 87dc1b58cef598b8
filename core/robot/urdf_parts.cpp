// SPDX-License-Identifier: Apache-2.0
#include "robot/urdf_parts.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/text.h"
#include "robot/xml_rigid.h"

namespace handsight::urdf {

namespace {

constexpr double farthest_center = 10;  // m: beyond it a centre of mass is likely in other units

Rigid find_origin(const XmlNode& node) {
  const auto origin = find_child(node, "origin");
  return origin ? read_rigid(*origin) : Rigid{};
}

void read_inertial(const XmlNode& node, Link& link, Notes& notes) {
  const XmlNode mass = required_child(node, "mass");
  link.mass = required_number(mass, "value", {bounds::any.lowest, bounds::mass.highest});
  if (link.mass < 0) refuse(mass, message("has value=\"{}\", a negative mass, expected at least 0 kg.", link.mass));
  link.center_of_mass = find_origin(node).translation;
  if (link.center_of_mass.cwiseAbs().maxCoeff() > farthest_center)
    add_note(notes, node,
             message("the centre of mass of link {} lies {:.4g} m from the link's frame, farther than {} "
                     "m; its gravity "
                     "moments will be as large as that says.",
                     in_quotes(link.name), link.center_of_mass.stableNorm(), farthest_center));
}

JointKind read_kind(const XmlNode& node) {
  constexpr std::array kinds{JointKind::fixed, JointKind::revolute, JointKind::continuous, JointKind::prismatic};
  const std::string type = required_text(node, "type");
  if (type == "planar" || type == "floating")
    refuse(node, message("is of type {}, which has several coordinates and is not supported, expected fixed, "
                         "revolute, continuous or prismatic.",
                         type));
  return kinds[find_choice(node, "type", {"fixed", "revolute", "continuous", "prismatic"}).value()];
}

Vector3 read_axis(const XmlNode& joint) {
  const auto node = find_child(joint, "axis");
  const Vector3 axis = node ? find_vector(*node, "xyz", bounds::finite).value_or(Vector3::UnitX()) : Vector3::UnitX();
  const double largest = axis.cwiseAbs().maxCoeff();
  if (largest == 0) refuse(*node, "is a zero vector, expected the direction of the joint's axis.");
  return (axis / largest).normalized();  // in two steps: the square of a huge or tiny axis has no double
}

/// Craig's modified Denavit-Hartenberg.
void read_dh(const XmlNode& node, Joint& joint) {
  if (!node.element->FirstAttribute()) refuse(node, "has no attributes, expected a, alpha, d and theta.");
  const auto number = [&](const char* attribute, const Bounds& within) {
    return find_number(node, attribute, within).value_or(0);
  };
  joint.axis = Vector3::UnitZ();
  const Matrix3 twist = rotation_about(Vector3::UnitX(), number("alpha", bounds::joint));
  joint.parent_from_joint = {twist, twist * Vector3(number("a", bounds::length), 0, 0)};
  joint.joint_from_child = {rotation_about(Vector3::UnitZ(), number("theta", bounds::joint)),
                            Vector3(0, 0, number("d", bounds::length))};
}

void read_placement(const XmlNode& node, Joint& joint, Notes& notes) {
  const auto dh = find_child(node, "dh");
  if (dh) {
    read_dh(*dh, joint);
    if (find_child(node, "origin") || find_child(node, "axis"))
      add_note(notes, node,
               message("joint {} has <dh>, so that its <origin> and <axis> are ignored.", in_quotes(joint.name)));
    return;
  }
  joint.parent_from_joint = find_origin(node);
  if (joint.moves()) joint.axis = read_axis(node);  // exporters write 0 0 0 for fixed joints
}

void read_limits(const XmlNode& node, Joint& joint) {
  const auto limit = find_child(node, "limit");
  if (!limit || (joint.kind != JointKind::revolute && joint.kind != JointKind::prismatic)) return;
  const auto lower = find_number(*limit, "lower"), upper = find_number(*limit, "upper");
  if (!lower && !upper) return;
  const auto bounded = [](double number) { return std::clamp(number, bounds::joint.lowest, bounds::joint.highest); };
  joint.lower = bounded(lower.value_or(0));  // URDF's default for one that is missing; some write 1e16 for none
  joint.upper = bounded(upper.value_or(0));
  if (joint.lower > joint.upper)
    refuse(*limit, message("has lower={} above upper={}, expected lower <= upper.", joint.lower, joint.upper));
}

void read_stiffness(const XmlNode& node, Joint& joint, Notes& notes) {
  const auto stiffness = find_child(node, "stiffness");
  if (!stiffness) return;
  const double value = required_positive(*stiffness, "value", bounds::stiffness);
  if (joint.moves())
    joint.stiffness = value;
  else
    add_note(notes, *stiffness,
             message("joint {} is fixed, so that its <stiffness> is ignored.", in_quotes(joint.name)));
}

std::vector<MimicPart> read_mimics(const XmlNode& node, const Joint& joint, Notes& notes) {
  std::vector<MimicPart> mimics;
  for (const XmlNode& mimic : children(node, "mimic")) {
    MimicPart part{mimic, required_name(mimic, "joint"), {}};
    part.mimic.multiplier = find_number(mimic, "multiplier", bounds::joint).value_or(1);
    part.mimic.offset = find_number(mimic, "offset", bounds::joint).value_or(0);
    if (joint.moves())
      mimics.push_back(std::move(part));
    else
      add_note(notes, mimic, message("joint {} is fixed, so that its <mimic> is ignored.", in_quotes(joint.name)));
  }
  return mimics;
}

}  // namespace

LinkPart read_link(const XmlNode& node, const Colors& colors, Notes& notes) {
  LinkPart part{node, {}};
  part.link.name = required_name(node, "name");
  if (const auto inertial = find_child(node, "inertial")) read_inertial(*inertial, part.link, notes);
  part.link.shapes = read_shapes(node, colors, notes);
  return part;
}

JointPart read_joint(const XmlNode& node, Notes& notes) {
  JointPart part;
  part.node = node;
  part.joint.name = required_name(node, "name");
  part.joint.kind = read_kind(node);
  part.parent = required_name(required_child(node, "parent"), "link");
  part.child = required_name(required_child(node, "child"), "link");
  read_placement(node, part.joint, notes);
  read_limits(node, part.joint);
  read_stiffness(node, part.joint, notes);
  part.mimics = read_mimics(node, part.joint, notes);
  return part;
}

}  // namespace handsight::urdf
