// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/view_cube.h"

#include "widgets/base/theme.h"

namespace handsight::widgets {

std::vector<CubeFace> cube_faces(const Orbit& orbit, const QPointF& center, double size) {
  struct Side {
    StandardView view;
    const char* letter;
    Vector3 normal;
  };
  static const Side sides[] = {{StandardView::front, "F", Vector3::UnitX()},
                               {StandardView::back, "B", -Vector3::UnitX()},
                               {StandardView::left, "L", Vector3::UnitY()},
                               {StandardView::right, "R", -Vector3::UnitY()},
                               {StandardView::top, "T", Vector3::UnitZ()}};
  const Vector3 forward = orbit.direction(), right = forward.cross(Vector3::UnitZ()).normalized();
  const Vector3 up = right.cross(forward);
  const auto on_screen = [&](const Vector3& v) { return center + 0.5 * size * QPointF(v.dot(right), -v.dot(up)); };
  std::vector<CubeFace> faces;
  for (const Side& side : sides) {
    const double towards = -side.normal.dot(forward);
    if (towards < 0.05) continue;
    const Vector3 a = std::abs(side.normal.z()) > 0.5 ? Vector3(Vector3::UnitX()) : Vector3(Vector3::UnitZ());
    const Vector3 b = side.normal.cross(a);
    QPolygonF outline;
    for (const auto& [u, v] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      outline << on_screen(Vector3(side.normal + u * a + v * b));
    faces.push_back({side.view, QString::fromLatin1(side.letter), outline, towards});
  }
  return faces;
}

void paint_cube(QPainter& painter, const std::vector<CubeFace>& faces) {
  const Colors& c = colors();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(text_font(TextRole::small));
  for (const CubeFace& face : faces) {
    painter.setPen(QPen(c.control_edge, 1));
    painter.setBrush(face.view == StandardView::top ? c.panel : face.towards > 0.6 ? c.sunken : c.hairline);
    painter.drawPolygon(face.outline);
    constexpr double readable = 0.45;
    if (face.towards < readable) continue;
    painter.setPen(c.ink2);
    const QPointF middle = face.outline.boundingRect().center();
    painter.drawText(QRectF(middle - QPointF(9, 9), QSizeF(18, 18)), Qt::AlignCenter, face.letter);
  }
}

std::optional<StandardView> face_at(const std::vector<CubeFace>& faces, const QPointF& position) {
  for (const CubeFace& face : faces)
    if (face.outline.containsPoint(position, Qt::OddEvenFill)) return face.view;
  return std::nullopt;
}

}  // namespace handsight::widgets
