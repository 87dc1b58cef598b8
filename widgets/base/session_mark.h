// SPDX-License-Identifier: GPL-3.0-or-later
// The mark of each session of a collection: a shape and a colour of its own, distinguished by either alone.
#pragma once

#include <QColor>
#include <QPainterPath>
#include <QPixmap>

class QPainter;

namespace handsight::widgets {

/// So many differ; of more they come again.
inline constexpr int session_mark_count = 8;

/// About the origin, 6 across.
QPainterPath session_mark_path(int number);
/// Of the theme in force; none of the colours of residuals, selection or candidates.
QColor session_mark_color(int number);
void draw_session_mark(QPainter& painter, const QPointF& centre, double size, int number);
QPixmap session_mark_picture(int number, int size, double pixel_ratio);

}  // namespace handsight::widgets
