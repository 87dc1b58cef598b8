// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of the robot's base, its load and its coupled joints.
#include "widgets/drawings/effect_drawings.h"

namespace handsight::widgets {
namespace {

/// A small robot of two links on a foot, turned about the foot.
void robot(const DrawingKit& kit, Ink ink, const QPointF& foot, double tilt_deg) {
  const QPointF shoulder = polar(foot, 30, 90 + tilt_deg), elbow = polar(shoulder, 24, 40 + tilt_deg);
  const QPointF wrist = polar(elbow, 20, -10 + tilt_deg);
  kit.link(ink, foot, shoulder, 9);
  kit.link(ink, shoulder, elbow, 7);
  kit.link(ink, elbow, wrist, 6);
  if (ink == Ink::effect) return;
  kit.joint(ink, shoulder, 5);
  kit.joint(ink, elbow, 4);
}

/// A weight that nobody told the model of hangs on the hand.
void payload(const DrawingKit& kit) {
  kit.link(Ink::model, {8, 20}, {48, 20});
  kit.joint(Ink::model, {8, 20}, 6);
  kit.joint(Ink::model, {52, 20}, 5);
  kit.gripper(Ink::model, {52, 24}, -90);
  kit.circle(Ink::effect, {52, 46}, 5);
  kit.shape(Ink::effect, {{40, 52}, {64, 52}, {72, 82}, {32, 82}});
  kit.text(Ink::effect, {52, 69}, QStringLiteral("kg"), 15);
  kit.gravity({84, 50}, 28);
}

/// Gravity comes from beside where the model has it.
void base_tilt(const DrawingKit& kit) {
  robot(kit, Ink::model, {26, 68}, 0);
  kit.ground({6, 74}, 42);
  kit.line(Ink::effect, {4, 84}, {92, 68});
  kit.arrow(Ink::model, {74, 12}, {74, 46});
  kit.arrow(Ink::effect, {74, 12}, {65, 46});
  kit.turn(Ink::effect, {74, 12}, 26, 270, -15);
  kit.text(Ink::model, {84, 40}, QStringLiteral("g"), 13);
  // A spirit level on the tilted line, its bubble off the middle.
  kit.shape(Ink::model, {{58, 60}, {90, 54}, {91.5, 62}, {59.5, 68}});
  kit.dot(Ink::effect, {83, 60}, 3);
}

/// The foot stands on springs.
void base_elasticity(const DrawingKit& kit) {
  robot(kit, Ink::effect, {38, 66}, -16);
  robot(kit, Ink::model, {38, 66}, 0);
  kit.shape(Ink::model, {{16, 64}, {60, 64}, {60, 71}, {16, 71}});
  kit.spring(Ink::effect, {22, 71}, {22, 86}, 3, 4);
  kit.spring(Ink::effect, {54, 71}, {54, 86}, 3, 4);
  kit.ground({8, 87}, 60);
  kit.turn(Ink::effect, {38, 66}, 52, 96, -30);
}

/// A coupled joint held by a tendon over pulleys: its load pulls at the joint before it.
void mimic_linkage(const DrawingKit& kit) {
  kit.ground({6, 86}, 40);
  kit.link(Ink::model, {26, 76}, {26, 34}, 8);
  kit.link(Ink::model, {26, 34}, {76, 24}, 8);
  kit.circle(Ink::model, {26, 76}, 10);
  kit.circle(Ink::model, {26, 34}, 10);
  kit.line(Ink::effect, {16, 76}, {16, 34});
  kit.line(Ink::effect, {36, 76}, {36, 34});
  kit.joint(Ink::model, {26, 76}, 4);
  kit.joint(Ink::model, {26, 34}, 4);
  kit.arrow(Ink::effect, {46, 44}, {46, 70});
  kit.arrow(Ink::help, {76, 30}, {76, 54});
  kit.dot(Ink::model, {76, 24}, 5);
}

/// Two wheels on a belt: the second ought to turn as far as the first.
void mimic_error(const DrawingKit& kit) {
  const QPointF first(26, 58), second(70, 58);
  kit.line(Ink::help, {26, 40}, {70, 40});
  kit.line(Ink::help, {26, 76}, {70, 76});
  kit.circle(Ink::model, first, 18);
  kit.circle(Ink::model, second, 18);
  kit.line(Ink::model, first, polar(first, 26, 60));
  kit.line(Ink::model, second, polar(second, 26, 60));
  kit.line(Ink::effect, second, polar(second, 30, 96));
  kit.turn(Ink::effect, second, 24, 62, 26);
  kit.joint(Ink::model, first, 4);
  kit.joint(Ink::model, second, 4);
  kit.text(Ink::model, {22, 20}, QStringLiteral("1"), 13);
  kit.text(Ink::effect, {66, 16}, QStringLiteral("1.01"), 13);
  kit.text(Ink::help, {40, 18}, QStringLiteral(":"), 13);
}

/// A belt from one joint to the next: the far one turns with the near one.
void joint_coupling(const DrawingKit& kit) {
  const QPointF near(22, 70), far(66, 40);
  kit.link(Ink::model, near, far, 12);
  kit.line(Ink::help, {15, 60}, {59, 30});
  kit.line(Ink::help, {29, 80}, {73, 50});
  kit.joint(Ink::model, near, 8);
  kit.link(Ink::model, far, {90, 40}, 7);
  kit.link(Ink::effect, far, {84, 62}, 7);
  kit.joint(Ink::model, far, 8);
  kit.turn(Ink::model, near, 18, 60, 90);
  kit.turn(Ink::effect, far, 26, -4, -38);
}

}  // namespace

std::map<std::string, DrawEffect> robot_drawings() {
  return {{"payload", payload},
          {"base_tilt", base_tilt},
          {"base_elasticity", base_elasticity},
          {"mimic_linkage", mimic_linkage},
          {"mimic_error", mimic_error},
          {"joint_coupling", joint_coupling}};
}

}  // namespace handsight::widgets
