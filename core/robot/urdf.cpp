// SPDX-License-Identifier: Apache-2.0
#include "robot/urdf.h"

#include <optional>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "robot/urdf_parts.h"

namespace handsight {

void urdf::add_note(Notes& notes, const XmlNode& node, const Message& sentence) {
  notes.push_back(message("{}, line {}: {}", shortened(node.file, 80), node.line(), at_most(sentence, 480)));
}

namespace {

/// The first element or attribute that only xacro understands.
std::optional<XmlNode> find_xacro(const tinyxml2::XMLElement& element, std::string_view file) {
  if (std::string_view(element.Name()).starts_with("xacro:")) return XmlNode{&element, file};
  for (const auto* a = element.FirstAttribute(); a; a = a->Next())
    if (std::string_view(a->Value()).find("${") != std::string_view::npos) return XmlNode{&element, file};
  for (const auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
    if (auto found = find_xacro(*child, file)) return found;
  return std::nullopt;
}

/// xacro is a language of macros: what the robot is stands in other files and in arguments.
void refuse_xacro(const XmlNode& root) {
  const auto found = find_xacro(*root.element, root.file);
  if (!found) return;
  refuse(*found, message("is of xacro, expected a URDF: expand it first with `xacro {} > expanded.urdf` (or `ros2 run "
                         "xacro xacro ...`, with the arguments that the robot's launch file gives) and name "
                         "expanded.urdf.",
                         shortened(root.file, 100)));
}

}  // namespace

Robot parse_urdf(const std::string& text, const std::string& file_name, std::vector<Message>* notes) {
  urdf::Notes said;
  const bool is_good = is_utf8(text);
  if (!is_good)
    said.push_back(
        message("{}: the file is not UTF-8; its other bytes are read as Latin-1.", shortened(file_name, 80)));
  const auto document = parse_xml(is_good ? text : utf8_or_latin1(text), file_name);
  const XmlNode root = require_root(*document, file_name, "robot");
  refuse_xacro(root);
  const urdf::Colors colors = urdf::read_colors(root);
  std::vector<urdf::LinkPart> links;
  for (const XmlNode& node : children(root, "link")) links.push_back(urdf::read_link(node, colors, said));
  std::vector<urdf::JointPart> joints;
  for (const XmlNode& node : children(root, "joint")) joints.push_back(urdf::read_joint(node, said));
  Robot robot = urdf::assemble(find_name(root, "name").value_or(""), root, std::move(links), std::move(joints));
  if (notes) notes->insert(notes->end(), said.begin(), said.end());
  return robot;
}

Robot read_urdf(const std::filesystem::path& path, std::vector<Message>* notes) {
  return parse_urdf(read_file(path), path.filename().string(), notes);
}

}  // namespace handsight
