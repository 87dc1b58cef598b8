// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/ghost.h"

#include <vtkCleanPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTriangleFilter.h>

namespace handsight::widgets {
namespace {

constexpr double no_opacity = 1e-3;  // less than a grey level
constexpr double outline_px = 2;

/// Triangles that share their corners: sources and files repeat them where normals differ, and an edge that no two
/// triangles share is none of a silhouette.
vtkSmartPointer<vtkPolyData> closed(vtkPolyData* surface) {
  vtkNew<vtkPolyData> places;  // without normals, by which equal places would be kept apart
  places->SetPoints(surface->GetPoints());
  places->SetPolys(surface->GetPolys());
  places->SetStrips(surface->GetStrips());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(places);
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputConnection(triangles->GetOutputPort());
  joined->SetTolerance(1e-6);
  joined->ConvertPolysToLinesOff();
  joined->Update();
  return joined->GetOutput();
}

vtkSmartPointer<vtkActor> depth_actor(vtkPolyData* surface) {
  auto actor = make_actor(surface, {}, no_opacity);
  actor->ForceOpaqueOn();  // what is translucent leaves no depth
  actor->PickableOff();
  auto* mapper = actor->GetMapper();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();  // its outline lies in front of it
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 2);
  return actor;
}

vtkSmartPointer<vtkActor> outline_actor(vtkPolyDataSilhouette& silhouette) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(silhouette.GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->GetProperty()->LightingOff();
  silhouette.SetProp3D(actor);
  return actor;
}

}  // namespace

Ghost make_ghost(const RobotActors& robot, vtkRenderer& renderer) {
  Ghost ghost;
  for (const LinkActor& part : robot.parts) {
    auto* surface = vtkPolyDataMapper::SafeDownCast(part.actor->GetMapper())->GetInput();
    ghost.surface.parts.push_back({part.link, part.link_from_shape, {}, depth_actor(surface)});
    const auto silhouette = vtkSmartPointer<vtkPolyDataSilhouette>::New();
    silhouette->SetInputData(closed(surface));
    silhouette->SetCamera(renderer.GetActiveCamera());
    silhouette->SetEnableFeatureAngle(0);
    ghost.outline.parts.push_back({part.link, part.link_from_shape, {}, outline_actor(*silhouette)});
    ghost.silhouettes.push_back(silhouette);
  }
  for (std::size_t part = 0; part < ghost.outline.parts.size(); ++part) set_visible(ghost, part, false);
  return ghost;
}

void set_color(const Ghost& ghost, const QColor& color) {
  for (const LinkActor& part : ghost.outline.parts) set_color(*part.actor, color);
}

void set_line_width(const Ghost& ghost, double scale) {
  for (const LinkActor& part : ghost.outline.parts)
    part.actor->GetProperty()->SetLineWidth(static_cast<float>(outline_px * scale));
}

void place(const Ghost& ghost, const std::vector<Rigid>& root_from_link) {
  for (const RobotActors* actors : {&ghost.surface, &ghost.outline}) place_links(*actors, root_from_link);
  for (const auto& silhouette : ghost.silhouettes) silhouette->Modified();  // it does not see that its actor moved
}

void set_visible(const Ghost& ghost, std::size_t part, bool visible) {
  for (const RobotActors* actors : {&ghost.surface, &ghost.outline}) actors->parts[part].actor->SetVisibility(visible);
}

void add_to(vtkRenderer& renderer, const Ghost& ghost) {  // drawn in this order
  for (const RobotActors* actors : {&ghost.surface, &ghost.outline}) add_to(renderer, *actors);
}

void remove_from(vtkRenderer& renderer, const Ghost& ghost) {
  for (const RobotActors* actors : {&ghost.surface, &ghost.outline}) remove_from(renderer, *actors);
}

}  // namespace handsight::widgets
