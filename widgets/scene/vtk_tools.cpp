// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/vtk_tools.h"

#include <vtkConeSource.h>
#include <vtkLineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

namespace handsight::widgets {

vtkSmartPointer<vtkMatrix4x4> vtk_matrix(const Rigid& motion) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const Matrix4 m = matrix_from_rigid(motion);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, m(row, column));
  return matrix;
}

void set_color(vtkActor& actor, const QColor& color, double opacity) {
  vtkProperty* property = actor.GetProperty();
  property->SetColor(color.redF(), color.greenF(), color.blueF());
  property->SetOpacity(opacity);
}

vtkSmartPointer<vtkActor> make_actor(vtkPolyData* surface, const QColor& color, double opacity) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetAmbient(0.25);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.05);
  set_color(*actor, color, opacity);
  return actor;
}

vtkSmartPointer<vtkPolyData> rod(const Vector3& from, const Vector3& to, double radius) {
  vtkNew<vtkLineSource> line;
  line->SetPoint1(from.data());
  line->SetPoint2(to.data());
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(12);
  tube->CappingOn();
  tube->Update();
  return tube->GetOutput();
}

vtkSmartPointer<vtkPolyData> ball(const Vector3& center, double radius) {
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.x(), center.y(), center.z());
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(14);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> cone_tip(const Vector3& from, const Vector3& tip, double length, double radius) {
  const Vector3 along = (tip - from).normalized(), center = tip - along * length / 2;
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(center.x(), center.y(), center.z());
  cone->SetDirection(along.x(), along.y(), along.z());
  cone->SetHeight(length);
  cone->SetRadius(radius);
  cone->SetResolution(16);
  cone->Update();
  return cone->GetOutput();
}

}  // namespace handsight::widgets
