// SPDX-License-Identifier: Apache-2.0
#include "experiment/paths/robot_solids.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "base/xml.h"
#include "robot/collision_shapes.h"
#include "robot/mesh.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

constexpr double limb_radius = 0.04;       // m
constexpr double limb_slenderness = 0.35;  // of a short limb's length is its radius
constexpr int most_halvings = 3;           // of a mesh
constexpr double least_saving = 0.85;      // of the volume, of two halves beside the whole
constexpr double thinnest = 1e-3;          // m: half a side of a box

using Triangle = std::array<Vector3, 3>;

struct TurnedBox {
  Rigid frame;
  Vector3 half = Vector3::Zero();

  double volume() const { return half.prod(); }
};

/// Along the principal axes of the points, or along the frame's, whichever box is smaller.
TurnedBox box_about(const std::vector<Triangle>& triangles) {
  Vector3 mean = Vector3::Zero();
  for (const Triangle& t : triangles)
    for (const Vector3& x : t) mean += x / (3.0 * static_cast<double>(triangles.size()));
  Matrix3 spread = Matrix3::Zero();
  for (const Triangle& t : triangles)
    for (const Vector3& x : t) spread += (x - mean) * (x - mean).transpose();
  Matrix3 axes = Eigen::SelfAdjointEigenSolver<Matrix3>(spread).eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  TurnedBox best;
  for (const Matrix3& turned : {Matrix3(Matrix3::Identity()), axes}) {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const Triangle& t : triangles)
      for (const Vector3& x : t) {
        const Vector3 y = turned.transpose() * x;
        low = low.cwiseMin(y);
        high = high.cwiseMax(y);
      }
    const TurnedBox box{{turned, turned * (0.5 * (low + high))}, (0.5 * (high - low)).cwiseMax(thinnest)};
    if (best.volume() == 0 || box.volume() < 0.95 * best.volume()) best = box;
  }
  return best;
}

void halve(std::vector<Triangle> triangles, int halvings, std::vector<TurnedBox>& boxes) {
  const TurnedBox whole = box_about(triangles);
  Eigen::Index longest = 0;
  whole.half.maxCoeff(&longest);
  const Vector3 along = whole.frame.rotation.col(longest);
  const double middle = along.dot(whole.frame.translation);
  const auto second = std::partition(triangles.begin(), triangles.end(),
                                     [&](const Triangle& t) { return along.dot(t[0] + t[1] + t[2]) < 3 * middle; });
  std::vector<Triangle> low(triangles.begin(), second), high(second, triangles.end());
  if (halvings == 0 || low.empty() || high.empty()) return boxes.push_back(whole);
  std::vector<TurnedBox> parts;
  halve(std::move(low), halvings - 1, parts);
  halve(std::move(high), halvings - 1, parts);
  double volume = 0;
  for (const TurnedBox& part : parts) volume += part.volume();
  if (volume > least_saving * whole.volume()) return boxes.push_back(whole);
  boxes.insert(boxes.end(), parts.begin(), parts.end());
}

void add_shape(const Shape& shape, int link, const fs::path& robot_folder, RobotSolids& all) {
  RobotSolid solid{RobotSolidKind::box, link, shape.link_from_shape, 0.5 * shape.size};
  switch (shape.kind) {
    case ShapeKind::box:
      break;
    case ShapeKind::sphere:
      solid.kind = RobotSolidKind::sphere;
      solid.size = {shape.size.x(), 0, 0};
      break;
    case ShapeKind::cylinder:
      solid.kind = RobotSolidKind::cylinder;
      solid.size = {shape.size.x(), 0, 0.5 * shape.size.y()};
      break;
    case ShapeKind::mesh:
      try {
        const auto file = find_mesh(shape.mesh_file, robot_folder);
        if (!file) throw InputError(message("{} is not there", in_quotes(shape.mesh_file)));
        for (const RobotSolid& box : make_boxes(read_mesh(*file), shape.size, link, shape.link_from_shape))
          all.solids.push_back(box);
      } catch (const InputError& error) {
        all.notes.push_back(message("A mesh is left out of the robot's shapes: {}", error.what()));
      }
      return;
  }
  all.solids.push_back(solid);
}

/// A capsule from the link's frame to `end`; short ones are thin.
RobotSolid limb(int link, const Vector3& end) {
  const double length = end.norm();
  const double radius = std::min(limb_radius, limb_slenderness * length);
  RobotSolid capsule{RobotSolidKind::capsule, link, {Matrix3::Identity(), 0.5 * end}, {radius, 0, 0.5 * length}};
  capsule.link_from_solid.rotation.col(2) = end / length;
  capsule.link_from_solid.rotation.col(0) = capsule.link_from_solid.rotation.col(2).unitOrthogonal();
  capsule.link_from_solid.rotation.col(1) =
      capsule.link_from_solid.rotation.col(2).cross(capsule.link_from_solid.rotation.col(0));
  return capsule;
}

/// A plausible limb for a link that has no shapes; nothing for frames on which nothing hangs and that weigh nothing.
void add_limbs(const Robot& robot, int link, RobotSolids& all) {
  bool has_any = false;
  for (const Joint& joint : robot.joints)
    if (joint.parent_link == link && joint.parent_from_joint.translation.norm() > 1e-6) {
      all.solids.push_back(limb(link, joint.parent_from_joint.translation));
      has_any = true;
    }
  const Link& last = robot.links[static_cast<std::size_t>(link)];
  if (has_any || !(last.mass > 0) || last.parent_joint < 0) return;
  const double length = robot.joints[static_cast<std::size_t>(last.parent_joint)].parent_from_joint.translation.norm();
  all.solids.push_back(
      {RobotSolidKind::sphere, link, {}, {std::min(limb_radius, limb_slenderness * std::max(length, 0.03)), 0, 0}});
}

/// <disable_collisions link1="" link2=""/> of the SRDF files beside the robot.
void read_srdf(const fs::path& robot_file, RobotSolids& all) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(robot_file.parent_path(), error)) {
    if (entry.path().extension() != ".srdf") continue;
    const std::string name = entry.path().filename().string(), text = read_file(entry.path());
    const auto document = parse_xml(text, name);
    for (const XmlNode& pair : children(require_root(*document, name, "robot"), "disable_collisions")) {
      const std::string a = required_name(pair, "link1"), b = required_name(pair, "link2");
      all.never_watched.insert({std::min(a, b), std::max(a, b)});
    }
    all.notes.push_back(message("{}: {} pairs of links are not watched, as it says.", name, all.never_watched.size()));
  }
}

}  // namespace

double RobotSolid::reach() const {
  switch (kind) {
    case RobotSolidKind::box:
      return size.norm();
    case RobotSolidKind::capsule:
      return size.x() + size.z();
    case RobotSolidKind::cylinder:
      return std::hypot(size.x(), size.z());
    default:
      return size.x();
  }
}

std::vector<RobotSolid> make_boxes(const Mesh& mesh, const Vector3& scale, int link, const Rigid& link_from_mesh) {
  std::vector<Triangle> triangles;
  for (const auto& t : mesh.triangles) {
    Triangle& triangle = triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = mesh.points[t[i]].cast<double>().cwiseProduct(scale);
  }
  std::vector<TurnedBox> boxes;
  if (!triangles.empty()) halve(std::move(triangles), most_halvings, boxes);
  std::vector<RobotSolid> solids;
  for (const TurnedBox& box : boxes)
    solids.push_back({RobotSolidKind::box, link, link_from_mesh * box.frame, box.half});
  return solids;
}

RobotSolids robot_solids(const Session& session) {
  const fs::path file = folder(session) / session.robot_file;
  std::error_code error;
  const bool has_file = !session.robot_file.empty() && fs::is_regular_file(file, error);
  const auto shapes =
      has_file ? collision_shapes(session.robot, read_file(file), session.robot_file) : visual_shapes(session.robot);
  RobotSolids all;
  for (int link = 0; link < static_cast<int>(session.robot.links.size()); ++link) {
    const std::size_t before = all.solids.size();
    for (const Shape& shape : shapes[static_cast<std::size_t>(link)]) add_shape(shape, link, file.parent_path(), all);
    if (all.solids.size() == before) add_limbs(session.robot, link, all);
  }
  if (has_file) read_srdf(file, all);
  return all;
}

}  // namespace handsight
