// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <optional>

#include "geometry/rigid.h"

namespace handsight::app {

/// The X-corner nearest to a place (px) within 12 px, looked for round it alone; nothing where there is none.
std::optional<Vector2> snapped(const QImage& image, const Vector2& px);

}  // namespace handsight::app
