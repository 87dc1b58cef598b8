// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of the cameras and of time.
#include <cmath>

#include "widgets/drawings/effect_drawings.h"

namespace handsight::widgets {
namespace {

/// The camera turned and shifted on the link that carries it.
void camera_mount(const DrawingKit& kit) {
  kit.link(Ink::model, {18, 90}, {18, 62}, 10);
  kit.shape(Ink::model, {{8, 50}, {30, 50}, {30, 58}, {8, 58}});
  kit.dot(Ink::help, {12, 54}, 1.6);
  kit.dot(Ink::help, {26, 54}, 1.6);
  kit.camera(Ink::model, {20, 42}, 0, 50);
  kit.camera(Ink::effect, {22, 34}, 30, 32);
  kit.turn(Ink::effect, {20, 42}, 50, 2, 22);
}

/// The right camera squints against the left one.
void stereo_rig(const DrawingKit& kit) {
  kit.shape(Ink::model, {{8, 78}, {88, 78}, {88, 84}, {8, 84}});
  kit.camera(Ink::model, {24, 66}, 90, 46);
  kit.camera(Ink::model, {72, 66}, 90, 46);
  kit.camera(Ink::effect, {71, 62}, 118, 44);
  kit.turn(Ink::effect, {72, 66}, 34, 88, 24);
  kit.text(Ink::help, {24, 91}, QStringLiteral("L"), 11);
  kit.text(Ink::help, {72, 91}, QStringLiteral("R"), 11);
}

/// One of several cameras squints.
void rig(const DrawingKit& kit) {
  kit.shape(Ink::model, {{8, 78}, {88, 78}, {88, 84}, {8, 84}});
  for (const double x : {20.0, 46.0, 72.0}) kit.camera(Ink::model, {x, 66}, 90, 42);
  kit.camera(Ink::effect, {71, 62}, 116, 40);
  kit.turn(Ink::effect, {72, 66}, 34, 88, 22);
}

/// Rays through the lens onto the sensor: another focal length, another middle.
void camera_intrinsics(const DrawingKit& kit) {
  QPainterPath lens;
  lens.addEllipse(QPointF(38, 46), 5, 24);
  kit.axis(Ink::help, {2, 46}, {94, 46});
  kit.line(Ink::help, {4, 14}, {38, 46});
  kit.line(Ink::help, {38, 46}, {86, 86});
  kit.line(Ink::help, {4, 74}, {38, 46});
  kit.line(Ink::help, {38, 46}, {86, 6});
  kit.path(Ink::model, lens);
  kit.line(Ink::model, {68, 18}, {68, 74});
  kit.line(Ink::effect, {80, 12}, {80, 84});
  kit.line(Ink::model, {64, 46}, {72, 46});
  kit.dot(Ink::effect, {80, 38}, 3.5);
  kit.arrow(Ink::help, {54, 86}, {39, 86});
  kit.arrow(Ink::help, {52, 86}, {67, 86});
  kit.text(Ink::help, {53, 78}, QStringLiteral("f"), 13);
}

/// A straight grid and what the lens makes of it.
void lens_distortion(const DrawingKit& kit) {
  const auto bulged = [](double x, double y) {
    const double r2 = (x * x + y * y);
    return QPointF(48 + 42 * x * (1 - 0.14 * r2), 48 + 42 * y * (1 - 0.14 * r2));
  };
  for (int i = -2; i <= 2; ++i) {
    const double at = i / 2.0;
    kit.line(Ink::help, {48 + 42 * at, 6}, {48 + 42 * at, 90});
    kit.line(Ink::help, {6, 48 + 42 * at}, {90, 48 + 42 * at});
    QPainterPath across, along;
    for (int k = -10; k <= 10; ++k) {
      const double t = k / 10.0;
      k == -10 ? across.moveTo(bulged(t, at)) : across.lineTo(bulged(t, at));
      k == -10 ? along.moveTo(bulged(at, t)) : along.lineTo(bulged(at, t));
    }
    kit.path(Ink::effect, across);
    kit.path(Ink::effect, along);
  }
}

/// The picture is taken when the arm is already elsewhere.
void time_lag(const DrawingKit& kit) {
  const QPointF joint(20, 84);
  kit.clock(Ink::model, {24, 24}, 17, -30);
  kit.link(Ink::model, joint, polar(joint, 62, 22), 8);
  kit.link(Ink::effect, joint, polar(joint, 62, 52), 8);
  kit.joint(Ink::model, joint, 6);
  kit.turn(Ink::effect, joint, 72, 20, 24);
  kit.text(Ink::effect, {74, 14}, QStringLiteral("+ Δt"), 14);
}

/// The stand was knocked: the camera is elsewhere from one moment on.
void mount_slip(const DrawingKit& kit) {
  kit.line(Ink::help, {8, 86}, {84, 86});
  kit.link(Ink::model, {24, 84}, {24, 56}, 6);
  kit.camera(Ink::model, {24, 46}, 0, 28);
  kit.link(Ink::effect, {44, 84}, {54, 58}, 6);
  kit.camera(Ink::effect, {57, 48}, 14, 26);
  kit.arrow(Ink::effect, {29, 72}, {43, 72});
}

/// The camera creeps while the session lasts: it warms up.
void mount_drift(const DrawingKit& kit) {
  kit.circle(Ink::model, {14, 80}, 8);
  kit.shape(Ink::model, {{10, 20}, {18, 20}, {18, 74}, {10, 74}});
  kit.dot(Ink::effect, {14, 80}, 5);
  kit.shape(Ink::effect, {{12, 42}, {16, 42}, {16, 76}, {12, 76}});
  for (int i = 0; i < 4; ++i) kit.line(Ink::help, {20, 26.0 + 10 * i}, {24, 26.0 + 10 * i});
  kit.shape(Ink::model, {{36, 84}, {70, 84}, {70, 90}, {36, 90}});
  kit.camera(Ink::effect, {60, 36}, 26, 0);
  kit.camera(Ink::effect, {57, 54}, 12, 0);
  kit.camera(Ink::model, {52, 74}, 0, 0);
  kit.arrow(Ink::effect, {82, 68}, {88, 30});
}

}  // namespace

std::map<std::string, DrawEffect> camera_drawings() {
  return {{"camera_mount", camera_mount},
          {"stereo_rig", stereo_rig},
          {"rig", rig},
          {"camera_intrinsics", camera_intrinsics},
          {"lens_distortion", lens_distortion},
          {"time_lag", time_lag},
          {"mount_drift", mount_drift},
          {"mount_slip", mount_slip}};
}

}  // namespace handsight::widgets
