// SPDX-License-Identifier: GPL-3.0-or-later
// How the staircase is painted. Internal to staircase*.cpp.
#pragma once

#include "widgets/explain/log_axis.h"
#include "widgets/explain/staircase_state.h"

namespace handsight::widgets {

struct StaircaseScene {
  const StaircaseState* state = nullptr;
  QRectF area;
  LogAxis axis;
  std::vector<QRectF> slots_;  // of the versions and of one more
  int current = -1, hovered = -1;
  int falling = -1;   // a step that has just come, -1: none
  double fallen = 1;  // how far down it is, 0 to 1
};

void paint_staircase(QPainter& painter, const StaircaseScene& scene, int width);

}  // namespace handsight::widgets
