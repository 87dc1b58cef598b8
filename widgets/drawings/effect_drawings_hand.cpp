// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of the marker body, and the curve without a name.
#include <cmath>

#include "widgets/drawings/effect_drawings.h"

namespace handsight::widgets {
namespace {

/// The back of a hand with fingers.
void hand(const DrawingKit& kit) {
  kit.link(Ink::model, {48, 88}, {48, 80}, 12);
  for (int i = 0; i < 3; ++i) kit.link(Ink::model, {32.0 + 16 * i, 26}, {32.0 + 16 * i, 10}, 8);
  kit.shape(Ink::model, {{24, 24}, {72, 24}, {76, 46}, {66, 82}, {30, 82}, {20, 46}});
}

/// All markers together moved on the hand.
void body_slip(const DrawingKit& kit) {
  hand(kit);
  const QPointF a(32, 34), b(52, 34), c(38, 54);
  kit.shape(Ink::help, {a, b, c});
  for (const QPointF& at : {a, b, c}) kit.marker(Ink::model, at, 4.5);
  QTransform slip;
  slip.translate(64, 64);
  slip.rotate(28);
  slip.translate(-41, -41);
  kit.shape(Ink::effect, slip.map(QPolygonF({a, b, c})));
  for (const QPointF& at : {a, b, c}) kit.marker(Ink::effect, slip.map(at), 4.5, -22);
  kit.arrow(Ink::effect, {76, 30}, {86, 46});
}

/// One marker of three came loose.
void marker_slip(const DrawingKit& kit) {
  hand(kit);
  const QPointF loose(60, 40), moved(82, 60);
  kit.line(Ink::help, {36, 38}, {48, 66});
  kit.line(Ink::help, {36, 38}, loose);
  kit.line(Ink::help, loose, {48, 66});
  kit.marker(Ink::model, {36, 38}, 5.5);
  kit.marker(Ink::model, {48, 66}, 5.5);
  kit.marker(Ink::help, loose, 5.5);
  kit.marker(Ink::effect, moved, 6.5, -25);
  kit.arrow(Ink::effect, {66, 45}, {76, 53});
}

/// A board, and the same as it came out of the printer.
void target_scale(const DrawingKit& kit) {
  kit.shape(Ink::effect, {{6, 22}, {90, 22}, {90, 78}, {6, 78}});
  kit.shape(Ink::model, {{18, 30}, {78, 30}, {78, 70}, {18, 70}});
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) kit.marker(Ink::model, {31.0 + 17 * i, 42.0 + 16 * j}, 5);
  kit.arrow(Ink::effect, {79, 31}, {88, 24});
  kit.arrow(Ink::effect, {17, 69}, {8, 76});
  kit.text(Ink::effect, {48, 11}, QStringLiteral("102 %"), 13);
}

/// A board from its edge: flat, and as a bow.
void target_bend(const DrawingKit& kit) {
  kit.link(Ink::model, {10, 66}, {86, 66}, 6);
  QPainterPath bow({10, 30});
  bow.quadTo({48, 84}, {86, 30});
  kit.limb(Ink::effect, bow, 5);
  for (int i = 0; i < 3; ++i) kit.line(Ink::help, {22.0 + 26 * i, 70}, {22.0 + 26 * i, 80});
  kit.arrow(Ink::effect, {14, 60}, {14, 42});
  kit.arrow(Ink::effect, {82, 60}, {82, 42});
}

/// A cube with a tag on each face, one of them askew.
void tag_placement(const DrawingKit& kit) {
  kit.shape(Ink::model, {{14, 30}, {52, 38}, {52, 86}, {14, 74}});
  kit.shape(Ink::model, {{52, 38}, {84, 26}, {84, 70}, {52, 86}});
  kit.shape(Ink::model, {{14, 30}, {48, 20}, {84, 26}, {52, 38}});
  kit.shape(Ink::help, {{22, 42}, {44, 47}, {44, 73}, {22, 66}});
  kit.shape(Ink::help, {{60, 47}, {77, 40}, {77, 63}, {60, 72}});
  QTransform askew;
  askew.translate(74, 60);
  askew.rotate(16);
  askew.translate(-68, -56);
  kit.shape(Ink::effect, askew.map(QPolygonF({{60, 47}, {77, 40}, {77, 63}, {60, 72}})));
  kit.arrow(Ink::effect, {62, 52}, {69, 55});
}

/// Something follows a joint, and no effect of the catalogue looks like it.
void unnamed(const DrawingKit& kit) {
  kit.arrow(Ink::help, {10, 88}, {10, 8});
  kit.arrow(Ink::help, {10, 88}, {92, 88});
  QPainterPath curve;
  for (int i = 0; i <= 70; ++i) {
    const QPointF at(16 + i, 54 - 20 * std::sin(i / 11.0) - 0.12 * i);
    i == 0 ? curve.moveTo(at) : curve.lineTo(at);
    if (i % 7 == 3) kit.dot(Ink::model, at + QPointF(0, (i % 2 ? 5 : -5)), 2);
  }
  kit.path(Ink::effect, curve);
  kit.text(Ink::effect, {78, 22}, QStringLiteral("?"), 26);
}

}  // namespace

std::map<std::string, DrawEffect> hand_drawings() {
  return {{"body_slip", body_slip},     {"marker_slip", marker_slip},     {"target_scale", target_scale},
          {"target_bend", target_bend}, {"tag_placement", tag_placement}, {"", unnamed}};
}

}  // namespace handsight::widgets
