// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/sdf_file.h"

#include "base/numbers.h"
#include "base/xml.h"

namespace handsight {
namespace {

using tinyxml2::XMLElement;

void set_text(XMLElement& parent, const char* tag, const std::string& text) {
  parent.InsertNewChildElement(tag)->SetText(text.c_str());
}
void set_text(XMLElement& parent, const char* tag, double number) { set_text(parent, tag, format_number(number)); }
void set_text(XMLElement& parent, const char* tag, const Vector3& v) {
  set_text(parent, tag, format_numbers({v.data(), 3}));
}

XMLElement& write_sdf_pose(XMLElement& parent, const Rigid& pose) {
  const Vector3 rpy = rpy_from_rotation(pose.rotation);
  XMLElement& e = *parent.InsertNewChildElement("pose");
  e.SetText((format_numbers({pose.translation.data(), 3}) + " " + format_numbers({rpy.data(), 3})).c_str());
  return e;
}

std::string sdf_name(const std::string& link) { return link == "world" ? "world_link" : link; }

/// Links, frames and joints share their names there, as they do not in a URDF.
std::string joint_name(const Robot& robot, const Joint& joint) {
  std::string name = joint.name;
  while (find_link(robot, name) >= 0 || name == "world" || (name != joint.name && find_joint(robot, name) >= 0))
    name += "_joint";
  return name;
}

class SdfWriter {
 public:
  SdfWriter(const DescribedRobot& robot, const std::filesystem::path& out_folder)
      : d_(robot), out_folder_(out_folder) {}

  std::string text(std::vector<Message>& notes) {
    document_.InsertEndChild(document_.NewDeclaration());
    document_.InsertEndChild(document_.NewComment((" " + d_.comment + " ").c_str()));
    XMLElement& root = *document_.NewElement("sdf");
    document_.InsertEndChild(&root);
    root.SetAttribute("version", "1.7");
    XMLElement& model = *root.InsertNewChildElement("model");
    model.SetAttribute("name", d_.robot.name.c_str());
    fix_root(model);
    for (std::size_t l = 0; l < d_.robot.links.size(); ++l)
      if (!is_frame(l)) write_link(model, l);
    for (std::size_t j = 0; j < d_.robot.joints.size(); ++j)
      if (is_frame(static_cast<std::size_t>(d_.robot.joints[j].child_link)))
        write_frame(model, d_.robot.joints[j]);
      else
        write_joint(model, j);
    if (missing_ > 0)
      notes.push_back(
          message("{} meshes were not found beside the robot; the file names them as the URDF does.", missing_));
    return xml_text(document_);
  }

 private:
  /// A place and nothing more: a tool's tip, a sensor.
  bool is_frame(std::size_t link) const {
    const Link& l = d_.robot.links[link];
    return l.parent_joint >= 0 && !d_.robot.joints[static_cast<std::size_t>(l.parent_joint)].moves() &&
           !(d_.inertias[link].mass > 0) && l.shapes.empty() && d_.collisions[link].empty();
  }

  void fix_root(XMLElement& model) const {
    XMLElement& e = *model.InsertNewChildElement("joint");
    std::string name = "handsight_world";
    while (find_joint(d_.robot, name) >= 0 || find_link(d_.robot, name) >= 0) name += "_";
    e.SetAttribute("name", name.c_str());
    e.SetAttribute("type", "fixed");
    set_text(e, "parent", std::string("world"));
    set_text(e, "child", sdf_name(d_.robot.links[0].name));
  }

  std::string display_name(int link) const { return sdf_name(d_.robot.links[static_cast<std::size_t>(link)].name); }

  void write_frame(XMLElement& model, const Joint& j) const {
    XMLElement& e = *model.InsertNewChildElement("frame");
    e.SetAttribute("name", display_name(j.child_link).c_str());
    e.SetAttribute("attached_to", display_name(j.parent_link).c_str());
    write_sdf_pose(e, j.parent_from_joint);
  }

  void write_link(XMLElement& model, std::size_t link) {
    const Link& l = d_.robot.links[link];
    XMLElement& e = *model.InsertNewChildElement("link");
    e.SetAttribute("name", sdf_name(l.name).c_str());
    if (l.parent_joint >= 0)
      write_sdf_pose(e, {}).SetAttribute(
          "relative_to", joint_name(d_.robot, d_.robot.joints[static_cast<std::size_t>(l.parent_joint)]).c_str());
    write_inertia(e, d_.inertias[link]);
    int number = 0;
    for (const Shape& s : l.shapes) write_shape(e, "visual", number++, s);
    number = 0;
    for (const Shape& s : d_.collisions[link]) write_shape(e, "collision", number++, s);
  }

  /// SDFormat takes a link without numbers for one of 1 kg: one without mass gets nearly none.
  static void write_inertia(XMLElement& link, const LinkInertia& inertia) {
    XMLElement& e = *link.InsertNewChildElement("inertial");
    write_sdf_pose(e, {Matrix3::Identity(), inertia.center});
    set_text(e, "mass", inertia.mass > 0 ? inertia.mass : 1e-6);
    const Matrix3 i = inertia.is_proper() ? inertia.inertia : Matrix3(1e-9 * Matrix3::Identity());
    XMLElement& moments = *e.InsertNewChildElement("inertia");
    const char* names[3][3] = {{"ixx", "ixy", "ixz"}, {"", "iyy", "iyz"}, {"", "", "izz"}};
    for (int r = 0; r < 3; ++r)
      for (int c = r; c < 3; ++c) set_text(moments, names[r][c], i(r, c));
  }

  void write_shape(XMLElement& link, const char* tag, int number, const Shape& s) {
    XMLElement& e = *link.InsertNewChildElement(tag);
    e.SetAttribute("name", fmt::format("{}_{}", tag, number).c_str());
    write_sdf_pose(e, s.link_from_shape);
    XMLElement& geometry = *e.InsertNewChildElement("geometry");
    if (s.kind == ShapeKind::box) set_text(*geometry.InsertNewChildElement("box"), "size", s.size);
    if (s.kind == ShapeKind::sphere) set_text(*geometry.InsertNewChildElement("sphere"), "radius", s.size.x());
    if (s.kind == ShapeKind::cylinder) {
      XMLElement& cylinder = *geometry.InsertNewChildElement("cylinder");
      set_text(cylinder, "radius", s.size.x());
      set_text(cylinder, "length", s.size.y());
    }
    if (s.kind == ShapeKind::mesh) write_mesh(*geometry.InsertNewChildElement("mesh"), s);
    if (s.color) {
      const std::string color = format_numbers({s.color->data(), 4});
      XMLElement& material = *e.InsertNewChildElement("material");
      for (const char* kind : {"ambient", "diffuse"}) set_text(material, kind, color);
    }
  }

  void write_mesh(XMLElement& mesh, const Shape& s) {
    const auto reference = mesh_reference(d_, s.mesh_file, out_folder_);
    missing_ += !reference;
    set_text(mesh, "uri", reference.value_or(s.mesh_file));
    set_text(mesh, "scale", s.size);
  }

  void write_joint(XMLElement& model, std::size_t joint) const {
    const Joint& j = d_.robot.joints[joint];
    XMLElement& e = *model.InsertNewChildElement("joint");
    e.SetAttribute("name", joint_name(d_.robot, j).c_str());
    e.SetAttribute("type", j.kind == JointKind::fixed        ? "fixed"
                           : j.kind == JointKind::prismatic  ? "prismatic"
                           : j.kind == JointKind::continuous ? "continuous"
                                                             : "revolute");
    write_sdf_pose(e, j.parent_from_joint).SetAttribute("relative_to", display_name(j.parent_link).c_str());
    set_text(e, "parent", display_name(j.parent_link));
    set_text(e, "child", display_name(j.child_link));
    if (j.moves()) write_axis(*e.InsertNewChildElement("axis"), j, d_.strengths[joint]);
  }

  static void write_axis(XMLElement& axis, const Joint& j, const JointStrength& strength) {
    set_text(axis, "xyz", j.axis);
    XMLElement& limit = *axis.InsertNewChildElement("limit");
    if (j.kind != JointKind::continuous && j.lower > -1e29 && j.upper < 1e29) {
      set_text(limit, "lower", j.lower);
      set_text(limit, "upper", j.upper);
    }
    if (strength.effort) set_text(limit, "effort", *strength.effort);
    if (strength.velocity) set_text(limit, "velocity", *strength.velocity);
  }

  const DescribedRobot& d_;
  std::filesystem::path out_folder_;
  tinyxml2::XMLDocument document_;
  int missing_ = 0;
};

}  // namespace

std::string sdf_file(const DescribedRobot& robot, const std::filesystem::path& out_folder,
                     std::vector<Message>& notes) {
  for (const Joint& j : robot.robot.joints)
    if (j.is_mimic())
      notes.push_back(
          message("SDFormat 1.7 has no joint that follows others: {} moves by itself in the file, command it as well.",
                  j.name));
  return SdfWriter(robot, out_folder).text(notes);
}

}  // namespace handsight
