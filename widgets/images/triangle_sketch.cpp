// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/images/triangle_sketch.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {

TriangleSketch::TriangleSketch(QWidget* parent) : QWidget(parent) { setMinimumHeight(96); }

void TriangleSketch::set_state(const TriangleState& state) {
  state_ = state;
  update();
}

bool TriangleSketch::shows_known() const {
  const auto placed = std::count_if(state_.markers.begin(), state_.markers.end(),
                                    [](const TriangleMarker& m) { return m.in_left_camera.has_value(); });
  return state_.known.size() >= 3 && placed < 3;
}

const std::vector<TriangleMarker>& TriangleSketch::drawn() const {
  return shows_known() ? state_.known : state_.markers;
}

std::optional<QPointF> TriangleSketch::place(int number) const {
  // Seen along the camera's axis, at the mean depth: x right, y down.
  Vector2 low(1e300, 1e300), high(-1e300, -1e300);
  std::optional<Vector2> here;
  for (const TriangleMarker& marker : drawn()) {
    if (!marker.in_left_camera) continue;
    const Vector2 at = marker.in_left_camera->head<2>();
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
    if (marker.number == number) here = at;
  }
  if (!here) return std::nullopt;
  const QRectF room = QRectF(rect()).adjusted(40, 32, -40, -16);  // below the line that stands above it
  const Vector2 size = (high - low).cwiseMax(1e-6);
  const double scale = std::min(room.width() / size.x(), room.height() / size.y());
  const Vector2 from_middle = (*here - (low + high) / 2) * scale;
  return room.center() + QPointF(from_middle.x(), from_middle.y());
}

void TriangleSketch::paint_known(QPainter& painter) const {
  const Colors& c = colors();
  painter.setFont(number_font(TextRole::small));
  painter.setPen(QPen(c.ink3, 1, Qt::DashLine));
  for (std::size_t a = 0; a < state_.known.size(); ++a)
    for (std::size_t b = a + 1; b < state_.known.size(); ++b) {
      const auto from = place(state_.known[a].number), to = place(state_.known[b].number);
      if (from && to) painter.drawLine(*from, *to);
    }
  for (const TriangleMarker& marker : state_.known) {
    const auto at = place(marker.number);
    if (!at) continue;
    painter.setPen(QPen(c.ink3, 1));
    painter.setBrush(c.sunken);
    painter.drawEllipse(*at, 9, 9);
    painter.setPen(c.ink2);
    painter.drawText(QRectF(*at - QPointF(9, 9), QSizeF(18, 18)), Qt::AlignCenter, QString::number(marker.number));
  }
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink2);
  draw_text(painter, QRectF(rect()).adjusted(8, 4, -8, 0), Qt::AlignLeft | Qt::AlignTop,
            tr("As the other observations number them"));
}

void TriangleSketch::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.sunken);
  if (shows_known()) return paint_known(painter);
  const bool is_empty = std::none_of(state_.markers.begin(), state_.markers.end(),
                                     [](const TriangleMarker& m) { return m.in_left_camera.has_value(); });
  if (is_empty) {
    draw_sentence(painter, rect(), QObject::tr("The triangle appears here."));
    return;
  }
  painter.setFont(number_font(TextRole::small));
  for (const TriangleSide& side : state_.sides) {
    const auto from = place(side.from), to = place(side.to);
    if (!from || !to) continue;
    painter.setPen(QPen(c.ink2, 1.5));
    painter.drawLine(*from, *to);
    const QString text = fixed_text(side.length_mm, 1);
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text);
    draw_plate(painter, (*from + *to) / 2 - QPointF(wide / 2 + 3, 0), text, c.ink1, c.sunken);
  }
  for (const TriangleMarker& marker : state_.markers) {
    const auto at = place(marker.number);
    if (!at) continue;
    painter.setPen(QPen(marker.number == state_.selected_marker ? c.accent : c.ink1, 2));
    painter.setBrush(c.panel);
    painter.drawEllipse(*at, 9, 9);
    painter.setPen(c.ink1);
    painter.drawText(QRectF(*at - QPointF(9, 9), QSizeF(18, 18)), Qt::AlignCenter, QString::number(marker.number));
  }
}

void TriangleSketch::mousePressEvent(QMouseEvent* event) {
  if (shows_known()) return;
  for (const TriangleMarker& marker : state_.markers) {
    const auto at = place(marker.number);
    if (!at) continue;
    const QPointF d = *at - event->position();
    if (std::hypot(d.x(), d.y()) < 14) return emit marker_selected(marker.number);
  }
}

}  // namespace handsight::widgets
