// SPDX-License-Identifier: GPL-3.0-or-later
// What the pointer is dragging in an ImageView. Internal to image_view*.cpp.
#pragma once

#include <QPointF>

#include "widgets/images/image_viewport.h"

namespace handsight::widgets {

struct ImageDrag {
  enum Kind { pan, marker } kind = pan;
  Qt::MouseButton button = Qt::LeftButton;
  QPointF from;
  ImageViewport viewport;
  int number = -1;
  QPointF grip;  // from the pointer to the mark, screen px
  bool has_moved = false;
};

}  // namespace handsight::widgets
