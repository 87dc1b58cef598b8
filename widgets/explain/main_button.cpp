// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/main_button.h"

#include <QApplication>
#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr int rim = 14;  // px at each side of the text

}  // namespace

void FilledButton::paintEvent(QPaintEvent* event) {
  const Colors& c = colors();
  if (!isEnabled() || palette().color(QPalette::Button) != c.accent) return QPushButton::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(isDown() ? c.accent.darker(115) : c.accent);
  painter.drawRoundedRect(QRectF(rect()), 3, 3);
  painter.setPen(c.panel);
  painter.drawText(rect(), Qt::AlignCenter, fontMetrics().elidedText(text(), Qt::ElideRight, width() - rim));
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(c.panel, 1));
  painter.drawRoundedRect(QRectF(rect()).adjusted(3, 3, -3, -3), 2, 2);
}

MainButton::MainButton(QWidget* parent) : FilledButton(parent) {
  setAutoDefault(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  fill_button(*this, true);
}

QSize MainButton::sizeHint() const { return {fontMetrics().horizontalAdvance(text()) + 2 * rim, control_height}; }

QSize MainButton::minimumSizeHint() const { return {80, control_height}; }

bool MainButton::event(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) fill_button(*this, true);
  return FilledButton::event(event);
}

void fill_button(QPushButton& button, bool is_filled) {
  const Colors& c = colors();
  QPalette inks = QApplication::palette();
  if (is_filled) {
    inks.setColor(QPalette::Button, c.accent);
    inks.setColor(QPalette::ButtonText, c.panel);
    inks.setColor(QPalette::Disabled, QPalette::Button, c.sunken);
    inks.setColor(QPalette::Disabled, QPalette::ButtonText, c.ink3);
  }
  button.setPalette(inks);
}

}  // namespace handsight::widgets
