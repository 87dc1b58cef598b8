// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/xacro_file.h"

#include <array>

#include "base/xml.h"

namespace handsight {
namespace {

using tinyxml2::XMLElement;

/// xacro takes "${" and "$(" as its own; "$$" stands for the dollar.
std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '$' && i + 1 < text.size() && (text[i + 1] == '{' || text[i + 1] == '(')) out += '$';
    out += text[i];
  }
  return out;
}

/// Is the attribute the name of a link or joint of this robot, or one that refers to it?
bool is_own_name(const XMLElement& e, const std::string& attribute, const Robot& robot) {
  const std::string value = e.Attribute(attribute.c_str()), tag = e.Name();
  if (attribute == "link" || attribute == "reference") return find_link(robot, value) >= 0;
  if (attribute == "joint") return find_joint(robot, value) >= 0;
  if (attribute != "name") return false;
  return (tag == "link" && find_link(robot, value) >= 0) || (tag == "joint" && find_joint(robot, value) >= 0);
}

void put_names(XMLElement& e, const Robot& robot) {
  std::vector<std::pair<std::string, std::string>> values;
  for (const tinyxml2::XMLAttribute* a = e.FirstAttribute(); a; a = a->Next())
    values.emplace_back(a->Name(), (is_own_name(e, a->Name(), robot) ? "${prefix}" : "") + escaped(a->Value()));
  for (const auto& [name, value] : values) e.SetAttribute(name.c_str(), value.c_str());
  for (XMLElement* child = e.FirstChildElement(); child; child = child->NextSiblingElement()) put_names(*child, robot);
}

void write_mounting(XMLElement& macro, const std::string& root_link) {
  XMLElement& when = *macro.InsertNewChildElement("xacro:if");
  when.SetAttribute("value", "${parent != ''}");
  XMLElement& joint = *when.InsertNewChildElement("joint");
  joint.SetAttribute("name", "${prefix}calibrated_robot_mounting");
  joint.SetAttribute("type", "fixed");
  joint.InsertNewChildElement("parent")->SetAttribute("link", "${parent}");
  joint.InsertNewChildElement("child")->SetAttribute("link", ("${prefix}" + escaped(root_link)).c_str());
}

constexpr char use[] =
    "\n  To use it:\n"
    "    <robot name=\"cell\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
    "      <xacro:include filename=\"THIS FILE\"/>\n"
    "      <link name=\"table\"/>\n"
    "      <xacro:calibrated_robot name=\"left\" parent=\"table\"/>\n"
    "    </robot>\n";

}  // namespace

std::string xacro_file(const DescribedRobot& d) {
  const auto urdf = parse_xml(d.urdf.text, "the calibrated URDF");
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewDeclaration());
  document.InsertEndChild(document.NewComment((" " + d.comment + use).c_str()));
  XMLElement& root = *document.NewElement("robot");
  document.InsertEndChild(&root);
  root.SetAttribute("xmlns:xacro", "http://www.ros.org/wiki/xacro");
  XMLElement& macro = *root.InsertNewChildElement("xacro:macro");
  macro.SetAttribute("name", "calibrated_robot");
  macro.SetAttribute("params", "name:='' parent:=''");
  XMLElement& prefix = *macro.InsertNewChildElement("xacro:property");
  prefix.SetAttribute("name", "prefix");
  prefix.SetAttribute("value", "${name + '_' if name else ''}");
  for (XMLElement* e = urdf->RootElement()->FirstChildElement(); e; e = e->NextSiblingElement()) {
    XMLElement& copy = *e->DeepClone(&document)->ToElement();
    macro.InsertEndChild(&copy);
    put_names(copy, d.robot);
  }
  write_mounting(macro, d.robot.links[0].name);
  return xml_text(document);
}

}  // namespace handsight
