// SPDX-License-Identifier: Apache-2.0
#include "export/rigid/described_robot.h"

#include <Eigen/Eigenvalues>

#include "base/text.h"
#include "base/xml.h"
#include "robot/mesh.h"
#include "robot/urdf.h"
#include "robot/urdf_parts.h"
#include "robot/xml_rigid.h"

namespace handsight {
namespace {

LinkInertia inertia_of(const XmlNode& link) {
  LinkInertia read;
  const auto inertial = find_child(link, "inertial");
  if (!inertial) return read;
  const auto origin = find_child(*inertial, "origin");
  const Rigid link_from_inertia = origin ? read_rigid(*origin) : Rigid{};
  read.center = link_from_inertia.translation;
  if (const auto mass = find_child(*inertial, "mass")) read.mass = find_number(*mass, "value").value_or(0);
  const auto i = find_child(*inertial, "inertia");
  if (!i) return read;
  const auto at = [&](const char* name) { return find_number(*i, name).value_or(0); };
  Matrix3 own;
  own << at("ixx"), at("ixy"), at("ixz"), at("ixy"), at("iyy"), at("iyz"), at("ixz"), at("iyz"), at("izz");
  read.inertia = link_from_inertia.rotation * own * link_from_inertia.rotation.transpose();
  return read;
}

/// The <collision> shapes, read as the <visual> ones are.
std::vector<Shape> collisions_of(const XmlNode& link) {
  tinyxml2::XMLDocument apart;
  tinyxml2::XMLElement* const copy = apart.NewElement("link");
  apart.InsertEndChild(copy);
  for (const XmlNode& collision : children(link, "collision")) {
    tinyxml2::XMLNode* const shape = copy->InsertEndChild(collision.element->DeepClone(&apart));
    shape->ToElement()->SetName("visual");
  }
  urdf::Notes notes;
  return urdf::read_shapes({copy, link.file}, {}, notes);
}

JointStrength strength_of(const XmlNode& joint) {
  const auto limit = find_child(joint, "limit");
  if (!limit) return {};
  return {find_number(*limit, "effort"), find_number(*limit, "velocity")};
}

std::string comment_of(const CalibratedRobot& robot, const UrdfFile& file) {
  std::string text = fmt::format("Calibrated by Handsight from {}. {} is the hand, {} the marker body",
                                 in_quotes(robot.calibration.session, 200), file.hand_link, file.body_link);
  text += file.sensor_link.empty() ? "." : fmt::format(", {} the sensor.", file.sensor_link);
  for (const Message& s : file.not_said) text += "\n  Not in this file: " + printable(s.english()) + ".";
  if (const std::string left = left_sentence(file.fit); !left.empty()) text += "\n  " + left;
  for (std::size_t at; (at = text.find("--")) != std::string::npos;) text.replace(at, 2, "- -");
  return text;
}

}  // namespace

bool LinkInertia::is_proper() const {
  if (!(mass > 0)) return false;
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(inertia, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues()[0] > 1e-12;
}

DescribedRobot described_robot(const CalibratedRobot& robot, Holds holds) {
  DescribedRobot d;
  d.urdf = urdf_file(robot, holds);
  d.robot = parse_urdf(d.urdf.text, robot.urdf_file, nullptr);
  d.mesh_folder = robot.robot_folder;
  const auto document = parse_xml(d.urdf.text, robot.urdf_file);
  const XmlNode root{document->RootElement(), robot.urdf_file};
  d.inertias.resize(d.robot.links.size());
  d.collisions.resize(d.robot.links.size());
  d.strengths.resize(d.robot.joints.size());
  for (const XmlNode& link : children(root, "link")) {
    const auto l = static_cast<std::size_t>(find_link(d.robot, required_name(link, "name")));
    d.inertias[l] = inertia_of(link);
    d.collisions[l] = collisions_of(link);
  }
  for (const XmlNode& joint : children(root, "joint"))
    d.strengths[static_cast<std::size_t>(find_joint(d.robot, required_name(joint, "name")))] = strength_of(joint);
  d.comment = comment_of(robot, d.urdf);
  return d;
}

std::optional<std::string> mesh_reference(const DescribedRobot& robot, const std::string& written,
                                          const std::filesystem::path& out_folder) {
  if (robot.mesh_folder.empty()) return std::nullopt;
  const auto mesh = find_mesh(written, robot.mesh_folder);
  if (!mesh) return std::nullopt;
  const auto from = std::filesystem::weakly_canonical(out_folder.empty() ? "." : out_folder);
  return std::filesystem::weakly_canonical(*mesh).lexically_relative(from).generic_string();
}

Message left_sentence(const RigidFit& fit) {
  if (fit.left.largest < 1e-9) return "";
  const double rms = 1e3 * fit.left.rms, largest = 1e3 * fit.left.largest, nominal = 1e3 * fit.nominal.rms;
  if (fit.are_measured)
    return message(
        "What this kind of file cannot hold was left out and the rest fitted again without it: over the {} poses of "
        "the "
        "session the hand is {:.3f} mm rms and {:.3f} mm at most from where the whole calibration has it; without "
        "calibration it is {:.3f} mm rms.",
        fit.poses, rms, largest, nominal);
  return message(
      "What this kind of file cannot hold was left out and the rest fitted again without it: over {} poses drawn "
      "within "
      "the joints' limits, for the calibration does not say where it was measured, the hand is {:.3f} mm rms and "
      "{:.3f} "
      "mm at most from where the whole calibration has it; without calibration it is {:.3f} mm rms.",
      fit.poses, rms, largest, nominal);
}

}  // namespace handsight
