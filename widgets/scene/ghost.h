// SPDX-License-Identifier: GPL-3.0-or-later
// The robot where the model bends it to, as an outline: what is behind it stays in sight.
#pragma once

#include <vtkPolyDataSilhouette.h>
#include <vtkRenderer.h>

#include "widgets/scene/robot_actors.h"

namespace handsight::widgets {

/// Part i of each is of the same surface. The surfaces leave nothing but their depth, which hides the outlines of parts
/// behind them.
struct Ghost {
  RobotActors surface, outline;
  std::vector<vtkSmartPointer<vtkPolyDataSilhouette>> silhouettes;  // of outline.parts
};

/// Of the surfaces of a robot, for the eye of this renderer; all invisible.
Ghost make_ghost(const RobotActors& robot, vtkRenderer& renderer);
void set_color(const Ghost& ghost, const QColor& color);
/// `scale`: device px for each px of the screen.
void set_line_width(const Ghost& ghost, double scale);
/// One motion per link of the robot.
void place(const Ghost& ghost, const std::vector<Rigid>& root_from_link);
void set_visible(const Ghost& ghost, std::size_t part, bool visible);

void add_to(vtkRenderer& renderer, const Ghost& ghost);
void remove_from(vtkRenderer& renderer, const Ghost& ghost);

}  // namespace handsight::widgets
