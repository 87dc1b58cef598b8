// SPDX-License-Identifier: GPL-3.0-or-later
// The window's icons: one family of line drawings (resources/icons), in the ink of the theme in force.
#pragma once

#include <QIcon>
#include <QPainter>

#include "widgets/base/theme.h"

namespace handsight::widgets {

/// By the name of its file: "play". Follows the theme, and is paler where what it stands on is disabled. An unknown
/// name gives an icon that paints nothing.
QIcon icon(const QString& name);

/// The same drawn into an area, in this ink.
void draw_icon(QPainter& painter, const QRectF& area, const QString& name, const QColor& ink);

/// A picture of resources/pictures by the name of its file, on the ground of that theme, at twice the size at which it
/// is shown; null where there is none.
QPixmap drawn_picture(const QString& name, ThemeKind theme);

/// Is there an icon of this name?
bool has_icon(const QString& name);

}  // namespace handsight::widgets
