// SPDX-License-Identifier: GPL-3.0-or-later
// The part of an image that a view shows.
#pragma once

#include "geometry/rigid.h"

namespace handsight::widgets {

/// The image point at the view's centre and screen px per image px.
struct ImageViewport {
  Vector2 center{0, 0};
  double zoom = 1;
};

}  // namespace handsight::widgets
