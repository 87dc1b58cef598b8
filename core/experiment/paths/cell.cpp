// SPDX-License-Identifier: Apache-2.0
#include "experiment/paths/cell.h"

#include "base/files.h"
#include "base/text.h"
#include "base/xml.h"

namespace handsight {
namespace {

Vector3 three(const XmlNode& node, const char* attribute, const Bounds& within) {
  return Vector3(required_numbers(node, attribute, 3, within).data());
}

CellBox read_box(const XmlNode& node) {
  CellBox box{three(node, "size", bounds::length), {}};
  if (!(box.size.minCoeff() > 0)) refuse(node, "has in size a length that is not above 0 m.");
  if (const auto xyz = find_numbers(node, "xyz", 3, bounds::length))
    box.root_from_box.translation = Vector3(xyz->data());
  if (const auto rpy = find_numbers(node, "rpy", 3, bounds::joint))
    box.root_from_box.rotation = rotation_from_rpy(Vector3(rpy->data()));
  return box;
}

CellPlane read_plane(const XmlNode& node) {
  const Vector3 normal = three(node, "normal", bounds::finite);
  const double largest = normal.cwiseAbs().maxCoeff();
  if (largest == 0) refuse(node, "has a normal of zeros, expected the direction that leads out of what is solid.");
  return {(normal / largest).normalized(), required_number(node, "offset", bounds::length)};
}

}  // namespace

Cell parse_cell(const std::string& text, const std::string& file) {
  const auto document = parse_xml(text, file);
  const XmlNode root = require_root(*document, file, "handsight_cell");
  require_version_1(root);
  Cell cell;
  for (const XmlNode& node : children(root)) {
    if (node.tag() == "box")
      cell.boxes.push_back(read_box(node));
    else if (node.tag() == "plane")
      cell.planes.push_back(read_plane(node));
    else
      refuse(node, "is not known, expected <box> or <plane>: what stands about the robot must not be overlooked.");
  }
  return cell;
}

Cell read_cell(const std::filesystem::path& file) { return parse_cell(read_file(file), file.filename().string()); }

}  // namespace handsight
