// SPDX-License-Identifier: GPL-3.0-or-later
// Small things that several widgets paint alike. Internal to widgets/.
#pragma once

#include <QBrush>
#include <QPainter>
#include <QString>

#include "widgets/base/cells.h"

namespace handsight::widgets {

/// A line of text on one line, shortened at its end where it does not fit.
void draw_text(QPainter& painter, const QRectF& area, Qt::Alignment alignment, const QString& text);

/// A sentence in the middle of an area, wrapped, in ink 2.
void draw_sentence(QPainter& painter, const QRectF& area, const QString& sentence);

/// A stroke that shows over any photograph: the pen with a 1 px rim of the other lightness on both sides.
void draw_rimmed_path(QPainter& painter, const QPainterPath& path, const QPen& pen);

/// How large such a plate is.
QSizeF plate_size(const QPainter& painter, const QString& text);

/// Text on a small plate, its middle left at `position`; returns the plate.
QRectF draw_plate(QPainter& painter, const QPointF& position, const QString& text, const QColor& ink,
                  const QColor& ground);

/// The hatching of the noise floor.
QBrush noise_hatching(const QColor& color);

/// The focus ring, 2 px, inside of an area.
void draw_focus(QPainter& painter, const QRectF& area);

/// "used", "waiting", "rejected", "excluded".
QString state_name(CellState state);

/// One line for the read-out: "obs 37: 6.4 sigma, rejected: ...".
QString cell_text(const ObservationCell& cell);

}  // namespace handsight::widgets
