// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of the comparison's tables. Internal to compare.
#pragma once

#include <QTableWidgetItem>

#include "widgets/base/theme.h"

namespace handsight::app {

inline QTableWidgetItem* head_cell(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

/// Numbers stand at the right, in figures of one width.
inline QTableWidgetItem* cell(const QString& text, bool is_number, bool is_bold = false) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment((is_number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (!is_number && !is_bold) return item;
  QFont font = is_number ? widgets::number_font(widgets::TextRole::body) : item->font();
  font.setWeight(is_bold ? QFont::DemiBold : QFont::Normal);
  item->setFont(font);
  return item;
}

}  // namespace handsight::app
