// SPDX-License-Identifier: GPL-3.0-or-later
// Wrapped text of at most so many lines, and lists whose rows are as high as their texts. Internal to widgets/explain.
#pragma once

#include <QFont>
#include <QListView>
#include <QPainter>
#include <QString>

namespace handsight::widgets {

/// Height that the text takes at that width, at most `most_lines` lines; 0 for an empty text.
double lines_height(const QFont& font, const QString& text, double width, int most_lines);

/// Whether so many lines of that width do not hold it.
bool is_shortened(const QFont& font, const QString& text, double width, int most_lines);

/// Draws it from the top of the area in the painter's pen; what does not fit is shortened with "...".
void draw_lines(QPainter& painter, const QFont& font, const QRectF& area, const QString& text, int most_lines);

/// Rows are laid out anew, and the current one is in sight, whenever the list is shown or has another size: heights of
/// rows that were found at another width would leave it scrolled to nowhere.
void lay_rows_out_again(QListView* list);

}  // namespace handsight::widgets
