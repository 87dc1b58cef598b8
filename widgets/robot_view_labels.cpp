// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPainter>
#include <array>
#include <cmath>

#include "widgets/number_text.h"
#include "widgets/paint_tools.h"
#include "widgets/robot_view_parts.h"
#include "widgets/theme.h"

namespace handsight::widgets {

void RobotView::paint_labels(QPainter& painter) {
  static const std::array<QString, 3> letters = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  const Colors& c = colors();
  const Parts& p = *parts_;
  if (!p.has_robot()) {
    draw_sentence(painter, rect(), p.empty_text);
    return;
  }
  painter.setFont(text_font(TextRole::small));
  const auto plate = [&](const Vector3& in_root, const QString& text, const QPointF& offset) {
    if (const auto at = to_screen(in_root)) draw_plate(painter, *at + offset, text, c.ink1, c.panel);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const Vector3 tip = 1.12 * kAxisLength * Vector3::Unit(axis);
    if (p.tcp) plate(*p.tcp * tip, letters[i], QPointF(4, -7));
    if (p.tcp_est) plate(*p.tcp_est * tip, letters[i] + QStringLiteral("′"), QPointF(4, 9));
  }
  for (const SceneCamera& camera : p.cameras)
    plate(camera.root_from_camera.translation, camera.name,
          QPointF(8, camera.name == QStringLiteral("right") ? 10 : -10));
  for (const SceneMarker& marker : p.markers)
    if (marker.role == SceneMarkerRole::measured) plate(marker.in_root, QString::number(marker.marker), QPointF(9, -9));

  // The root's axes as a small triad.
  const QPointF origin(30, height() - 32.0);
  const Vector3 forward = p.orbit.direction(), right = forward.cross(Vector3::UnitZ()).normalized();
  const Vector3 up = right.cross(forward);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 unit = Vector3::Unit(axis);
    const QPointF tip = origin + 20 * QPointF(unit.dot(right), -unit.dot(up));
    painter.setPen(QPen(c.ink3, 1.5));
    painter.drawLine(origin, tip);
    painter.setPen(c.ink2);
    painter.drawText(QRectF(tip - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter,
                     letters[static_cast<std::size_t>(axis)]);
  }
  QStringList legend;
  if (p.tcp) legend += p.tcp_est ? QStringLiteral("x y z TCP, x′ y′ z′ TCPest") : QStringLiteral("x y z TCP");
  if (p.bent) legend += QStringLiteral("ghost %1 ×").arg(short_text(p.ghost_times, 3));
  if (!p.arrows.empty()) legend += QStringLiteral("arrows %1 ×").arg(short_text(p.arrow_times, 3));
  const QString text = legend.join(QStringLiteral("   "));
  const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text) + 6;
  if (!text.isEmpty())
    draw_plate(painter, QPointF(std::max(width() - wide - 6, 64.0), height() - 13.0), text, c.ink2, c.panel);
  if (hasFocus()) draw_focus(painter, rect());
}

}  // namespace handsight::widgets
