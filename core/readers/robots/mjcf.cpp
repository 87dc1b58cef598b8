// SPDX-License-Identifier: Apache-2.0
#include "readers/robots/mjcf.h"

#include <map>
#include <set>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/robots/mjcf_mass.h"
#include "readers/robots/mjcf_model.h"
#include "robot/xml_rigid.h"

namespace handsight {
namespace {

using namespace mjcf;
using tinyxml2::XMLElement;

constexpr int deepest = 200;

class UrdfWriter {
 public:
  UrdfWriter(const Model& model, std::vector<Message>& notes) : model_(model), notes_(notes) {
    root_ = document_.NewElement("robot");
    document_.InsertEndChild(root_);
  }

  std::string written() {
    const XmlNode mujoco{model_.document->RootElement(), model_.file};
    root_->SetAttribute("name", find_text(mujoco, "model").value_or("robot").c_str());
    add_link("world", {});
    for (const XmlNode& world : children(mujoco, "worldbody")) add_parts({model_, world, ""}, "world", Rigid{}, 0);
    for (const XmlNode& equality : children(mujoco, "equality")) add_mimics(equality);
    tell_what_stands_still();
    return xml_text(document_);
  }

 private:
  /// The children of a body (or of the world, or of a <frame>, whose place comes before theirs).
  void add_parts(const Element& parent, const std::string& link, const Rigid& before, int depth) {
    if (depth > deepest) refuse(parent.node, "is nested more deeply than any robot is.");
    const std::string around = find_text(parent.node, "childclass").value_or(parent.around);
    for (const XmlNode& child : children(parent.node)) {
      const Element e{model_, child, around};
      if (child.tag() == "body") add_body(e, link, before, depth + 1);
      if (child.tag() == "site") add_site(e, link, before);
      if (child.tag() == "frame") add_parts(e, link, before * locate(e), depth + 1);
      for (const char* unread : {"replicate", "attach", "composite", "flexcomp"})
        if (child.tag() == unread)
          refuse(child, message("<{}> makes other bodies, which is not read; write the whole model with "
                                "mj_saveLastXML (`simulate` has it as Save xml) and name that.",
                                unread));
    }
  }

  void add_body(const Element& body, const std::string& parent, const Rigid& before, int depth) {
    const std::string name =
        new_link_name(find_text(body.node, "name").value_or(fmt::format("body_{}", links_.size())));
    const std::string around = find_text(body.node, "childclass").value_or(body.around);
    std::vector<Element> geoms, joints;
    for (const XmlNode& child : children(body.node)) {
      if (child.tag() == "geom") geoms.push_back({model_, child, around});
      if (child.tag() == "joint") joints.push_back({model_, child, around});
      if (child.tag() == "freejoint") still_.push_back(name + " (free)");
    }
    links_.insert(name);
    add_joints(joints, parent, name, before * locate(body));
    XMLElement* const link = add_link(name, read_mass({model_, body.node, around}, geoms));
    for (const Element& geom : geoms) add_visual(*link, geom);
    add_parts(body, name, Rigid{}, depth);
  }

  /// Each joint turns about its own place in the body: there, and back to the body's origin.
  void add_joints(const std::vector<Element>& joints, const std::string& parent, const std::string& name, Rigid place) {
    std::string from = parent;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Element& joint = joints[i];
      const std::string kind = joint.text("type").value_or("hinge");
      if (kind != "hinge" && kind != "slide") {
        still_.push_back(fmt::format("{} ({})", find_text(joint.node, "name").value_or(name), kind));
        continue;
      }
      const Vector3 at = joint.vector("pos", Vector3::Zero());
      const bool is_last = i + 1 == joints.size() && at.isZero(0);
      const std::string to = is_last ? name : new_link_name(fmt::format("{}_{}", name, i + 1));
      if (!is_last) add_link(to, {});
      add_moving(joint, kind == "hinge", from, to, place * Rigid{Matrix3::Identity(), at});
      from = to;
      place = {Matrix3::Identity(), -at};
    }
    if (from != name) add_fixed(name + "_fixed", from, name, place);
  }

  void add_moving(const Element& joint, bool turns, const std::string& from, const std::string& to,
                  const Rigid& place) {
    const std::string name = new_joint_name(find_text(joint.node, "name").value_or(to + "_joint"));
    const Vector3 reported = joint.vector("axis", Vector3::UnitZ());
    if (!(reported.norm() > 1e-12)) refuse(joint.node, "has an axis without a direction, expected one.");
    const Vector3 axis = reported.normalized();
    const auto unit = [&](double value) { return turns ? joint.radians(value) : value; };
    const double reference = unit(joint.number("ref", 0));  // what the joint tells where the model stands as written
    const auto range = joint.numbers("range", 2);
    const bool is_limited = range && joint.text("limited").value_or("auto") != "false" && (*range)[0] < (*range)[1];
    XMLElement& e = add_joint(name, turns ? is_limited ? "revolute" : "continuous" : "prismatic", from, to,
                              place * (turns ? Rigid{rotation_from_vector(Vector3(-reference * axis)), Vector3::Zero()}
                                             : Rigid{Matrix3::Identity(), -reference * axis}));
    child(e, "axis").SetAttribute("xyz", format_numbers({axis.data(), 3}).c_str());
    references_[name] = reference;
    if (!is_limited) return;
    XMLElement& limit = child(e, "limit");
    limit.SetAttribute("lower", format_number(unit((*range)[0])).c_str());
    limit.SetAttribute("upper", format_number(unit((*range)[1])).c_str());
    limit.SetAttribute("effort", "0");
    limit.SetAttribute("velocity", "0");
  }

  /// A site is a frame: where tools are fixed, for example.
  void add_site(const Element& site, const std::string& link, const Rigid& before) {
    const auto name = find_text(site.node, "name");
    if (!name || name->empty()) return;
    const std::string own = new_link_name(links_.contains(*name) ? *name + "_site" : *name);
    add_link(own, {});
    add_fixed(own + "_fixed", link, own, before * locate(site));
  }

  /// joint1 = a0 + a1 (joint2 - ref2) + ref1
  void add_mimics(const XmlNode& equality) {
    for (const XmlNode& node : children(equality, "joint")) {
      const Element e{model_, node, ""};
      const auto joint = e.text("joint1"), of = e.text("joint2");
      const auto c = e.numbers("polycoef", 5, 1).value_or(std::vector<double>{0, 1, 0, 0, 0});
      if (!joint || !of || e.text("active").value_or("true") == "false") continue;
      const auto follows = joints_.find(*joint);
      const bool is_line = c.size() < 3 || std::all_of(c.begin() + 2, c.end(), [](double x) { return x == 0; });
      if (follows == joints_.end() || !joints_.contains(*of) || !is_line) {
        notes_.push_back(message("{}: that {} follows {} is left out: it is no straight line.", model_.file,
                                 in_quotes(*joint), in_quotes(*of)));
        continue;
      }
      const double slope = c.size() > 1 ? c[1] : 0;
      XMLElement& mimic = child(*follows->second, "mimic");
      mimic.SetAttribute("joint", of->c_str());
      mimic.SetAttribute("multiplier", format_number(slope).c_str());
      mimic.SetAttribute("offset", format_number(c[0] + references_[*joint] - slope * references_[*of]).c_str());
    }
  }

  void add_visual(XMLElement& link, const Element& geom) {
    const mjcf::MassShape s = make_shape(geom);
    if (s.kind == "mesh") return add_mesh(link, geom, s);
    if (s.kind != "box" && s.kind != "cylinder" && s.kind != "capsule" && s.kind != "sphere") return;
    XMLElement& shape = add_geometry(link, s.place, s.kind == "capsule" ? "cylinder" : s.kind.c_str());
    if (s.kind == "box") {
      shape.SetAttribute("size", format_numbers(std::vector{2 * s.size.x(), 2 * s.size.y(), 2 * s.size.z()}).c_str());
      return;
    }
    shape.SetAttribute("radius", format_number(s.size.x()).c_str());
    if (s.kind != "sphere") shape.SetAttribute("length", format_number(2 * s.size.y()).c_str());
  }

  void add_mesh(XMLElement& link, const Element& geom, const mjcf::MassShape& s) {
    const auto mesh = model_.meshes.find(geom.text("mesh").value_or(""));
    if (mesh != model_.meshes.end()) add_geometry(link, s.place, "mesh").SetAttribute("filename", mesh->second.c_str());
  }

  static XMLElement& add_geometry(XMLElement& link, const Rigid& place, const char* kind) {
    XMLElement& visual = child(link, "visual");
    write_rigid(child(visual, "origin"), place);
    return child(child(visual, "geometry"), kind);
  }

  void tell_what_stands_still() {
    if (still_.empty()) return;
    notes_.push_back(message("{}: {} stand still in the session's copy: a session has one number a joint.", model_.file,
                             shortened(fmt::format("{}", fmt::join(still_, ", ")), 300)));
  }

  XMLElement* add_link(const std::string& name, const Mass& mass) {
    links_.insert(name);
    XMLElement& link = child(*root_, "link");
    link.SetAttribute("name", name.c_str());
    if (mass.kilograms <= 0) return &link;
    XMLElement& inertial = child(link, "inertial");
    write_rigid(child(inertial, "origin"), {Matrix3::Identity(), mass.center});
    child(inertial, "mass").SetAttribute("value", format_number(mass.kilograms).c_str());
    return &link;
  }

  XMLElement& add_joint(const std::string& name, const char* type, const std::string& from, const std::string& to,
                        const Rigid& place) {
    XMLElement& joint = child(*root_, "joint");
    joint.SetAttribute("name", name.c_str());
    joint.SetAttribute("type", type);
    child(joint, "parent").SetAttribute("link", from.c_str());
    child(joint, "child").SetAttribute("link", to.c_str());
    write_rigid(child(joint, "origin"), place);
    joints_[name] = &joint;
    return joint;
  }

  void add_fixed(const std::string& name, const std::string& from, const std::string& to, const Rigid& place) {
    add_joint(new_joint_name(name), "fixed", from, to, place);
  }

  static XMLElement& child(XMLElement& parent, const char* tag) { return *parent.InsertNewChildElement(tag); }

  std::string new_link_name(std::string name) const {
    while (links_.contains(name)) name += "_";
    return name;
  }
  std::string new_joint_name(std::string name) const {
    while (joints_.contains(name)) name += "_";
    return name;
  }

  const Model& model_;
  std::vector<Message>& notes_;
  tinyxml2::XMLDocument document_;
  XMLElement* root_ = nullptr;
  std::set<std::string> links_;
  std::map<std::string, XMLElement*> joints_;
  std::map<std::string, double> references_;  // rad or m
  std::vector<std::string> still_;
};

}  // namespace

bool is_mjcf(const std::string& text) {
  const std::size_t at = text.find("<mujoco");
  return at != std::string::npos && text.find("<robot") == std::string::npos && at + 7 < text.size() &&
         std::string_view(" \t\r\n>/").find(text[at + 7]) != std::string_view::npos;
}

std::string urdf_of_mjcf(const std::filesystem::path& path, const std::string& file, std::vector<Message>& notes) {
  const Model model = read_model(path, file);
  return UrdfWriter(model, notes).written();
}

}  // namespace handsight
