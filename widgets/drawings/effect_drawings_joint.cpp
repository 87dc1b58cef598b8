// SPDX-License-Identifier: GPL-3.0-or-later
// Effects that sit at one joint.
#include <cmath>
#include <numbers>

#include "widgets/drawings/effect_drawings.h"

namespace handsight::widgets {
namespace {

/// A pedestal with a joint on top; returns the joint.
QPointF pedestal(const DrawingKit& kit) {
  const QPointF joint(24, 46);
  kit.ground({6, 84}, 36);
  kit.link(Ink::model, {24, 80}, joint, 12);
  return joint;
}

/// The zero is set wrong: the pointer stands beside the mark, by the same amount everywhere.
void joint_offset(const DrawingKit& kit) {
  const QPointF joint(34, 62);
  for (int i = 0; i < 24; ++i)
    kit.line(Ink::help, polar(joint, i % 6 == 0 ? 21 : 24, 15.0 * i), polar(joint, 29, 15.0 * i));
  kit.circle(Ink::model, joint, 30);
  kit.link(Ink::model, joint, polar(joint, 56, 0), 8);
  kit.link(Ink::effect, joint, polar(joint, 56, 28), 8);
  kit.joint(Ink::model, joint, 8);
  kit.turn(Ink::effect, joint, 46, 6, 20);
  kit.text(Ink::model, {86, 78}, QStringLiteral("0"), 13);
  kit.text(Ink::effect, {48, 14}, QStringLiteral("+ const."), 13);
}

/// Two protractors whose marks run apart.
void joint_scale(const DrawingKit& kit) {
  const QPointF joint(48, 74);
  for (int i = 0; i <= 6; ++i) {
    kit.line(Ink::model, polar(joint, 30, 24.0 * i), polar(joint, 22, 24.0 * i));
    kit.line(Ink::effect, polar(joint, 32, 28.0 * i), polar(joint, 42, 28.0 * i));
  }
  QPainterPath inner, outer;
  inner.arcMoveTo(QRectF(18, 44, 60, 60), 0);
  inner.arcTo(QRectF(18, 44, 60, 60), 0, 180);
  outer.arcMoveTo(QRectF(4, 30, 88, 88), 0);
  outer.arcTo(QRectF(4, 30, 88, 88), 0, 180);
  kit.path(Ink::help, inner);
  kit.path(Ink::help, outer);
  kit.link(Ink::model, joint, polar(joint, 18, 144), 7);
  kit.joint(Ink::model, joint, 7);
  kit.text(Ink::effect, {48, 16}, QStringLiteral("× 1.01"), 13);
}

/// The joint is a spring: the whole link turns down.
void joint_elasticity(const DrawingKit& kit) {
  const QPointF joint = pedestal(kit), tip(84, 32), down(83, 60);
  kit.link(Ink::effect, joint, down);
  kit.link(Ink::model, joint, tip);
  kit.joint(Ink::model, joint, 11);
  kit.spiral(Ink::effect, joint, 9);
  kit.turn(Ink::effect, joint, 46, 10, -18);
  kit.gravity({88, 68}, 20);
}

/// The housing tips across the axis and the link sags.
void link_elasticity(const DrawingKit& kit) {
  kit.ground({4, 84}, 40);
  kit.shape(Ink::model, {{12, 40}, {34, 40}, {34, 82}, {12, 82}});
  kit.axis(Ink::model, {23, 14}, {23, 92});
  kit.axis(Ink::effect, {35, 12}, {18, 84});
  QPainterPath bent({34, 50});
  bent.cubicTo({56, 50}, {72, 56}, {84, 74});
  kit.limb(Ink::effect, bent, 10);
  kit.link(Ink::model, {39, 50}, {84, 50}, 10);
  kit.turn(Ink::effect, {23, 50}, 40, 110, -18);
  kit.gravity({64, 14}, 22);
}

/// The second axis sits beside and tilted against the drawing.
void link_geometry(const DrawingKit& kit) {
  kit.link(Ink::model, {22, 60}, {66, 60}, 16);
  kit.axis(Ink::model, {22, 26}, {22, 92});
  kit.axis(Ink::model, {66, 26}, {66, 92});
  kit.joint(Ink::model, {22, 60}, 5);
  kit.joint(Ink::model, {66, 60}, 5);
  kit.axis(Ink::effect, {84, 20}, {68, 94});
  kit.dot(Ink::effect, {75, 60}, 3);
  kit.turn(Ink::effect, {66, 92}, 62, 90, -13);
  kit.line(Ink::help, {22, 16}, {22, 24});
  kit.arrow(Ink::help, {60, 20}, {24, 20});
  kit.arrow(Ink::help, {28, 20}, {64, 20});
}

/// A slotted disc whose middle is not the axis.
void encoder_eccentricity(const DrawingKit& kit) {
  const QPointF disc(44, 52), axis(54, 46);
  kit.circle(Ink::model, disc, 34);
  for (int i = 0; i < 36; ++i) kit.line(Ink::help, polar(disc, 26, 10.0 * i), polar(disc, 32, 10.0 * i));
  kit.line(Ink::model, disc - QPointF(5, 0), disc + QPointF(5, 0));
  kit.line(Ink::model, disc - QPointF(0, 5), disc + QPointF(0, 5));
  kit.circle(Ink::effect, axis, 20);
  kit.dot(Ink::effect, axis, 4);
  kit.shape(Ink::model, {{76, 45}, {93, 45}, {93, 59}, {76, 59}});  // the reading head
  kit.line(Ink::model, {70, 52}, {76, 52});
  kit.turn(Ink::effect, axis, 12, 60, 150);
}

/// A harmonic drive and its error, twice a turn.
void transmission_ripple(const DrawingKit& kit) {
  const QPointF middle(48, 34);
  QPolygonF ring;
  for (int i = 0; i < 48; ++i) ring += polar(middle, i % 2 ? 28.0 : 31.5, 7.5 * i);
  kit.shape(Ink::model, ring);
  QPainterPath cam;
  cam.addEllipse(middle, 25.5, 18);
  kit.path(Ink::effect, cam);
  kit.joint(Ink::model, middle, 7);
  kit.turn(Ink::help, middle, 13, 20, 120);
  QPainterPath wave({6, 82});
  for (int i = 1; i <= 84; ++i) wave.lineTo(6 + i, 82 - 9 * std::sin(2 * 2 * std::numbers::pi * i / 84));
  kit.line(Ink::help, {6, 82}, {90, 82});
  kit.path(Ink::effect, wave);
}

QPolygonF teeth(double left, double root, double tip) {
  QPolygonF profile;
  for (int i = 0; i < 3; ++i) {
    const double x = left + 32 * i;
    profile << QPointF(x, root) << QPointF(x + 4, tip) << QPointF(x + 10, tip) << QPointF(x + 14, root);
  }
  return profile;
}

/// Teeth with play between the flanks.
void backlash(const DrawingKit& kit) {
  QPolygonF lower = teeth(8, 64, 42);
  lower.prepend({0, 64});
  lower << QPointF(96, 64) << QPointF(96, 84) << QPointF(0, 84);
  kit.shape(Ink::model, lower);
  QPolygonF upper = teeth(23, 38, 60), moved = teeth(27, 38, 60);
  upper.resize(8);
  moved.resize(8);
  moved << QPointF(94, 38) << QPointF(94, 16) << QPointF(12, 16) << QPointF(12, 38);
  upper << QPointF(88, 38) << QPointF(88, 20) << QPointF(6, 20) << QPointF(6, 38);
  kit.shape(Ink::model, upper);
  kit.shape(Ink::effect, moved);
  kit.arrow(Ink::effect, {42, 27}, {58, 27});
  kit.arrow(Ink::effect, {52, 27}, {36, 27});
}

/// Brake shoes at the joint, and the loop that they leave.
void friction_hysteresis(const DrawingKit& kit) {
  const QPointF joint(48, 24);
  kit.circle(Ink::model, joint, 15);
  kit.joint(Ink::model, joint, 4);
  kit.turn(Ink::help, joint, 9, 200, -130);
  for (const double side : {-1.0, 1.0}) {
    const double x = 48 + side * 16;
    kit.shape(Ink::effect, {{x, 14}, {x + side * 8, 12}, {x + side * 8, 36}, {x, 34}});
    kit.arrow(Ink::effect, {48 + side * 40, 24}, {48 + side * 26, 24});
  }
  kit.line(Ink::help, {6, 70}, {90, 70});
  kit.line(Ink::help, {48, 46}, {48, 94});
  QPainterPath loop({14, 90});
  loop.cubicTo({54, 90}, {52, 54}, {82, 50});
  loop.cubicTo({42, 50}, {44, 86}, {14, 90});
  kit.path(Ink::effect, loop);
  kit.arrow(Ink::effect, {55, 72}, {60, 65});
  kit.arrow(Ink::effect, {41, 68}, {36, 75});
}

}  // namespace

std::map<std::string, DrawEffect> joint_drawings() {
  return {{"joint_offset", joint_offset},
          {"joint_scale", joint_scale},
          {"joint_elasticity", joint_elasticity},
          {"link_elasticity", link_elasticity},
          {"link_geometry", link_geometry},
          {"encoder_eccentricity", encoder_eccentricity},
          {"transmission_ripple", transmission_ripple},
          {"backlash", backlash},
          {"friction_hysteresis", friction_hysteresis}};
}

}  // namespace handsight::widgets
