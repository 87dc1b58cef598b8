// SPDX-License-Identifier: Apache-2.0
#include "readers/robots/mjcf_model.h"

#include <set>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight::mjcf {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLElement;

constexpr int most_files = 200;

/// Brings what <include file=""/> names into its place, for all below an element.
class Includer {
 public:
  Includer(tinyxml2::XMLDocument& document, fs::path folder, std::string file)
      : document_(document), folder_(std::move(folder)), file_(std::move(file)) {}

  void expand(XMLElement& element) {
    for (XMLElement* child = element.FirstChildElement(); child;) {
      XMLElement* next = child->NextSiblingElement();
      if (std::string_view(child->Name()) == "include")
        replace(element, *child);
      else
        expand(*child);
      child = next;
    }
  }

 private:
  void replace(XMLElement& parent, XMLElement& include) {
    const XmlNode node{&include, file_};
    const std::string name = required_name(node, "file");
    if (!seen_.insert(name).second) refuse(node, message("includes {} a second time, expected once.", in_quotes(name)));
    if (seen_.size() > most_files) refuse(node, message("is the include number {}.", seen_.size()));
    const fs::path path = folder_ / name;
    if (!fs::is_regular_file(path))
      refuse(node, message("includes {}, which is not there; put it beside the model.", in_quotes(name)));
    const auto included = parse_xml(read_file(path), name);
    if (!included->RootElement()) refuse(node, message("includes {}, which is empty.", in_quotes(name)));
    expand(*included->RootElement());
    tinyxml2::XMLNode* after = &include;
    for (const tinyxml2::XMLNode* part = included->RootElement()->FirstChild(); part; part = part->NextSibling())
      after = parent.InsertAfterChild(after, part->DeepClone(&document_));
    parent.DeleteChild(&include);
  }

  tinyxml2::XMLDocument& document_;
  fs::path folder_;
  std::string file_;
  std::set<std::string> seen_;
};

bool yes(const std::optional<std::string>& text) { return text && *text == "true"; }

void take_compiler(const XmlNode& node, Model& m) {
  if (const auto angle = find_text(node, "angle")) m.is_in_degrees = *angle != "radian";
  if (const auto order = find_text(node, "eulerseq")) m.euler = *order;
  if (m.euler.size() != 3 || m.euler.find_first_not_of("xyzXYZ") != std::string::npos)
    refuse(node, message("has eulerseq {}, expected three of x y z X Y Z.", in_quotes(m.euler)));
  if (const auto where = find_text(node, "assetdir")) m.mesh_folder = *where;
  if (const auto where = find_text(node, "meshdir")) m.mesh_folder = *where;
  if (const auto how = find_text(node, "inertiafromgeom"); how && *how != "auto") m.from_geoms = yes(how);
  if (find_text(node, "coordinate").value_or("local") != "local")
    refuse(
        node,
        "has coordinate=\"global\", which MuJoCo itself no longer reads, expected \"local\"; an older MuJoCo writes it "
        "anew with mj_saveLastXML.");
}

void take_default(const XmlNode& node, const ElementDefaults& around, const std::string& name, Model& m) {
  ElementDefaults& own = m.classes[name];
  for (const auto& [tag, attributes] : around)
    for (const auto& [key, value] : attributes) own[tag].emplace(key, value);
  for (const XmlNode& child : children(node))
    if (child.tag() != "default")
      for (const auto* a = child.element->FirstAttribute(); a; a = a->Next())
        own[std::string(child.tag())][a->Name()] = a->Value();
  for (const XmlNode& child : children(node, "default")) take_default(child, own, required_name(child, "class"), m);
}

void take_assets(const XmlNode& node, Model& m) {
  for (const XmlNode& mesh : children(node, "mesh"))
    if (const auto file = find_text(mesh, "file"))
      m.meshes[find_text(mesh, "name").value_or(fs::path(*file).stem().string())] =
          (m.mesh_folder.empty() ? fs::path(*file) : fs::path(m.mesh_folder) / *file).string();
}

std::map<char, Vector3> axes() { return {{'x', Vector3::UnitX()}, {'y', Vector3::UnitY()}, {'z', Vector3::UnitZ()}}; }

Matrix3 euler_rotation(const Element& e, const std::vector<double>& angles) {
  Matrix3 rotation = Matrix3::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = e.model.euler[i];
    const bool stays = letter < 'a';
    const Vector3 axis = axes().at(stays ? static_cast<char>(letter - 'A' + 'a') : letter);
    const Matrix3 turn = rotation_from_vector(Vector3(axis * e.radians(angles[i])));
    rotation = stays ? Matrix3(turn * rotation) : Matrix3(rotation * turn);
  }
  return rotation;
}

Vector3 direction(const Element& e, const double* numbers, const char* attribute) {
  const Vector3 v(numbers);
  if (!(v.norm() > 1e-12)) refuse(e.node, message("has {} without a direction, expected one.", verbatim(attribute)));
  return v.normalized();
}

Matrix3 rotation_of(const Element& e) {
  if (const auto q = e.numbers("quat", 4)) {
    const Eigen::Quaterniond turn((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
    if (!(turn.norm() > 1e-12)) refuse(e.node, "has a quat of length 0, expected w x y z.");
    return turn.normalized().toRotationMatrix();
  }
  if (const auto a = e.numbers("axisangle", 4))
    return rotation_from_vector(Vector3(direction(e, a->data(), "axisangle") * e.radians((*a)[3])));
  if (const auto angles = e.numbers("euler", 3)) return euler_rotation(e, *angles);
  if (const auto xy = e.numbers("xyaxes", 6)) {
    Matrix3 rotation;
    rotation.col(0) = direction(e, xy->data(), "xyaxes");
    const Vector3 y(xy->data() + 3);
    const Vector3 across = y - rotation.col(0) * rotation.col(0).dot(y);
    rotation.col(1) = direction(e, across.data(), "xyaxes");
    rotation.col(2) = rotation.col(0).cross(rotation.col(1));
    return rotation;
  }
  if (const auto z = e.numbers("zaxis", 3))
    return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), direction(e, z->data(), "zaxis")).toRotationMatrix();
  return Matrix3::Identity();
}

}  // namespace

Model read_model(const fs::path& path, const std::string& file) {
  Model m;
  m.file = file;
  m.document = parse_xml(read_file(path), m.file);
  const XmlNode root = require_root(*m.document, m.file, "mujoco");
  Includer(*m.document, path.parent_path(), m.file).expand(*m.document->RootElement());
  for (const XmlNode& compiler : children(root, "compiler")) take_compiler(compiler, m);
  for (const XmlNode& defaults : children(root, "default"))
    take_default(defaults, m.classes[""], find_text(defaults, "class").value_or(""), m);
  for (const XmlNode& defaults : children(root, "default"))  // the outermost has a name of its own, or none
    if (const auto name = find_text(defaults, "class")) m.classes[""] = m.classes[*name];
  for (const XmlNode& assets : children(root, "asset")) take_assets(assets, m);
  return m;
}

std::optional<std::string> Element::text(const char* attribute) const {
  if (auto own = find_text(node, attribute)) return own;
  const std::string name = find_text(node, "class").value_or(around);
  const auto found = model.classes.find(name);
  if (found == model.classes.end()) {
    if (name.empty()) return std::nullopt;
    refuse(node, message("is of the class {}, which no <default> describes.", in_quotes(name)));
  }
  const auto of_tag = found->second.find(std::string(node.tag()));
  if (of_tag == found->second.end()) return std::nullopt;
  const auto value = of_tag->second.find(attribute);
  return value == of_tag->second.end() ? std::nullopt : std::optional(value->second);
}

std::optional<std::vector<double>> Element::numbers(const char* attribute, std::size_t count, std::size_t least) const {
  const auto reported = text(attribute);
  if (!reported) return std::nullopt;
  auto all = parse_numbers(*reported);
  if (!all || all->size() > count || all->size() < (least ? least : count))
    refuse(node, message("has {}={}, expected {} finite numbers.", verbatim(attribute), in_quotes(*reported), count));
  for (const double number : *all)
    if (!bounds::length.hold(number) && !bounds::joint.hold(number))
      refuse(node, message("has {:g} in {}, far outside of any robot.", number, verbatim(attribute)));
  return all;
}

double Element::number(const char* attribute, double missing) const {
  const auto one = numbers(attribute, 1);
  return one ? one->front() : missing;
}

Vector3 Element::vector(const char* attribute, const Vector3& missing) const {
  const auto three = numbers(attribute, 3);
  return three ? Vector3(three->data()) : missing;
}

Rigid locate(const Element& element) { return {rotation_of(element), element.vector("pos", Vector3::Zero())}; }

}  // namespace handsight::mjcf
