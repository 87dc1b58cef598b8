// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/drawing_kit.h"

#include <cmath>
#include <numbers>

namespace handsight::widgets {
namespace {

constexpr double stroke_width = 1.9, thin_width = 1.2;

/// Turned by an angle (degrees, counter-clockwise) about the origin and put at a place.
QPolygonF placed(const QPolygonF& polygon, const QPointF& at, double angle_deg) {
  QTransform transform;
  transform.translate(at.x(), at.y());
  transform.rotate(-angle_deg);
  return transform.map(polygon);
}

}  // namespace

QPointF polar(const QPointF& center, double radius, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return center + QPointF(radius * std::cos(angle), -radius * std::sin(angle));
}

QPen DrawingKit::pen(Ink ink, double width) const {
  QPen pen(ink == Ink::model ? colors_.ink1 : ink == Ink::effect ? colors_.candidate : colors_.ink3, width);
  pen.setCapStyle(Qt::RoundCap);
  pen.setJoinStyle(Qt::RoundJoin);
  if (ink == Ink::effect) {
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern({2.6, 1.5});
  }
  return pen;
}

QPen DrawingKit::thin(Ink ink) const {
  QPen pen = this->pen(ink, thin_width);
  pen.setStyle(Qt::SolidLine);
  return pen;
}

QBrush DrawingKit::cover(Ink ink) const {
  if (ink != Ink::effect) return colors_.panel;
  QColor veil = colors_.candidate;
  veil.setAlpha(36);
  return veil;
}

void DrawingKit::line(Ink ink, const QPointF& from, const QPointF& to) const {
  painter_.setPen(ink == Ink::help ? thin(ink) : pen(ink, stroke_width));
  painter_.drawLine(from, to);
}

void DrawingKit::path(Ink ink, const QPainterPath& path) const {
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(ink == Ink::help ? thin(ink) : pen(ink, stroke_width));
  painter_.drawPath(path);
}

void DrawingKit::circle(Ink ink, const QPointF& center, double radius) const {
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(ink == Ink::help ? thin(ink) : pen(ink, stroke_width));
  painter_.drawEllipse(center, radius, radius);
}

void DrawingKit::dot(Ink ink, const QPointF& center, double radius) const {
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(pen(ink, 1).color());
  painter_.drawEllipse(center, radius, radius);
}

void DrawingKit::shape(Ink ink, const QPolygonF& polygon) const {
  painter_.setBrush(cover(ink));
  painter_.setPen(ink == Ink::help ? thin(ink) : pen(ink, stroke_width));
  painter_.drawPolygon(polygon);
}

void DrawingKit::arrow(Ink ink, const QPointF& from, const QPointF& to) const {
  const QLineF whole(from, to);
  const double angle = whole.angle();
  QPen stroke = pen(ink, stroke_width);
  stroke.setStyle(Qt::SolidLine);  // short: dashes would not show
  painter_.setPen(stroke);
  painter_.drawLine(from, polar(to, 4, angle + 180));
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(stroke.color());
  painter_.drawPolygon(QPolygonF({to, polar(to, 7, angle + 155), polar(to, 7, angle - 155)}));
}

void DrawingKit::turn(Ink ink, const QPointF& center, double radius, double from_deg, double span_deg) const {
  const QRectF box(center.x() - radius, center.y() - radius, 2 * radius, 2 * radius);
  QPainterPath arc;
  arc.arcMoveTo(box, from_deg);
  arc.arcTo(box, from_deg, span_deg);
  QPen stroke = pen(ink, stroke_width);
  stroke.setStyle(Qt::SolidLine);
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(stroke);
  painter_.drawPath(arc);
  const double along = from_deg + span_deg + (span_deg > 0 ? 90 : -90);
  const QPointF end = polar(center, radius, from_deg + span_deg);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(stroke.color());
  painter_.drawPolygon(QPolygonF({polar(end, 4, along), polar(end, 3.6, along + 115), polar(end, 3.6, along - 115)}));
}

void DrawingKit::text(Ink ink, const QPointF& center, const QString& text, double size) const {
  QFont font = text_font(TextRole::body);
  font.setPixelSize(static_cast<int>(size));
  painter_.setFont(font);
  painter_.setPen(pen(ink, 1).color());
  painter_.drawText(QRectF(center - QPointF(40, 12), QSizeF(80, 24)), Qt::AlignCenter, text);
}

void DrawingKit::limb(Ink ink, const QPainterPath& spine, double width) const {
  QPainterPathStroker stroker;
  stroker.setWidth(width);
  stroker.setCapStyle(Qt::RoundCap);
  stroker.setJoinStyle(Qt::RoundJoin);
  painter_.setBrush(cover(ink));
  painter_.setPen(ink == Ink::help ? thin(ink) : pen(ink, stroke_width));
  painter_.drawPath(stroker.createStroke(spine).simplified());
}

void DrawingKit::link(Ink ink, const QPointF& from, const QPointF& to, double width) const {
  QPainterPath spine(from);
  spine.lineTo(to);
  limb(ink, spine, width);
}

void DrawingKit::joint(Ink ink, const QPointF& center, double radius) const {
  painter_.setBrush(colors_.panel);
  painter_.setPen(pen(ink, stroke_width));
  painter_.drawEllipse(center, radius, radius);
  dot(ink, center, radius * 0.3);
}

void DrawingKit::axis(Ink ink, const QPointF& from, const QPointF& to) const {
  QPen stroke = pen(ink, thin_width + 0.3);
  stroke.setCapStyle(Qt::FlatCap);
  stroke.setDashPattern({6, 2, 1.2, 2});
  painter_.setPen(stroke);
  painter_.drawLine(from, to);
}

void DrawingKit::ground(const QPointF& left, double width) const {
  painter_.setPen(pen(Ink::model, stroke_width));
  painter_.drawLine(left, left + QPointF(width, 0));
  painter_.setPen(thin(Ink::help));
  for (int x = 3; x <= width; x += 6) painter_.drawLine(left + QPointF(x, 1), left + QPointF(x - 4, 6));
}

void DrawingKit::gravity(const QPointF& from, double length) const {
  arrow(Ink::help, from, from + QPointF(0, length));
  text(Ink::help, from + QPointF(7, length - 5), QStringLiteral("g"), 12);
}

void DrawingKit::gripper(Ink ink, const QPointF& wrist, double angle_deg) const {
  for (const double side : {-1.0, 1.0}) {
    const QPolygonF finger = placed({{0, 0}, {3, side * 7}, {9, side * 7}, {15, side * 3}}, wrist, angle_deg);
    QPainterPath path;
    path.addPolygon(finger);
    this->path(ink, path);
  }
}

void DrawingKit::camera(Ink ink, const QPointF& center, double angle_deg, double cone) const {
  if (cone > 0) {
    const QPointF eye = polar(center, 13, angle_deg);
    for (const double side : {-20.0, 20.0}) {
      painter_.setPen(thin(ink == Ink::model ? Ink::help : ink));
      painter_.drawLine(eye, polar(eye, cone, angle_deg + side));
    }
  }
  shape(ink, placed({{-10, -7}, {6, -7}, {6, 7}, {-10, 7}}, center, angle_deg));
  shape(ink, placed({{6, -3.5}, {12, -6}, {12, 6}, {6, 3.5}}, center, angle_deg));
}

void DrawingKit::marker(Ink ink, const QPointF& center, double half, double angle_deg) const {
  shape(ink, placed({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, center, angle_deg));
  QColor fill = pen(ink, 1).color();
  if (ink == Ink::effect) fill.setAlpha(150);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(fill);
  painter_.drawPolygon(placed({{-half, -half}, {0, -half}, {0, 0}, {-half, 0}}, center, angle_deg));
  painter_.drawPolygon(placed({{0, 0}, {half, 0}, {half, half}, {0, half}}, center, angle_deg));
}

void DrawingKit::spring(Ink ink, const QPointF& from, const QPointF& to, int turns, double half) const {
  const QLineF whole(from, to);
  QPolygonF zigzag({from});
  const double step = whole.length() / (2 * turns + 2);
  for (int i = 0; i < 2 * turns; ++i)
    zigzag += polar(polar(from, step * (i + 1.5), whole.angle()), half, whole.angle() + (i % 2 ? 90 : -90));
  zigzag += to;
  painter_.setBrush(Qt::NoBrush);
  QPen stroke = pen(ink, stroke_width - 0.3);
  stroke.setStyle(Qt::SolidLine);
  painter_.setPen(stroke);
  painter_.drawPolyline(zigzag);
}

void DrawingKit::spiral(Ink ink, const QPointF& center, double radius) const {
  QPolygonF curve;
  for (int i = 0; i <= 72; ++i) curve += polar(center, 1.5 + (radius - 1.5) * i / 72.0, 12.5 * i);
  painter_.setBrush(Qt::NoBrush);
  QPen stroke = pen(ink, thin_width + 0.3);
  stroke.setStyle(Qt::SolidLine);
  painter_.setPen(stroke);
  painter_.drawPolyline(curve);
}

void DrawingKit::clock(Ink ink, const QPointF& center, double radius, double hand_deg) const {
  painter_.setBrush(cover(ink));
  painter_.setPen(pen(ink, stroke_width));
  painter_.drawEllipse(center, radius, radius);
  for (int i = 0; i < 12; i += 3) line(Ink::help, polar(center, radius - 3, 30 * i), polar(center, radius - 1, 30 * i));
  line(Ink::model, center, polar(center, radius * 0.65, hand_deg));
  line(Ink::model, center, polar(center, radius * 0.5, 90));
}

}  // namespace handsight::widgets
