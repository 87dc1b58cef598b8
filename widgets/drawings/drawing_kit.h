// SPDX-License-Identifier: GPL-3.0-or-later
// Parts that the drawings of the effects share. Internal to effect_drawing*.cpp. Lengths in a square of 96 x 96.
#pragma once

#include <QPainter>
#include <QPainterPath>

#include "widgets/base/theme.h"

namespace handsight::widgets {

/// What the model believes is drawn solid; what the effect does is dashed and purple; help lines are thin.
enum class Ink { model, effect, help };

class DrawingKit {
 public:
  DrawingKit(QPainter& painter, const Colors& colors) : painter_(painter), colors_(colors) {}

  void line(Ink ink, const QPointF& from, const QPointF& to) const;
  void path(Ink ink, const QPainterPath& path) const;
  void circle(Ink ink, const QPointF& center, double radius) const;
  void dot(Ink ink, const QPointF& center, double radius = 2) const;
  void shape(Ink ink, const QPolygonF& polygon) const;  // closed, its inside covers what is behind
  void arrow(Ink ink, const QPointF& from, const QPointF& to) const;
  /// An arc with a head at its end; degrees, counter-clockwise from the right as in mathematics.
  void turn(Ink ink, const QPointF& center, double radius, double from_deg, double span_deg) const;
  void text(Ink ink, const QPointF& center, const QString& text, double size = 12) const;

  void link(Ink ink, const QPointF& from, const QPointF& to, double width = 9) const;
  void limb(Ink ink, const QPainterPath& spine, double width = 9) const;  // a link along a curve
  void joint(Ink ink, const QPointF& center, double radius = 6) const;
  void axis(Ink ink, const QPointF& from, const QPointF& to) const;  // dash-dot
  void ground(const QPointF& left, double width) const;
  void gravity(const QPointF& from, double length = 18) const;
  void gripper(Ink ink, const QPointF& wrist, double angle_deg) const;
  /// A camera whose lens looks along the angle; `cone` is the length of its field of view, 0: none.
  void camera(Ink ink, const QPointF& center, double angle_deg, double cone = 0) const;
  void marker(Ink ink, const QPointF& center, double half = 5, double angle_deg = 0) const;  // an X-corner
  void spring(Ink ink, const QPointF& from, const QPointF& to, int turns = 4, double half = 4) const;
  void spiral(Ink ink, const QPointF& center, double radius) const;
  void clock(Ink ink, const QPointF& center, double radius, double hand_deg) const;

 private:
  QPen pen(Ink ink, double width) const;
  QPen thin(Ink ink) const;
  QBrush cover(Ink ink) const;

  QPainter& painter_;
  const Colors& colors_;
};

/// A point at a distance from another; degrees, counter-clockwise from the right.
QPointF polar(const QPointF& center, double radius, double angle_deg);

}  // namespace handsight::widgets
