// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/effect_drawing.h"

#include <algorithm>

#include "widgets/drawings/effect_drawings.h"

namespace handsight::widgets {
namespace {

constexpr double side_length = 96, share = 0.94;

const std::map<std::string, DrawEffect>& drawings() {
  static const std::map<std::string, DrawEffect> all = [] {
    std::map<std::string, DrawEffect> map = joint_drawings();
    map.merge(robot_drawings());
    map.merge(camera_drawings());
    map.merge(hand_drawings());
    return map;
  }();
  return all;
}

}  // namespace

bool has_effect_drawing(const std::string& effect_id) { return drawings().count(effect_id) > 0; }

void paint_effect(QPainter& painter, const QRectF& area, const std::string& effect_id, const Colors& colors) {
  const double side = std::min(area.width(), area.height());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  // A little smaller than the square: lines have a width.
  painter.translate(area.center());
  painter.scale(share * side / side_length, share * side / side_length);
  painter.translate(-side_length / 2, -side_length / 2);
  const DrawingKit kit(painter, colors);
  const auto found = drawings().find(effect_id);
  if (found != drawings().end())
    found->second(kit);
  else
    kit.text(Ink::help, {48, 48}, QStringLiteral("?"), 40);
  painter.restore();
}

EffectDrawing::EffectDrawing(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void EffectDrawing::set_effect(const std::string& effect_id) {
  effect_ = effect_id;
  update();
}

void EffectDrawing::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_effect(painter, rect(), effect_, colors());
}

}  // namespace handsight::widgets
