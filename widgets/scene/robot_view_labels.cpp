// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/scene/robot_view.h"
#include "widgets/scene/robot_view_parts.h"

namespace handsight::widgets {
namespace {

QRectF plate_rect(const QPointF& position, const QSizeF& size) {
  return {QPointF(position.x(), position.y() - size.height() / 2), size};
}

/// The place nearest to the wanted one at which a plate of this size lies within the view and over nothing else; the
/// wanted one where there is none near.
QPointF free_place(const QPointF& wanted, const QSizeF& size, const std::vector<QRectF>& taken, const QRectF& view) {
  for (const double radius : {0.0, 14.0, 24.0, 36.0, 50.0})
    for (int step = 0; step < (radius > 0 ? 12 : 1); ++step) {
      const double angle = 0.5236 * step;
      const QPointF place = wanted + radius * QPointF(std::cos(angle), std::sin(angle));
      const QRectF plate = plate_rect(place, size).adjusted(-1, -1, 1, 1);
      if (!view.contains(plate)) continue;
      if (std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(plate); }))
        return place;
    }
  return wanted;
}

/// How much of what was drawn a plate would lie over, 0 to 1; `picture` has `ratio` px for each of the widget's.
double covered_share(const QImage& picture, double ratio, const QRectF& plate) {
  constexpr int step = 3, faint = 40;  // px; the floor's lines may be crossed
  const QColor ground = colors().panel;
  int covered = 0, all = 0;
  for (int row = 0; row <= static_cast<int>(plate.height()) / step; ++row)
    for (int column = 0; column <= static_cast<int>(plate.width()) / step; ++column) {
      const QPoint at(static_cast<int>((plate.left() + step * column) * ratio),
                      static_cast<int>((plate.top() + step * row) * ratio));
      if (!picture.valid(at)) continue;
      const QColor c = picture.pixelColor(at);
      ++all;
      if (std::abs(c.red() - ground.red()) + std::abs(c.green() - ground.green()) + std::abs(c.blue() - ground.blue()) >
          3 * faint)
        ++covered;
    }
  return all > 0 ? static_cast<double>(covered) / all : 1;
}

/// The nearest place about `at` on free ground within `room`, over no other plate; where there is none the one that
/// hides least.
QPointF place_on_ground(const QPointF& at, const QSizeF& size, const std::vector<QRectF>& taken, const QRectF& room,
                        const std::function<double(const QRectF&)>& hidden) {
  constexpr double little = 0.05;
  QPointF best = at;
  double least = 1e300;
  for (int radius = 12; radius <= 132; radius += 12)
    for (int step = 0; step < 16; ++step) {
      const double angle = M_PI / 8 * step;
      const QPointF middle = at + radius * QPointF(std::cos(angle), std::sin(angle));
      const QPointF place(middle.x() - (std::cos(angle) < -0.3  ? size.width()
                                        : std::cos(angle) > 0.3 ? 0
                                                                : size.width() / 2),
                          middle.y());
      const QRectF plate = plate_rect(place, size).adjusted(-2, -2, 2, 2);
      if (!room.contains(plate)) continue;
      if (std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(plate); }))
        continue;
      const double share = hidden(plate);
      if (share < little) return place;
      if (share < least) {
        least = share;
        best = place;
      }
    }
  return best;
}

/// The longest of a frame's axes as it is seen, px.
double length_on_screen(const RobotView& view, const Rigid& root_from_frame) {
  const auto origin = view.to_screen(root_from_frame.translation);
  double longest = 0;
  for (int axis = 0; origin && axis < 3; ++axis)
    if (const auto tip = view.to_screen(root_from_frame * Vector3(axis_length * Vector3::Unit(axis))))
      longest = std::max(longest, std::hypot(tip->x() - origin->x(), tip->y() - origin->y()));
  return longest;
}

struct LegendLine {
  QPointF place;
  QString text;
};

/// What is drawn how large: in the lower right corner, right of the triad; where there is too little room for one line,
/// a line each.
std::vector<LegendLine> legend_lines(const RobotViewParts& p, const QSizeF& view, double least_left,
                                     const QFontMetricsF& metrics) {
  QStringList legend;
  if (p.tcp) legend += p.tcp_est ? QObject::tr("x y z TCP, x′ y′ z′ TCPest") : QObject::tr("x y z TCP");
  if (p.bent) legend += QObject::tr("ghost %1 ×").arg(times_text(p.ghost_times));
  if (!p.arrows.empty()) legend += QObject::tr("arrows %1 ×").arg(times_text(p.arrow_times));
  const QString together = legend.join(QStringLiteral("   "));
  if (metrics.horizontalAdvance(together) + 12 + least_left <= view.width() && !together.isEmpty()) legend = {together};
  std::vector<LegendLine> lines;
  double low = view.height() - 13.0;
  for (auto line = legend.rbegin(); line != legend.rend(); ++line, low -= 18)
    lines.push_back({QPointF(std::max(view.width() - metrics.horizontalAdvance(*line) - 12, least_left), low), *line});
  return lines;
}

}  // namespace

void RobotView::paint_labels(QPainter& painter) {
  static const std::array<QString, 3> letters = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  const Colors& c = colors();
  const RobotViewParts& p = *parts_;
  if (!p.has_robot()) {
    draw_sentence(painter, rect(), p.empty_text);
    return;
  }
  painter.setFont(text_font(TextRole::small));
  const auto measure_size = [&](const QString& text) { return plate_size(painter, text); };
  const std::vector<CubeFace> cube = p.cube(size());
  const double least_left = cube.empty() ? 64 : 122;
  const std::vector<LegendLine> legend = legend_lines(p, size(), least_left, QFontMetricsF(painter.font()));
  // Nothing that is named where it is may lie under what has its fixed place.
  std::vector<QRectF> taken{QRectF(0, height() - 64.0, least_left, 64)};
  if (!p.buttons->isHidden()) taken.emplace_back(p.buttons->geometry());
  for (const LegendLine& line : legend) taken.push_back(plate_rect(line.place, measure_size(line.text)));
  const auto put = [&](const QPointF& at, const QPointF& place, const QString& text, bool is_aside) {
    if (is_aside) {  // a line to what it names
      painter.setPen(QPen(c.ink3, 1));
      painter.drawLine(at, plate_rect(place, measure_size(text)).center());
    }
    taken.push_back(draw_plate(painter, place, text, c.ink1, c.panel));
  };
  const auto plate = [&](const Vector3& in_root, const QString& text, const QPointF& offset) {
    const auto at = to_screen(in_root);
    if (!at) return;
    const QPointF place = free_place(*at + offset, measure_size(text), taken, rect());
    put(*at, place, text, place != *at + offset);
  };
  const bool is_near = p.tcp && length_on_screen(*this, *p.tcp) > 34;  // from afar letters would hide what they name
  for (int axis = 0; is_near && axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const Vector3 tip = 1.12 * axis_length * Vector3::Unit(axis);
    plate(*p.tcp * tip, letters[i], QPointF(4, -7));
    if (p.tcp_est) plate(*p.tcp_est * tip, letters[i] + QStringLiteral("′"), QPointF(4, 9));
  }
  const double ratio = width() > 0 ? p.picture.width() / static_cast<double>(width()) : 1;
  constexpr double above = 30, below = 70;  // px: the buttons, the triad and the legend
  const QRectF room(2, above, width() - 4.0, height() - above - below);
  for (const SceneFixture& fixture : p.fixtures)
    if (const auto at = to_screen(find_middle(fixture));
        at && !fixture.name.isEmpty() && rect().contains(at->toPoint()))
      plate(find_middle(fixture), fixture.name, QPointF(8, -10));
  for (const SceneCamera& camera : p.cameras)
    if (const auto at = to_screen(camera.root_from_camera.translation);
        at && !camera.name.isEmpty() && rect().contains(at->toPoint()))
      put(*at,
          place_on_ground(*at, measure_size(camera.name), taken, room,
                          [&](const QRectF& area) { return covered_share(p.picture, ratio, area); }),
          camera.name, true);
  for (const SceneHand& hand : p.other_hands) plate(hand.root_from_tcp.translation, hand.name, QPointF(10, 12));
  for (const SceneMarker& marker : p.markers)
    if (is_near && marker.role == SceneMarkerRole::measured)
      plate(marker.in_root, QString::number(marker.marker), QPointF(9, -9));

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
  paint_cube(painter, cube);
  for (const LegendLine& line : legend) draw_plate(painter, line.place, line.text, c.ink2, c.panel);
  if (hasFocus()) draw_focus(painter, rect());
}

}  // namespace handsight::widgets
