// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/mjcf_file.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>

#include "base/files.h"
#include "base/numbers.h"
#include "base/xml.h"

namespace handsight {
namespace {

using tinyxml2::XMLElement;

void set(XMLElement& e, const char* name, std::initializer_list<double> numbers) {
  e.SetAttribute(name, format_numbers({numbers.begin(), numbers.size()}).c_str());
}
void set(XMLElement& e, const char* name, const Vector3& v) { set(e, name, {v.x(), v.y(), v.z()}); }

void set_pose(XMLElement& e, const Rigid& pose) {
  const Eigen::Quaterniond q(pose.rotation);
  set(e, "pos", pose.translation);
  set(e, "quat", {q.w(), q.x(), q.y(), q.z()});
}

std::string body_name(const Link& link) { return link.name == "world" ? "world_link" : link.name; }

/// MuJoCo reads STL with binary numbers alone, of at most 200000 triangles, and OBJ.
bool is_readable_mesh(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".obj" || ending == ".OBJ") return true;
  if (ending != ".stl" && ending != ".STL") return false;
  const std::string bytes = read_file(file);
  if (bytes.size() < 84) return false;
  std::uint32_t count = 0;
  for (int i = 3; i >= 0; --i)
    count = 256 * count + static_cast<unsigned char>(bytes[static_cast<std::size_t>(80 + i)]);
  return count > 0 && count <= 200000 && bytes.size() == 84 + 50 * static_cast<std::size_t>(count);
}

class MjcfWriter {
 public:
  MjcfWriter(const DescribedRobot& robot, const std::filesystem::path& out_folder)
      : d_(robot), out_folder_(out_folder) {}

  std::string text(const Vector3& gravity, std::vector<Message>& notes) {
    document_.InsertEndChild(document_.NewComment((" " + d_.comment + " ").c_str()));
    XMLElement& root = *document_.NewElement("mujoco");
    document_.InsertEndChild(&root);
    root.SetAttribute("model", d_.robot.name.c_str());
    write_compiler(*root.InsertNewChildElement("compiler"));
    set(*root.InsertNewChildElement("option"), "gravity", gravity);
    XMLElement& assets = *root.InsertNewChildElement("asset");
    write_link(*root.InsertNewChildElement("worldbody"), 0, Rigid{});
    for (const auto& [mesh, name] : meshes_) write_mesh(assets, mesh.first, mesh.second, name);
    if (meshes_.empty()) root.DeleteChild(&assets);
    write_equalities(root);
    if (left_out_ > 0)
      notes.push_back(
          message("{} meshes are not in the file: they are not beside the robot, or of a kind that MuJoCo does not "
                  "open (it reads OBJ and binary STL).",
                  left_out_));
    return xml_text(document_);
  }

 private:
  /// A massless link that moves gets the least that MuJoCo accepts; moments that no body has are made equal.
  void write_compiler(XMLElement& e) const {
    e.SetAttribute("angle", "radian");
    e.SetAttribute("inertiafromgeom", "false");
    e.SetAttribute("balanceinertia", "true");
    e.SetAttribute("boundmass", "1e-06");
    e.SetAttribute("boundinertia", "1e-09");
  }

  void write_link(XMLElement& parent, std::size_t link, const Rigid& parent_from_link) {
    XMLElement& body = *parent.InsertNewChildElement("body");
    const Link& l = d_.robot.links[link];
    body.SetAttribute("name", body_name(l).c_str());
    set_pose(body, parent_from_link);
    if (l.parent_joint >= 0) write_joint(body, static_cast<std::size_t>(l.parent_joint));
    write_inertia(body, d_.inertias[link]);
    for (const Shape& s : l.shapes) write_shape(body, s, false);
    for (const Shape& s : d_.collisions[link]) write_shape(body, s, true);
    for (const Joint& j : d_.robot.joints)
      if (static_cast<std::size_t>(j.parent_link) == link)
        write_link(body, static_cast<std::size_t>(j.child_link), j.parent_from_joint);
  }

  void write_joint(XMLElement& body, std::size_t joint) const {
    const Joint& j = d_.robot.joints[joint];
    if (!j.moves()) return;
    XMLElement& e = *body.InsertNewChildElement("joint");
    e.SetAttribute("name", j.name.c_str());
    e.SetAttribute("type", j.kind == JointKind::prismatic ? "slide" : "hinge");
    set(e, "axis", j.axis);
    if (j.kind == JointKind::continuous || !(j.lower > -1e29 && j.upper < 1e29 && j.lower < j.upper)) return;
    e.SetAttribute("limited", "true");
    set(e, "range", {j.lower, j.upper});
  }

  static void write_inertia(XMLElement& body, const LinkInertia& inertia) {
    if (!(inertia.mass > 0)) return;
    XMLElement& e = *body.InsertNewChildElement("inertial");
    set(e, "pos", inertia.center);
    set(e, "mass", {inertia.mass});
    const Matrix3& i = inertia.inertia;
    if (inertia.is_proper())
      set(e, "fullinertia", {i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)});
    else
      set(e, "diaginertia", {1e-9, 1e-9, 1e-9});
  }

  /// Visual shapes touch nothing.
  void write_shape(XMLElement& body, const Shape& s, bool collides) {
    std::string mesh;
    if (s.kind == ShapeKind::mesh && (mesh = mesh_name(s)).empty()) return;
    const Vector3 size = s.kind == ShapeKind::box ? Vector3(s.size / 2) : Vector3(s.size.x(), s.size.y() / 2, 0);
    if (mesh.empty() && !(size.x() > 0 && (s.kind == ShapeKind::sphere || size.y() > 0))) return;
    XMLElement& e = *body.InsertNewChildElement("geom");
    e.SetAttribute("type", s.kind == ShapeKind::box        ? "box"
                           : s.kind == ShapeKind::cylinder ? "cylinder"
                           : s.kind == ShapeKind::sphere   ? "sphere"
                                                           : "mesh");
    if (mesh.empty())
      set(e, "size", size);
    else
      e.SetAttribute("mesh", mesh.c_str());
    set_pose(e, s.link_from_shape);
    e.SetAttribute("group", collides ? 3 : 2);
    if (!collides) e.SetAttribute("contype", 0), e.SetAttribute("conaffinity", 0);
    if (s.color) set(e, "rgba", {(*s.color)[0], (*s.color)[1], (*s.color)[2], (*s.color)[3]});
  }

  /// The asset's name; empty where the file would keep MuJoCo from opening the model.
  std::string mesh_name(const Shape& s) {
    const auto reference = mesh_reference(d_, s.mesh_file, out_folder_);
    if (!reference || !is_readable_mesh(out_folder_ / *reference)) return ++left_out_, "";
    const std::string scale = format_numbers({s.size.data(), 3});
    return meshes_.try_emplace({*reference, scale}, fmt::format("mesh_{}", meshes_.size())).first->second;
  }

  static void write_mesh(XMLElement& assets, const std::string& file, const std::string& scale,
                         const std::string& name) {
    XMLElement& e = *assets.InsertNewChildElement("mesh");
    e.SetAttribute("name", name.c_str());
    e.SetAttribute("file", file.c_str());
    e.SetAttribute("scale", scale.c_str());
  }

  /// MuJoCo's equality is of one joint by one other.
  void write_equalities(XMLElement& root) const {
    XMLElement* all = nullptr;
    for (const Joint& j : d_.robot.joints) {
      if (j.mimics.size() != 1) continue;
      if (!all) all = root.InsertNewChildElement("equality");
      XMLElement& e = *all->InsertNewChildElement("joint");
      e.SetAttribute("joint1", j.name.c_str());
      e.SetAttribute("joint2", d_.robot.joints[static_cast<std::size_t>(j.mimics[0].joint)].name.c_str());
      set(e, "polycoef", {j.mimics[0].offset, j.mimics[0].multiplier, 0, 0, 0});
    }
  }

  const DescribedRobot& d_;
  std::filesystem::path out_folder_;
  tinyxml2::XMLDocument document_;
  std::map<std::pair<std::string, std::string>, std::string> meshes_;  // file and scale: name
  int left_out_ = 0;
};

}  // namespace

std::string mjcf_file(const DescribedRobot& robot, const Vector3& gravity, const std::filesystem::path& out_folder,
                      std::vector<Message>& notes) {
  for (const Joint& j : robot.robot.joints)
    if (j.mimics.size() > 1)
      notes.push_back(message("MuJoCo has no equality for {}, which follows {} joints: set it from your program.",
                              j.name, j.mimics.size()));
  return MjcfWriter(robot, out_folder).text(gravity, notes);
}

}  // namespace handsight
