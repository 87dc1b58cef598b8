// SPDX-License-Identifier: Apache-2.0
// The <visual> shapes and <material> colours of a URDF.
#include "base/error.h"
#include "base/text.h"
#include "robot/urdf_parts.h"
#include "robot/xml_rigid.h"

namespace handsight::urdf {

namespace {

double read_length(const XmlNode& node, const char* attribute) {
  const double length = required_number(node, attribute, bounds::length);
  if (length < 0)
    refuse(node, message("has {}=\"{}\", expected a length of at least 0 m.", verbatim(attribute), length));
  return length;
}

std::optional<Eigen::Vector4d> find_color(const XmlNode& material) {
  const auto node = find_child(material, "color");
  if (!node) return std::nullopt;
  const auto numbers = required_numbers(*node, "rgba", 4);
  return Eigen::Vector4d(numbers.data()).cwiseMax(0.0).cwiseMin(1.0);
}

Shape read_box(const XmlNode& node) {
  Shape shape{ShapeKind::box, Vector3(required_numbers(node, "size", 3, bounds::length).data()), {}, {}, {}};
  if (shape.size.minCoeff() < 0) refuse(node, "has a negative number in size, expected three lengths of at least 0 m.");
  return shape;
}

Shape read_mesh(const XmlNode& node) {
  const Vector3 scale = find_vector(node, "scale", bounds::joint).value_or(Vector3::Ones());
  return {ShapeKind::mesh, scale, required_name(node, "filename"), {}, {}};
}

std::optional<Eigen::Vector4d> color_of(const XmlNode& visual, const Colors& colors) {
  const auto material = find_child(visual, "material");
  if (!material) return std::nullopt;
  if (auto own = find_color(*material)) return own;
  const auto named = colors.find(find_text(*material, "name").value_or(""));
  return named == colors.end() ? std::nullopt : std::optional(named->second);
}

/// Colours in `node`'s own <material> elements.
void add_colors(const XmlNode& node, Colors& colors) {
  for (const XmlNode& material : children(node, "material"))
    if (const auto color = find_color(material)) colors.emplace(find_text(material, "name").value_or(""), *color);
}

}  // namespace

std::optional<Shape> read_geometry(const XmlNode& geometry) {
  if (const auto box = find_child(geometry, "box")) return read_box(*box);
  if (const auto node = find_child(geometry, "cylinder"))
    return Shape{ShapeKind::cylinder, {read_length(*node, "radius"), read_length(*node, "length"), 0}, {}, {}, {}};
  if (const auto node = find_child(geometry, "sphere"))
    return Shape{ShapeKind::sphere, {read_length(*node, "radius"), 0, 0}, {}, {}, {}};
  if (const auto mesh = find_child(geometry, "mesh")) return read_mesh(*mesh);
  return std::nullopt;
}

Colors read_colors(const XmlNode& robot) {
  Colors colors;
  add_colors(robot, colors);
  // Files name a material in full once and by its name alone afterwards, in other links too.
  for (const XmlNode& link : children(robot, "link"))
    for (const XmlNode& visual : children(link, "visual")) add_colors(visual, colors);
  colors.erase("");
  return colors;
}

std::vector<Shape> read_shapes(const XmlNode& link, const Colors& colors, Notes& notes) {
  std::vector<Shape> shapes;
  for (const XmlNode& visual : children(link, "visual")) {
    const auto geometry = find_child(visual, "geometry");
    std::optional<Shape> shape = geometry ? read_geometry(*geometry) : std::nullopt;
    if (!shape) {
      add_note(notes, visual, "the <visual> is not drawn: it has no box, cylinder, sphere or mesh in its <geometry>.");
      continue;
    }
    if (const auto origin = find_child(visual, "origin")) shape->link_from_shape = read_rigid(*origin);
    shape->color = color_of(visual, colors);
    shapes.push_back(std::move(*shape));
  }
  return shapes;
}

}  // namespace handsight::urdf
