// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown beside the robot: axes, camera cones, markers, arrows, ellipsoid, floor.
#pragma once

#include <vtkRenderer.h>

#include <vector>

#include "widgets/scene/scene_marks.h"
#include "widgets/scene/vtk_tools.h"

namespace handsight::widgets {

/// Actors that come and go together.
struct ActorGroup {
  std::vector<vtkSmartPointer<vtkActor>> actors;
  void clear(vtkRenderer& renderer);
  void add(vtkRenderer& renderer, const vtkSmartPointer<vtkActor>& actor);
};

inline constexpr double axis_length = 0.12;  // m

void show_axes(vtkRenderer& renderer, ActorGroup& group, const Rigid& root_from_frame, bool is_estimate);
void show_camera(vtkRenderer& renderer, ActorGroup& group, const SceneCamera& camera);
void show_markers(vtkRenderer& renderer, ActorGroup& group, const std::vector<SceneMarker>& markers);
/// One glyph mapper for all arrows, coloured by the residual scale.
/// `metres_per_px` where they stand: none is so thin that it is lost.
void show_arrows(vtkRenderer& renderer, ActorGroup& group, const std::vector<SceneArrow>& arrows, double times,
                 double metres_per_px);
/// One arrow alone in a colour of its own, thicker.
void show_arrow(vtkRenderer& renderer, ActorGroup& group, const SceneArrow& arrow, double times, double metres_per_px,
                const QColor& color);
void show_ellipsoid(vtkRenderer& renderer, ActorGroup& group, const SceneEllipsoid& ellipsoid);
/// A line along the way and a ball at its end.
void show_path(vtkRenderer& renderer, ActorGroup& group, const ScenePath& path);
/// A faint grid of 0.5 m on the plane z = height.
void show_floor(vtkRenderer& renderer, ActorGroup& group, double height);

}  // namespace handsight::widgets
