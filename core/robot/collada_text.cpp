// SPDX-License-Identifier: Apache-2.0
#include "robot/collada_text.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "base/numbers.h"
#include "base/text.h"
#include "base/xml.h"

namespace handsight {
namespace {

using Placement = Eigen::Affine3d;

std::vector<double> numbers_in(const XmlNode& node) {
  std::string bad;
  const auto numbers = parse_numbers(inner_text(node), &bad);
  if (!numbers) refuse(node, message("has {}, expected finite numbers.", in_quotes(bad)));
  return *numbers;
}

std::vector<double> so_many(const XmlNode& node, std::size_t count) {
  std::vector<double> numbers = numbers_in(node);
  if (numbers.size() != count) refuse(node, message("has {} numbers, expected {}.", numbers.size(), count));
  return numbers;
}

/// "#name" as "name".
std::string reference(const XmlNode& node, const char* attribute) {
  const std::string text = required_name(node, attribute);
  return text.starts_with('#') ? text.substr(1) : text;
}

/// A reader of one file: what its elements with an id are, and the mesh so far.
class Collada {
 public:
  explicit Collada(const XmlNode& root) : root_(root) { note_ids(root); }

  Mesh read() {
    const auto asset = find_child(root_, "asset");
    const auto unit = asset ? find_child(*asset, "unit") : std::nullopt;
    const double metre = unit ? find_positive(*unit, "meter").value_or(1) : 1;
    const Placement scaled(Eigen::Scaling(metre));
    const auto scene = find_child(root_, "scene");
    const auto shown = scene ? find_child(*scene, "instance_visual_scene") : std::nullopt;
    if (shown) {
      for (const XmlNode& node : children(named(*shown, "url", "visual_scene"), "node")) add_node(node, scaled, 0);
    } else {
      for (const XmlNode& library : children(root_, "library_geometries"))
        for (const XmlNode& geometry : children(library, "geometry")) add_geometry(geometry, scaled);
    }
    return std::move(mesh_);
  }

 private:
  void note_ids(const XmlNode& node) {
    if (const char* id = node.element->Attribute("id")) by_id_.emplace(id, node);
    for (const XmlNode& child : children(node)) note_ids(child);
  }

  XmlNode named(const XmlNode& node, const char* attribute, std::string_view tag) const {
    const std::string id = reference(node, attribute);
    const auto found = by_id_.find(id);
    if (found == by_id_.end() || found->second.tag() != tag)
      refuse(node, message("names {}, expected a <{}> of the file.", in_quotes(id), tag));
    return found->second;
  }

  static Placement step(const XmlNode& node) {
    Placement placement = Placement::Identity();
    if (node.tag() == "matrix") {
      const std::vector<double> m = so_many(node, 16);
      placement.matrix() = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(m.data());
      placement.makeAffine();
    } else if (node.tag() == "translate") {
      placement.translation() = Eigen::Map<const Eigen::Vector3d>(so_many(node, 3).data());
    } else if (node.tag() == "scale") {
      const std::vector<double> s = so_many(node, 3);
      placement = Eigen::Scaling(s[0], s[1], s[2]);
    } else if (node.tag() == "rotate") {
      const std::vector<double> r = so_many(node, 4);
      const Eigen::Vector3d axis(r[0], r[1], r[2]);
      if (!(axis.norm() > 0)) refuse(node, "turns about no axis, expected one that is not zero.");
      placement = Eigen::AngleAxisd(r[3] * EIGEN_PI / 180, axis.normalized());
    }
    return placement;
  }

  void add_node(const XmlNode& node, const Placement& above, int depth) {
    constexpr int deepest = 50, most_nodes = 100'000;  // nodes may show nodes, which may show nodes
    if (depth > deepest || ++nodes_ > most_nodes)
      refuse(node, message("is one of too many nodes within nodes, expected at most {} deep.", deepest));
    Placement placement = above;
    for (const XmlNode& child : children(node)) {
      if (child.tag() == "instance_geometry") add_geometry(named(child, "url", "geometry"), placement);
      if (child.tag() == "instance_node") add_node(named(child, "url", "node"), placement, depth + 1);
      if (child.tag() == "node") add_node(child, placement, depth + 1);
      placement = placement * step(child);
    }
  }

  /// The points that a <source> holds, by its accessor.
  std::vector<Eigen::Vector3d> list_points(const XmlNode& source) const {
    const std::vector<double> numbers = numbers_in(required_child(source, "float_array"));
    const auto technique = find_child(source, "technique_common");
    const auto accessor = technique ? find_child(*technique, "accessor") : std::nullopt;
    const auto stride = static_cast<std::size_t>(accessor ? find_integer(*accessor, "stride", 3, 64).value_or(3) : 3);
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i + 3 <= numbers.size(); i += stride)
      points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return points;
  }

  void add_geometry(const XmlNode& geometry, const Placement& placement) {
    const auto mesh = find_child(geometry, "mesh");
    if (!mesh) return;  // a spline
    for (const char* kind : {"triangles", "polylist", "polygons"})
      for (const XmlNode& faces : children(*mesh, kind)) add_faces(faces, placement);
  }

  /// Where in a corner's indices that of its point stands, how many indices a corner has, and the points.
  struct Corners {
    std::size_t offset = 0, stride = 1;
    std::vector<Eigen::Vector3d> points;
  };

  Corners corners_of(const XmlNode& faces) const {
    Corners corners;
    bool has_points = false;
    for (const XmlNode& input : children(faces, "input")) {
      const auto offset = static_cast<std::size_t>(find_integer(input, "offset", 0, 31).value_or(0));
      corners.stride = std::max(corners.stride, offset + 1);
      if (find_name(input, "semantic") != "VERTEX") continue;
      corners.offset = offset;
      for (const XmlNode& of : children(named(input, "source", "vertices"), "input"))
        if (find_name(of, "semantic") == "POSITION") {
          corners.points = list_points(named(of, "source", "source"));
          has_points = true;
        }
    }
    if (!has_points) refuse(faces, "has no points, expected an <input> of VERTEX whose <vertices> have a POSITION.");
    return corners;
  }

  void add_faces(const XmlNode& faces, const Placement& placement) {
    const Corners corners = corners_of(faces);
    const std::size_t first = mesh_.points.size();
    for (const Eigen::Vector3d& point : corners.points) {
      const Eigen::Vector3d there = placement * point;
      if (!std::all_of(there.begin(), there.end(), [](double x) { return bounds::joint.hold(x); }))
        refuse(faces, "has a point that is not finite or too far away, expected points of a robot's link.");
      mesh_.points.push_back(there.cast<float>());
    }
    require_few(faces);
    const auto counts = find_child(faces, "vcount");
    for (const XmlNode& list : children(faces, "p")) {
      std::vector<std::uint32_t> indices = indices_in(list, corners, first);
      std::vector<double> sizes;
      if (faces.tag() == "triangles") sizes.assign(indices.size() / 3, 3);
      if (faces.tag() == "polygons") sizes = {static_cast<double>(indices.size())};
      if (faces.tag() == "polylist" && counts) sizes = numbers_in(*counts);
      add_fans(list, indices, sizes);
    }
  }

  std::vector<std::uint32_t> indices_in(const XmlNode& list, const Corners& corners, std::size_t first) const {
    const std::vector<double> numbers = numbers_in(list);
    std::vector<std::uint32_t> indices;
    for (std::size_t i = corners.offset; i < numbers.size(); i += corners.stride) {
      if (!(numbers[i] >= 0 && numbers[i] < static_cast<double>(corners.points.size())))
        refuse(list, message("names the point {}, expected one of the {} points, from 0.", numbers[i],
                             corners.points.size()));
      indices.push_back(static_cast<std::uint32_t>(first + static_cast<std::size_t>(numbers[i])));
    }
    return indices;
  }

  void add_fans(const XmlNode& list, const std::vector<std::uint32_t>& corners, const std::vector<double>& sizes) {
    std::size_t at = 0;
    for (const double size : sizes) {
      if (!(size >= 0 && size <= static_cast<double>(corners.size() - at)))
        refuse(list, message("has {} corners, expected as many as its faces have together.", corners.size()));
      const std::size_t end = at + static_cast<std::size_t>(size);
      for (std::size_t i = at + 2; i < end; ++i) mesh_.triangles.push_back({corners[at], corners[i - 1], corners[i]});
      at = end;
      require_few(list);
    }
  }

  void require_few(const XmlNode& node) const {
    constexpr std::size_t most = 5'000'000;
    if (mesh_.triangles.size() > most || mesh_.points.size() > 3 * most)
      refuse(node, message("makes more than {} triangles, expected a simpler mesh.", most));
  }

  XmlNode root_;
  std::map<std::string, XmlNode> by_id_;
  Mesh mesh_;
  int nodes_ = 0;
};

}  // namespace

Mesh parse_collada(std::string_view text, const std::string& file) {
  const auto document = parse_xml(text, file);
  return Collada(require_root(*document, file, "COLLADA")).read();
}

}  // namespace handsight
