// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/session_mark.h"

#include <QPainter>
#include <array>
#include <cmath>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

/// A polygon whose corners lie on circles, from the top on.
QPainterPath corners(int count, double outer, double inner, double turn = 0) {
  QPolygonF polygon;
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 2 * M_PI * i / count, radius = i % 2 == 0 ? outer : inner;
    polygon << QPointF(radius * std::sin(angle), -radius * std::cos(angle));
  }
  QPainterPath path;
  path.addPolygon(polygon);
  path.closeSubpath();
  return path;
}

QPainterPath cross() {
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  path.addRect(-3.2, -1.1, 6.4, 2.2);
  path.addRect(-1.1, -3.2, 2.2, 6.4);
  return path.simplified();
}

}  // namespace

QPainterPath session_mark_path(int number) {
  QPainterPath disc;
  disc.addEllipse(QPointF(0, 0), 2.8, 2.8);
  switch (number % session_mark_count) {
    case 0:
      return disc;
    case 1:
      return corners(3, 3.6, 3.6);
    case 2:
      return corners(4, 3.6, 3.6, M_PI / 4);
    case 3:
      return corners(4, 3.7, 3.7);
    case 4:
      return cross();
    case 5:
      return corners(3, 3.6, 3.6, M_PI);
    case 6:
      return corners(10, 3.8, 1.6);
    default:
      return corners(6, 3.4, 3.4);
  }
}

QColor session_mark_color(int number) {
  static const std::array<const char*, session_mark_count> light{"#3A2F9B", "#12806B", "#A03A95", "#6E6A12",
                                                                 "#3C7FA8", "#1F5F2A", "#7A4A8C", "#454D57"};
  static const std::array<const char*, session_mark_count> dark{"#A79BFF", "#45CDB4", "#E58AD8", "#CFCB62",
                                                                "#8CCBEE", "#7ED08C", "#C9A3DC", "#B9C2CC"};
  const bool is_dark = colors().window.lightness() < 128;
  return {(is_dark ? dark : light)[static_cast<std::size_t>(number % session_mark_count)]};
}

void draw_session_mark(QPainter& painter, const QPointF& centre, double size, int number) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(centre);
  painter.scale(size / 6, size / 6);
  painter.fillPath(session_mark_path(number), session_mark_color(number));
  painter.restore();
}

QPixmap session_mark_picture(int number, int size, double pixel_ratio) {
  QPixmap picture(QSize(size, size) * pixel_ratio);
  picture.setDevicePixelRatio(pixel_ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  draw_session_mark(painter, QPointF(size / 2.0, size / 2.0), size * 0.75, number);
  return picture;
}

}  // namespace handsight::widgets
