// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect/snap.h"

#include "images/image_source.h"
#include "vision/corners/corner_detector.h"

namespace handsight::app {

std::optional<Vector2> snapped(const QImage& image, const Vector2& px) {
  constexpr int reach = 32;
  constexpr double farthest = 12;
  if (image.isNull()) return std::nullopt;
  const QRect part =
      QRect(static_cast<int>(px.x()) - reach, static_cast<int>(px.y()) - reach, 2 * reach + 1, 2 * reach + 1)
          .intersected(image.rect());
  if (part.isEmpty()) return std::nullopt;
  const Vector2 offset(part.left(), part.top());
  std::optional<Vector2> best;
  for (const Corner& c : detect_corners(grey_image(image.copy(part)))) {
    const Vector2 at = c.position + offset;
    if ((at - px).norm() <= farthest && (!best || (at - px).norm() < (*best - px).norm())) best = at;
  }
  return best;
}

}  // namespace handsight::app
