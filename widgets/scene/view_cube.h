// SPDX-License-Identifier: GPL-3.0-or-later
// A small cube that shows from where one looks at the robot; a click on a face looks from there.
#pragma once

#include <QPainter>
#include <optional>
#include <vector>

#include "widgets/scene/orbit.h"
#include "widgets/scene/standard_view.h"

namespace handsight::widgets {

struct CubeFace {
  StandardView view;
  QString letter;  // F B L R T: front, back, left, right, top
  QPolygonF outline;
  double towards = 0;  // 0 to 1: how squarely it faces the eye
};

/// The faces that can be seen, of a cube `size` px wide round a place on the screen.
std::vector<CubeFace> cube_faces(const Orbit& orbit, const QPointF& center, double size);

void paint_cube(QPainter& painter, const std::vector<CubeFace>& faces);

/// The view of the face under a position.
std::optional<StandardView> face_at(const std::vector<CubeFace>& faces, const QPointF& position);

}  // namespace handsight::widgets
