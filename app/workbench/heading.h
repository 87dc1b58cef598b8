// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "widgets/base/theme.h"

namespace handsight::app {

/// A label in the letters of titles.
inline QLabel* heading(const QString& text, QWidget* parent = nullptr) {
  auto* label = new QLabel(text, parent);
  label->setFont(widgets::text_font(widgets::TextRole::title));
  return label;
}

}  // namespace handsight::app
