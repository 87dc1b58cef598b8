// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/images/image_view.h"
#include "widgets/images/image_view_drag.h"
#include "widgets/images/loupe.h"

namespace handsight::widgets {
namespace {

constexpr double shortest_named_axis = 32;  // screen px

QPainterPath cross_path(const QPointF& at, double inner, double outer) {
  QPainterPath path;
  for (const QPointF& d : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    path.moveTo(at + inner * d);
    path.lineTo(at + outer * d);
  }
  return path;
}

QPainterPath arrow_path(const QPointF& from, const QPointF& to) {
  QPainterPath path(from);
  path.lineTo(to);
  const QPointF d = to - from;
  const double length = std::hypot(d.x(), d.y());
  if (length < 1) return path;
  const double head = std::min(7.0, length / 2);
  const QPointF back = -d / length * head, side(-d.y() / length * head * 0.5, d.x() / length * head * 0.5);
  path.moveTo(to + back + side);
  path.lineTo(to);
  path.lineTo(to + back - side);
  return path;
}

/// From a ring's rim to its number.
QPainterPath leader(const QPointF& from, const QPointF& to) {
  QLineF line(from, to);
  QPainterPath path(line.pointAt(8 / line.length()));
  path.lineTo(to);
  return path;
}

/// So many marks are a board's: numbers on all of them would bury it.
constexpr std::size_t most_with_leaders = 8;

/// A plate of this size beside a mark that lies over none of `placed`; of many marks only the four nearest places are
/// tried.
std::optional<QRectF> free_plate(const QPointF& at, const QSizeF& size, const std::vector<QRectF>& placed,
                                 bool are_many) {
  const double right = 13 + size.width() / 2, high = 11, far = 34;
  const QPointF places[] = {{right, -high}, {right, high}, {-right, -high}, {-right, high},
                            {0, -22},       {0, 22},       {far, -far},     {far, far},
                            {-far, -far},   {-far, far},   {1.3 * far, 0},  {-1.3 * far, 0}};
  for (const QPointF& place : std::span(places).first(are_many ? 4 : std::size(places))) {
    QRectF plate({}, size);
    plate.moveCenter(at + place);
    if (std::none_of(placed.begin(), placed.end(), [&](const QRectF& p) { return p.intersects(plate); })) return plate;
  }
  return std::nullopt;
}

}  // namespace

void ImageView::paint_image(QPainter& painter) const {
  const QPointF corner = to_screen({-0.5, -0.5});
  const QRectF target(corner, frame_size() * viewport_.zoom);
  if (image_.isNull()) {
    painter.fillRect(target, colors().sunken);
    painter.setPen(QPen(colors().control_edge, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(target);
    return;
  }
  // Single pixels stay square once they are large enough to be distinguished.
  painter.setRenderHint(QPainter::SmoothPixmapTransform, viewport_.zoom * devicePixelRatioF() < 4);
  const Vector2 first = to_image(image_area().topLeft()), last = to_image(image_area().bottomRight());
  const QRect part = QRect(QPoint(static_cast<int>(std::floor(first.x())), static_cast<int>(std::floor(first.y()))),
                           QPoint(static_cast<int>(std::ceil(last.x())) + 1, static_cast<int>(std::ceil(last.y())) + 1))
                         .intersected(image_.rect());
  if (part.isEmpty()) return;
  const QPointF at = to_screen({part.left() - 0.5, part.top() - 0.5});
  painter.drawImage(QRectF(at, QSizeF(part.size()) * viewport_.zoom), shown_, QRectF(part));
}

void ImageView::paint_corners(QPainter& painter) const {
  QPainterPath path;
  for (const Vector2& corner : corners_) path.addPath(cross_path(to_screen(corner), 0, 3));
  painter.setOpacity(0.6);
  draw_rimmed_path(painter, path, QPen(QColor(0xB0, 0xD8, 0xFF), 1));
  painter.setOpacity(1);
}

void ImageView::paint_epipolar_line(QPainter& painter) const {
  if (epipolar_line_.size() < 2) return;
  QPainterPath path(to_screen(epipolar_line_.front()));
  for (const Vector2& px : epipolar_line_) path.lineTo(to_screen(px));
  QPen pen(QColor(0x6C, 0xB2, 0xFF), 1);
  draw_rimmed_path(painter, path, pen);
}

void ImageView::paint_axes(QPainter& painter) const {
  static const std::array<QString, 3> letters = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  painter.setFont(text_font(TextRole::small));
  for (const ImageAxes& axes : axes_) {
    const QPointF origin = to_screen(axes.origin);
    for (std::size_t i = 0; i < 3; ++i) {
      const QPointF tip = to_screen(axes.tips[i]);
      const QColor color = axes.is_estimate ? colors().tcp_est_axes[i] : colors().tcp_axes[i];
      QPainterPath path(origin);
      path.lineTo(tip);
      draw_rimmed_path(painter, path, QPen(color, 2));
      painter.setPen(QPen(QColor(0, 0, 0, 160), 1));
      painter.setBrush(color);
      if (axes.is_estimate) {
        painter.drawEllipse(tip, 3.5, 3.5);
      } else {
        const QPointF d = tip - origin;
        const double length = std::max(std::hypot(d.x(), d.y()), 1e-9);
        const QPointF along = d / length * 9, side(-along.y() * 0.45, along.x() * 0.45);
        painter.drawPolygon(QPolygonF({tip + along * 0.4, tip - along * 0.6 + side, tip - along * 0.6 - side}));
      }
      // Letters of axes shorter than themselves only cover each other.
      if (std::hypot(tip.x() - origin.x(), tip.y() - origin.y()) < shortest_named_axis) continue;
      const QPointF place = tip + (axes.is_estimate ? QPointF(6, 9) : QPointF(6, -7));
      draw_plate(painter, place, axes.is_estimate ? letters[i] + QStringLiteral("′") : letters[i], colors().ink1,
                 colors().panel);
    }
  }
}

void ImageView::paint_arrows(QPainter& painter) const {
  for (const ImageArrow& arrow : arrows_) {
    const Vector2 tip = arrow.from + magnification_ * arrow.residual;
    const QColor color =
        arrow.rms_over_sigma ? residual_color(arrow.rms_over_sigma, arrow.coordinates) : colors().residual[3];
    draw_rimmed_path(painter, arrow_path(to_screen(arrow.from), to_screen(tip)), QPen(color, 1.6));
  }
}

void ImageView::paint_marks(QPainter& painter) const {
  for (const ImageMark& mark : marks_) {
    const QPointF at = to_screen(mark.position);
    if (mark.role == MarkRole::predicted) {
      draw_rimmed_path(painter, cross_path(at, 1.5, 6), QPen(QColor(0xFF, 0xFF, 0xFF), 1.4));
      continue;
    }
    QPainterPath ring;
    ring.addEllipse(at, 7, 7);
    if (mark.role == MarkRole::ghost) {
      QPen pen(theme_colors(ThemeKind::dark).candidate, 1.6, Qt::DashLine);
      ring.addPath(cross_path(at, 3, 11));
      draw_rimmed_path(painter, ring, pen);
      continue;
    }
    const bool is_selected = mark.marker == selected_marker_;
    QColor color = mark.rms_over_sigma ? residual_color(mark.rms_over_sigma, mark.coordinates) : QColor(Qt::white);
    if (mark.marker == hovered_marker_ && !is_selected) {
      QPainterPath halo;
      halo.addEllipse(at, 11, 11);
      draw_rimmed_path(painter, halo, QPen(QColor(Qt::white), 1));
    }
    if (is_selected) {
      QPainterPath halo;
      halo.addEllipse(at, 11, 11);
      draw_rimmed_path(painter, halo, QPen(theme_colors(ThemeKind::dark).accent, 2));
    }
    draw_rimmed_path(painter, ring, QPen(color, 2));
    painter.setPen(QPen(QColor(255, 255, 255, 220), 0));
    painter.drawPoint(at);
  }
  paint_numbers(painter);
}

/// The markers' numbers, none over another: on the side of the marker that has room, or further out on a leader. Where
/// markers lie too close for that some have none: zoomed in, all have.
void ImageView::paint_numbers(QPainter& painter) const {
  std::vector<const ImageMark*> measured;
  for (const ImageMark& mark : marks_)
    if (mark.role == MarkRole::measured) measured.push_back(&mark);
  std::stable_partition(measured.begin(), measured.end(), [this](const ImageMark* mark) {
    return mark->marker == selected_marker_ || mark->marker == hovered_marker_;
  });
  const bool are_many = measured.size() > most_with_leaders;
  std::vector<QRectF> placed;
  constexpr double rim = 6;
  if (are_many)  // the marks themselves stay in sight
    for (const ImageMark* mark : measured) {
      const QPointF at = to_screen(mark->position);
      placed.emplace_back(at - QPointF(rim, rim), at + QPointF(rim, rim));
    }
  painter.setFont(text_font(TextRole::small));
  for (const ImageMark* mark : measured) {
    const QPointF at = to_screen(mark->position);
    const QString text = QString::number(mark->marker);
    const auto free = free_plate(at, plate_size(painter, text), placed, are_many);
    if (!free) continue;
    if (QLineF(at, free->center()).length() > 28)
      draw_rimmed_path(painter, leader(at, free->center()), QPen(QColor(Qt::white), 1));
    placed.push_back(draw_plate(painter, {free->left(), free->center().y()}, text, colors().ink1, colors().panel)
                         .adjusted(-1, -1, 1, 1));
  }
}

void ImageView::paint_candidates(QPainter& painter) const {
  painter.setFont(text_font(TextRole::small));
  for (const ImageCandidate& candidate : candidates_) {
    const QPointF at = to_screen(candidate.position);
    const bool is_hovered = candidate.index == hovered_candidate_;
    QPainterPath square;
    const double half = is_hovered ? 9 : 7;
    square.addRect(QRectF(at - QPointF(half, half), QSizeF(2 * half, 2 * half)));
    draw_rimmed_path(painter, square, QPen(theme_colors(ThemeKind::dark).accent, candidate.is_taken ? 2.5 : 1.2));
    if (!candidate.is_taken && !is_hovered) continue;
    // Beside it, on the side that has room.
    const double wide = painter.fontMetrics().horizontalAdvance(candidate.label) + 8.0;
    const double left = at.x() + 14 + wide > width() ? at.x() - 14 - wide : at.x() + 14;
    draw_plate(painter, QPointF(left, at.y() + 12), candidate.label, colors().ink1, colors().panel);
  }
}

void ImageView::paint_pointer_loupe(QPainter& painter) const {
  if (!has_loupe_ || !pointer_ || image_.isNull() || (drag_ && drag_->kind == ImageDrag::pan && drag_->has_moved))
    return;
  constexpr double side = 136, gap = 24;
  const QRectF area = image_area();
  if (area.width() < 2 * side || area.height() < 1.5 * side) return;
  // Beside the pointer, never under it: to the other side where there is no room.
  double x = pointer_->x() + gap, y = pointer_->y() - gap - side;
  if (x + side > area.right()) x = pointer_->x() - gap - side;
  if (y < area.top()) y = pointer_->y() + gap;
  const QRectF target(x, y, side, side);
  paint_loupe(painter, target, shown_, to_image(*pointer_), 8);
  painter.setPen(QPen(colors().control_edge, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(target);
}

void ImageView::paint_title(QPainter& painter) const {
  const Colors& c = colors();
  const QRectF header(0, 0, width(), 20);
  if (!title_.isEmpty()) {
    painter.fillRect(header, c.panel);
    painter.setFont(text_font(TextRole::small));
    painter.setPen(c.ink2);
    const QString zoom =
        frame_size().isEmpty() ? QString() : QStringLiteral("%1 %").arg(std::lround(100 * viewport_.zoom));
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(zoom) + layout_gap;
    draw_text(painter, header.adjusted(layout_gap, 0, -layout_gap - wide, 0), Qt::AlignLeft | Qt::AlignVCenter, title_);
    draw_text(painter, header.adjusted(layout_gap, 0, -layout_gap, 0), Qt::AlignRight | Qt::AlignVCenter, zoom);
  }
  if (!arrows_.empty() && magnification_ != 1 && !frame_size().isEmpty()) {
    painter.setFont(text_font(TextRole::small));
    const QString text = QObject::tr("arrows %1 ×").arg(times_text(magnification_));
    draw_plate(painter, QPointF(6, height() - 12.0), text, c.ink1, c.panel);
  }
}

void ImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), colors().sunken);
  if (frame_size().isEmpty()) {
    draw_sentence(painter, image_area(), empty_text_);
  } else {
    painter.save();
    painter.setClipRect(image_area());
    paint_image(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paint_corners(painter);
    paint_epipolar_line(painter);
    paint_axes(painter);
    paint_candidates(painter);
    paint_arrows(painter);
    paint_marks(painter);
    paint_pointer_loupe(painter);
    painter.restore();
  }
  painter.setRenderHint(QPainter::Antialiasing);
  paint_title(painter);
  if (hasFocus()) draw_focus(painter, rect());
}

}  // namespace handsight::widgets
