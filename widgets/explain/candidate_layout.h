// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parts of a card lie, and how they are painted. Internal to candidate_*.cpp.
#pragma once

#include <QPainter>
#include <QRectF>
#include <vector>

#include "widgets/explain/card_state.h"

namespace handsight::widgets {

/// Empty rectangles where a part is missing. Widget coordinates.
struct CardLayout {
  QRectF drawing, title, where, words, error, evidence, told_from, check, caution, buttons;
  QRectF prediction, measured_label, field, unit, answer;  // of a check with a number
  std::vector<QRectF> sizes;
  double height = 0;
};

CardLayout lay_out(const CardState& state, double width);
void paint_card(QPainter& painter, const CardState& state, const CardLayout& layout);
/// "Joint offset and payload look the same here" and the like, with their heads: what the card says of its limits.
QString indistinguishable_text(const CardState& state);
QString check_text(const CardState& state);
QString error_left_text(const ErrorLeft& error);

/// A part of a card and what is to be said of it.
struct CardTip {
  QRectF area;
  QString text;  // empty: what stands there is all
};

/// What a bar means, and what a text would say that is shortened there.
CardTip card_tip(const CardState& state, const CardLayout& layout, const QPointF& at);

}  // namespace handsight::widgets
