// SPDX-License-Identifier: Apache-2.0
#include "robot/collision_shapes.h"

#include "robot/urdf_parts.h"
#include "robot/xml_rigid.h"

namespace handsight {

std::vector<std::vector<Shape>> visual_shapes(const Robot& robot) {
  std::vector<std::vector<Shape>> shapes;
  for (const Link& link : robot.links) shapes.push_back(link.shapes);
  return shapes;
}

std::vector<std::vector<Shape>> collision_shapes(const Robot& robot, const std::string& text,
                                                 const std::string& file_name) {
  std::vector<std::vector<Shape>> shapes = visual_shapes(robot);
  const auto document = parse_xml(text, file_name);
  const XmlNode root = require_root(*document, file_name, "robot");
  for (const XmlNode& link : children(root, "link")) {
    const int index = find_link(robot, find_name(link, "name").value_or(""));
    if (index < 0) continue;
    std::vector<Shape> own;
    for (const XmlNode& collision : children(link, "collision")) {
      const auto geometry = find_child(collision, "geometry");
      std::optional<Shape> shape = geometry ? urdf::read_geometry(*geometry) : std::nullopt;
      if (!shape) continue;
      if (const auto origin = find_child(collision, "origin")) shape->link_from_shape = read_rigid(*origin);
      own.push_back(std::move(*shape));
    }
    if (!own.empty()) shapes[static_cast<std::size_t>(index)] = std::move(own);
  }
  return shapes;
}

}  // namespace handsight
