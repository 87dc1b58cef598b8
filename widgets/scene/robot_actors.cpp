// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/robot_actors.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <QObject>
#include <algorithm>
#include <optional>

#include "base/error.h"
#include "base/text.h"
#include "robot/mesh.h"

namespace handsight::widgets {
namespace {

namespace fs = std::filesystem;

const QColor plain_chi2(0xB4, 0xB9, 0xBF);

vtkSmartPointer<vtkPolyData> surface_of(const Mesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), mesh.points[i].x(), mesh.points[i].y(), mesh.points[i].z());
  vtkNew<vtkCellArray> triangles;
  for (const auto& triangle : mesh.triangles) {
    const vtkIdType corners[3] = {triangle[0], triangle[1], triangle[2]};
    triangles->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->ConsistencyOff();  // as the file says
  normals->Update();
  return normals->GetOutput();
}

ReadMesh read_one(const std::string& written, const fs::path& folder) {
  const auto file = find_mesh(written, folder);
  if (!file)
    return {{},
            QObject::tr("The mesh %1 is not in the robot's folder. The link is drawn without it.")
                .arg(QString::fromStdString(shortened(written, 100)))};
  try {
    return {read_mesh(*file), {}};
  } catch (const std::exception& error) {
    return {{}, QObject::tr("A mesh cannot be shown. %1").arg(QString::fromStdString(error.what()))};
  }
}

/// Nothing where it was not read, and a sentence in the notes where it cannot be shown.
vtkSmartPointer<vtkPolyData> mesh_surface(const std::string& written, const ReadMeshes& meshes,
                                          std::vector<QString>& notes) {
  const auto found = meshes.find(written);
  if (found == meshes.end()) return nullptr;
  if (found->second.refusal.isEmpty()) return surface_of(found->second.mesh);
  notes.push_back(found->second.refusal);
  return nullptr;
}

vtkSmartPointer<vtkPolyData> transformed(vtkAlgorithm& source, vtkTransform& transform) {
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputConnection(source.GetOutputPort());
  filter->SetTransform(&transform);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> shape_surface(const Shape& shape, const ReadMeshes& meshes, std::vector<QString>& notes) {
  vtkNew<vtkTransform> transform;
  switch (shape.kind) {
    case ShapeKind::box: {
      vtkNew<vtkCubeSource> cube;
      cube->SetXLength(shape.size.x());
      cube->SetYLength(shape.size.y());
      cube->SetZLength(shape.size.z());
      cube->Update();
      return cube->GetOutput();
    }
    case ShapeKind::cylinder: {
      vtkNew<vtkCylinderSource> cylinder;
      cylinder->SetRadius(shape.size.x());
      cylinder->SetHeight(shape.size.y());
      cylinder->SetResolution(28);
      transform->RotateX(90);  // VTK's cylinder stands along y
      return transformed(*cylinder, *transform);
    }
    case ShapeKind::sphere:
      return ball(Vector3::Zero(), shape.size.x());
    case ShapeKind::mesh:
      break;
  }
  const auto mesh = mesh_surface(shape.mesh_file, meshes, notes);
  if (!mesh) return nullptr;
  transform->Scale(shape.size.x(), shape.size.y(), shape.size.z());
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(mesh);
  filter->SetTransform(transform);
  filter->Update();
  return filter->GetOutput();
}

/// What the shapes of a link cover, in its own frame.
struct Covered {
  Vector3 low = Vector3::Constant(1e300), high = Vector3::Constant(-1e300);

  bool is_nothing() const { return low.x() > high.x(); }
  void add(vtkPolyData& surface, const Rigid& link_from_shape) {
    double bounds[6];
    surface.GetBounds(bounds);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 at =
          link_from_shape * Vector3(bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)]);
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  }
  bool holds(const Vector3& place) const {
    const Vector3 slack = 0.15 * (high - low) + Vector3::Constant(0.01);
    return ((place - low + slack).minCoeff() >= 0) && ((high + slack - place).minCoeff() >= 0);
  }
  double radius() const { return 0.5 * (high - low).minCoeff(); }
};

/// Limbs from a link's origin to the joints that it carries and that its shapes do not reach: capsules, round at both
/// ends.
vtkSmartPointer<vtkPolyData> limbs(const Robot& robot, int link, const Covered& covered) {
  vtkNew<vtkAppendPolyData> all;
  bool has_any = false;
  for (const Joint& joint : robot.joints) {
    if (joint.parent_link != link) continue;
    const Vector3 end = (joint.parent_from_joint * joint.joint_from_child).translation;
    const double length = end.norm();
    if (length < 0.01 || (!covered.is_nothing() && covered.holds(end))) continue;
    const double wanted = covered.is_nothing() ? 0.15 * length : 0.6 * covered.radius();
    const double radius = std::clamp(wanted, 0.012, 0.06);
    all->AddInputData(rod(Vector3::Zero(), end, radius));
    all->AddInputData(ball(Vector3::Zero(), radius));
    all->AddInputData(ball(end, radius));
    has_any = true;
  }
  if (!has_any) return nullptr;
  all->Update();
  return all->GetOutput();
}

}  // namespace

bool has_meshes(const Robot& robot) {
  for (const Link& link : robot.links)
    for (const Shape& shape : link.shapes)
      if (shape.kind == ShapeKind::mesh) return true;
  return false;
}

ReadMeshes read_meshes(const Robot& robot, const fs::path& mesh_folder) {
  ReadMeshes meshes;
  for (const Link& link : robot.links)
    for (const Shape& shape : link.shapes)
      if (shape.kind == ShapeKind::mesh && !meshes.contains(shape.mesh_file))
        meshes.emplace(shape.mesh_file, read_one(shape.mesh_file, mesh_folder));
  return meshes;
}

RobotActors make_robot_actors(const Robot& robot, const ReadMeshes& meshes) {
  RobotActors actors;
  for (int link = 0; link < static_cast<int>(robot.links.size()); ++link) {
    Covered covered;
    QColor last = plain_chi2;
    for (const Shape& shape : robot.links[static_cast<std::size_t>(link)].shapes) {
      const auto surface = shape_surface(shape, meshes, actors.notes);
      if (!surface) continue;
      const QColor color = shape.color ? QColor::fromRgbF(static_cast<float>(std::clamp((*shape.color)[0], 0.0, 1.0)),
                                                          static_cast<float>(std::clamp((*shape.color)[1], 0.0, 1.0)),
                                                          static_cast<float>(std::clamp((*shape.color)[2], 0.0, 1.0)))
                                       : plain_chi2;
      actors.parts.push_back({link, shape.link_from_shape, color, make_actor(surface, color)});
      covered.add(*surface, shape.link_from_shape);
      last = color;
    }
    if (const auto surface = limbs(robot, link, covered))
      actors.parts.push_back({link, Rigid{}, last, make_actor(surface, last)});
  }
  return actors;
}

RobotActors make_shadow_actors(const RobotActors& robot, const QColor& color) {
  RobotActors shadow;
  for (const LinkActor& part : robot.parts) {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(part.actor->GetMapper());
    shadow.parts.push_back({part.link, part.link_from_shape, color, make_actor(mapper->GetInput(), color)});
    shadow.parts.back().actor->PickableOff();
    shadow.parts.back().actor->GetProperty()->LightingOff();
  }
  return shadow;
}

void place_shadow(const RobotActors& shadow, const std::vector<Rigid>& root_from_link, double height) {
  constexpr double slant_x = 0.2, slant_y = 0.12;  // of the light
  constexpr double below = 0.003;                  // m: under the floor's lines
  for (const LinkActor& part : shadow.parts) {
    if (static_cast<std::size_t>(part.link) >= root_from_link.size()) continue;
    vtkNew<vtkMatrix4x4> flat;
    flat->SetElement(0, 2, -slant_x);
    flat->SetElement(0, 3, slant_x * height);
    flat->SetElement(1, 2, -slant_y);
    flat->SetElement(1, 3, slant_y * height);
    flat->SetElement(2, 2, 0);
    flat->SetElement(2, 3, height - below);
    vtkNew<vtkMatrix4x4> placed;
    const auto link = vtk_matrix(root_from_link[static_cast<std::size_t>(part.link)] * part.link_from_shape);
    vtkMatrix4x4::Multiply4x4(flat, link, placed);
    part.actor->SetUserMatrix(placed);
  }
}

void add_to(vtkRenderer& renderer, const RobotActors& actors) {
  for (const LinkActor& part : actors.parts) renderer.AddActor(part.actor);
}

void remove_from(vtkRenderer& renderer, const RobotActors& actors) {
  for (const LinkActor& part : actors.parts) renderer.RemoveActor(part.actor);
}

void set_visible(const RobotActors& actors, bool visible) {
  for (const LinkActor& part : actors.parts) part.actor->SetVisibility(visible);
}

void place_links(const RobotActors& actors, const std::vector<Rigid>& root_from_link) {
  for (const LinkActor& part : actors.parts) {
    if (static_cast<std::size_t>(part.link) >= root_from_link.size()) continue;
    part.actor->SetUserMatrix(vtk_matrix(root_from_link[static_cast<std::size_t>(part.link)] * part.link_from_shape));
  }
}

std::vector<Rigid> magnified(const std::vector<Rigid>& posture, const std::vector<Rigid>& bent, double times) {
  std::vector<Rigid> result;
  for (std::size_t i = 0; i < std::min(posture.size(), bent.size()); ++i) {
    const Vector3 turn = vector_from_rotation(bent[i].rotation * posture[i].rotation.transpose());
    result.push_back({rotation_from_vector<double>(times * turn) * posture[i].rotation,
                      posture[i].translation + times * (bent[i].translation - posture[i].translation)});
  }
  return result;
}

}  // namespace handsight::widgets
