// SPDX-License-Identifier: GPL-3.0-or-later
// Tool tips that can be read: wrapped, and beside what they explain instead of over it.
#pragma once

#include <QRect>
#include <QString>

class QHelpEvent;
class QWidget;

namespace handsight::widgets {

constexpr int tip_width = 420;  // px, the widest line

/// In lines of at most tip_width in the font of tool tips.
QString wrapped_tip(const QString& text);

/// Shows it below what it explains, an area of the widget; above where there is no room. Of a large area (a plot) it
/// explains the point that was asked for. An empty text hides what is shown.
void show_tip(QWidget* widget, const QHelpEvent& help, const QRect& area, const QString& text);

/// Where a tip of this size stands on a screen.
QRect place_of_tip(const QSize& tip, const QRect& area, const QRect& screen);

}  // namespace handsight::widgets
