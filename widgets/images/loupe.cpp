// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/images/loupe.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr double magnification = 8;
constexpr int patch_radius = 10;  // px, of the half-turn difference

/// Bilinear grey value; the border's value outside.
double grey_at(const QImage& image, double u, double v) {
  u = std::clamp(u, 0.0, image.width() - 1.0);
  v = std::clamp(v, 0.0, image.height() - 1.0);
  const int u0 = std::min(static_cast<int>(u), std::max(image.width() - 2, 0));
  const int v0 = std::min(static_cast<int>(v), std::max(image.height() - 2, 0));
  const int u1 = std::min(u0 + 1, image.width() - 1), v1 = std::min(v0 + 1, image.height() - 1);
  const double a = u - u0, b = v - v0;
  const auto at = [&](int x, int y) { return static_cast<double>(qGray(image.pixel(x, y))); };
  return (1 - b) * ((1 - a) * at(u0, v0) + a * at(u1, v0)) + b * ((1 - a) * at(u0, v1) + a * at(u1, v1));
}

}  // namespace

void paint_loupe(QPainter& painter, const QRectF& target, const QImage& image, const Vector2& center, double times) {
  painter.save();
  painter.setClipRect(target);
  painter.fillRect(target, colors().sunken);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  // Pixel (u, v) has its centre at (u, v): its square begins half a pixel before.
  const QPointF origin(target.center().x() - (center.x() + 0.5) * times,
                       target.center().y() - (center.y() + 0.5) * times);
  const QRect part = QRectF((target.left() - origin.x()) / times, (target.top() - origin.y()) / times,
                            target.width() / times, target.height() / times)
                         .toAlignedRect()
                         .adjusted(-1, -1, 1, 1)
                         .intersected(image.rect());
  painter.drawImage(QRectF(origin.x() + part.left() * times, origin.y() + part.top() * times, part.width() * times,
                           part.height() * times),
                    image, part);
  if (times >= 6) {
    painter.setPen(QPen(QColor(128, 128, 128, 70), 0));
    for (int u = part.left(); u <= part.right() + 1; ++u)
      painter.drawLine(QPointF(origin.x() + u * times, target.top()), QPointF(origin.x() + u * times, target.bottom()));
    for (int v = part.top(); v <= part.bottom() + 1; ++v)
      painter.drawLine(QPointF(target.left(), origin.y() + v * times), QPointF(target.right(), origin.y() + v * times));
  }
  QPainterPath cell;
  cell.addRect(QRectF(target.center() - QPointF(times / 2, times / 2), QSizeF(times, times)));
  draw_rimmed_path(painter, cell, QPen(theme_colors(ThemeKind::dark).accent, 1));
  painter.restore();
}

QImage half_turn_difference(const QImage& image, const Vector2& center, int radius) {
  const int size = 2 * radius + 1;
  QImage difference(size, size, QImage::Format_Grayscale8);
  difference.fill(128);
  if (image.isNull()) return difference;
  for (int y = -radius; y <= radius; ++y) {
    uchar* row = difference.scanLine(y + radius);
    for (int x = -radius; x <= radius; ++x) {
      const double here = grey_at(image, center.x() + x, center.y() + y);
      const double there = grey_at(image, center.x() - x, center.y() - y);
      row[x + radius] = static_cast<uchar>(std::clamp(std::lround(128 + (here - there) / 2), 0L, 255L));
    }
  }
  return difference;
}

Loupe::Loupe(QWidget* parent) : QWidget(parent), hints_(QObject::tr("arrows 0.1 px, Shift 1, Alt free")) {}

void Loupe::set_title(const QString& title) {
  title_ = title;
  update();
}

void Loupe::set_hints(const QString& hints) {
  hints_ = hints;
  update();
}

void Loupe::set_image(const QImage& image) {
  image_ = image;
  update();
}

void Loupe::set_center(std::optional<Vector2> px) {
  center_ = px;
  update();
}

void Loupe::set_mark(std::optional<Vector2> px) {
  mark_ = px;
  update();
}

QSize Loupe::sizeHint() const { return {260, 280}; }
QSize Loupe::minimumSizeHint() const { return {160, 160}; }

void Loupe::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.panel);
  painter.setFont(text_font(TextRole::small));
  painter.setPen(c.ink2);
  const QRectF head(layout_gap, 0, width() - 2 * layout_gap, 20);
  const QString where =
      center_ && !image_.isNull()
          ? QStringLiteral("8 ×   %1 / %2").arg(fixed_text(center_->x(), 1), fixed_text(center_->y(), 1))
          : QString();
  const double taken = where.isEmpty() ? 0 : QFontMetricsF(painter.font()).horizontalAdvance(where) + layout_gap;
  draw_text(painter, head.adjusted(0, 0, -taken, 0), Qt::AlignLeft | Qt::AlignVCenter, title_);
  const QRectF foot(layout_gap, height() - 20.0, width() - 2 * layout_gap, 20);
  draw_text(painter, foot, Qt::AlignLeft | Qt::AlignVCenter, hints_);
  const QRectF body(0, 20, width(), height() - 40.0);
  if (!center_ || image_.isNull()) {
    painter.fillRect(body, c.sunken);
    draw_sentence(painter, body, QObject::tr("Move the pointer over the image."));
    return;
  }
  painter.setPen(c.ink2);
  draw_text(painter, head, Qt::AlignRight | Qt::AlignVCenter, where);
  paint_loupe(painter, body, image_, *center_, magnification);
  if (mark_) {
    const QPointF at(body.center().x() + (mark_->x() - center_->x()) * magnification,
                     body.center().y() + (mark_->y() - center_->y()) * magnification);
    QPainterPath cross;
    for (const QPointF& d : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      cross.moveTo(at + 4 * d);
      cross.lineTo(at + 14 * d);
    }
    painter.save();
    painter.setClipRect(body);
    draw_rimmed_path(painter, cross, QPen(Qt::white, 1.2));
    painter.restore();
  }
  const double side = std::min(72.0, body.height() / 3);
  const QRectF difference(body.right() - side - 4, body.bottom() - side - 4, side, side);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  painter.drawImage(difference, half_turn_difference(image_, *center_, patch_radius));
  painter.setPen(QPen(c.control_edge, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(difference);
  painter.setFont(text_font(TextRole::small));
  const QString name = QObject::tr("half-turn");
  const double wide = QFontMetricsF(painter.font()).horizontalAdvance(name);
  draw_plate(painter, {difference.right() - wide - 6, difference.top() - 9}, name, c.ink2, c.panel);
}

}  // namespace handsight::widgets
