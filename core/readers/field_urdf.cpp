// SPDX-License-Identifier: Apache-2.0
#include "readers/field_urdf.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "base/xml.h"
#include "robot/urdf.h"

namespace handsight {
namespace {

Message listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;
  const std::string first =
      fmt::format("{}", fmt::join(std::vector(names.begin(), names.begin() + std::min(names.size(), most)), ", "));
  return names.size() > most ? message("{} and {} more", first, names.size() - most) : verbatim(first);
}

/// Types that have several coordinates are set to fixed; their names.
std::vector<std::string> set_floating_fixed(tinyxml2::XMLElement& root) {
  std::vector<std::string> names;
  for (auto* joint = root.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint")) {
    const char* const type = joint->Attribute("type");
    if (!type || (std::string(type) != "floating" && std::string(type) != "planar")) continue;
    names.push_back(fmt::format("{} ({})", joint->Attribute("name") ? joint->Attribute("name") : "?", type));
    joint->SetAttribute("type", "fixed");
  }
  return names;
}

void note_what_is_missing(const Robot& robot, const std::string& file, std::vector<Message>& notes) {
  std::vector<std::string> no_limits, no_mass;
  for (const Joint& j : robot.joints)
    if ((j.kind == JointKind::revolute || j.kind == JointKind::prismatic) && j.lower < -1e29)
      no_limits.push_back(j.name);
  for (const Joint& j : robot.joints)
    if (j.moves() && robot.links[static_cast<std::size_t>(j.child_link)].mass == 0)
      no_mass.push_back(robot.links[static_cast<std::size_t>(j.child_link)].name);
  if (!no_limits.empty())
    notes.push_back(
        message("{}: no limits are given for {}: they are taken to turn and slide without end, and "
                "corrections will not stop at them.",
                file, listed(no_limits)));
  const bool any_mass = std::any_of(robot.links.begin(), robot.links.end(), [](const Link& l) { return l.mass > 0; });
  if (!any_mass)
    notes.push_back(
        message("{}: no link has a mass: springs cannot show, and gravity bends nothing. Put the masses "
                "of the maker's data sheet into <inertial>.",
                file));
  else if (!no_mass.empty())
    notes.push_back(message("{}: {} moving links have no mass: {}. What gravity does through them is missing.", file,
                            no_mass.size(), listed(no_mass)));
}

void note_meshes(const Robot& robot, const std::string& file, std::vector<Message>& notes) {
  std::size_t meshes = 0, packages = 0;
  for (const Link& link : robot.links)
    for (const Shape& shape : link.shapes) {
      meshes += shape.kind == ShapeKind::mesh;
      packages += shape.mesh_file.starts_with("package://");
    }
  if (meshes > 0)
    notes.push_back(
        message("{}: its {} meshes{} are not copied: they are drawn where they are found beside the "
                "robot, else plain limbs are. Nothing that is measured depends on them.",
                file, meshes, packages ? message(" ({} by package://)", packages) : Message()));
}

}  // namespace

FieldUrdf field_urdf(const std::string& text, const std::string& file) {
  FieldUrdf field;
  const std::string utf8 = is_utf8(text) ? text : utf8_or_latin1(text);
  const auto document = parse_xml(utf8, file);
  tinyxml2::XMLElement* const root = document->RootElement();
  const std::vector<std::string> still =
      root && std::string(root->Name()) == "robot" ? set_floating_fixed(*root) : std::vector<std::string>();
  field.text = still.empty() ? text : xml_text(*document);
  field.robot = parse_urdf(field.text, file, &field.notes);
  if (!still.empty())
    field.notes.push_back(
        message("{}: {} stand still in the session's copy: a session has one number a joint. Where "
                "the robot drove between observations, each place is a session of its own.",
                file, listed(still)));
  note_what_is_missing(field.robot, file, field.notes);
  note_meshes(field.robot, file, field.notes);
  return field;
}

std::vector<std::string> end_links(const Robot& robot) {
  std::vector<std::string> names;
  for (std::size_t l = 0; l < robot.links.size(); ++l)
    if (std::none_of(robot.joints.begin(), robot.joints.end(),
                     [&](const Joint& j) { return j.parent_link == static_cast<int>(l); }))
      names.push_back(robot.links[l].name);
  return names;
}

}  // namespace handsight
