// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/key_list.h"

#include <QKeyEvent>
#include <QPainter>

#include "widgets/base/theme.h"

namespace handsight::app {
KeyList::KeyList(QWidget* window) : QWidget(window) {
  setObjectName("key_list");
  setAttribute(Qt::WA_DeleteOnClose);
  setGeometry(window->rect());
  setFocusPolicy(Qt::StrongFocus);
}

void KeyList::show_over(QWidget* window, std::vector<Actions::Row> rows) {
  if (window->findChild<KeyList*>()) return;
  auto* list = new KeyList(window);
  list->rows_ = std::move(rows);
  list->show();
  list->raise();
  list->setFocus();
}

/// Where the second column begins: at a heading, so that both are about as long.
std::size_t KeyList::second_column() const {
  for (std::size_t i = rows_.size() / 2; i < rows_.size(); ++i)
    if (rows_[i].is_heading()) return i;
  return rows_.size();
}

void KeyList::paintEvent(QPaintEvent*) {
  using widgets::TextRole;
  const auto& c = widgets::colors();
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  QColor veil = c.window;
  veil.setAlpha(200);
  p.fillRect(rect(), veil);
  constexpr int row_height = 26, margin = 24, keys_width = 190;
  const std::size_t split = second_column();
  const int longest = static_cast<int>(std::max(split, rows_.size() - split));
  const int wide = std::min(1120, width() - 16), column = (wide - 3 * margin) / 2;
  const int tall = longest * row_height + 2 * margin;
  const QRect sheet((width() - wide) / 2, std::max(8, (height() - tall) / 2), wide, tall);
  p.setPen(c.hairline);
  p.setBrush(c.panel);
  p.drawRoundedRect(sheet, 6, 6);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Actions::Row& row = rows_[i];
    const int left = sheet.left() + margin + (i < split ? 0 : column + margin);
    const int y = sheet.top() + margin + static_cast<int>(i < split ? i : i - split) * row_height;
    p.setFont(widgets::text_font(row.is_heading() ? TextRole::title : TextRole::body));
    p.setPen(c.ink1);
    p.drawText(QRect(left, y, row.is_heading() ? column : keys_width - 8, row_height), Qt::AlignVCenter, row.keys);
    if (row.is_heading()) continue;
    p.setPen(c.ink2);
    const QRect room(left + keys_width, y, column - keys_width, row_height);
    const QString what = row.what.left(1).toUpper() + row.what.mid(1);  // actions begin large, what is explained small
    p.drawText(room, Qt::AlignVCenter, p.fontMetrics().elidedText(what, Qt::ElideRight, room.width()));
  }
}

void KeyList::mousePressEvent(QMouseEvent*) { close(); }
void KeyList::keyPressEvent(QKeyEvent*) { close(); }

}  // namespace handsight::app
