// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/stop_button.h"

#include <QPainter>

#include "widgets/base/theme.h"

namespace handsight::app {

StopButton::StopButton(QWidget* parent) : QPushButton(tr("Stop"), parent) {
  setObjectName("experiment_stop");
  setToolTip(tr("The robot stands still as soon as it can (Esc, wherever you are in the window)"));
  setAutoDefault(false);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void StopButton::paintEvent(QPaintEvent*) {
  const widgets::Colors& c = widgets::colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  // The same strong red in both themes: that of words is light in the dark one.
  const QColor red = QColor::fromHsv(c.bad.hsvHue(), 205, 185);
  const QRectF all = QRectF(rect()).adjusted(1, 1, -1, -1);
  painter.setPen(Qt::NoPen);
  painter.setBrush(!isEnabled() ? c.sunken : isDown() ? red.darker(120) : red);
  painter.drawRoundedRect(all, 6, 6);
  if (!isEnabled()) {
    painter.setPen(QPen(c.hairline, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(all, 6, 6);
  }
  const QColor ink = isEnabled() ? QColor(Qt::white) : c.ink3;
  constexpr double square = 14;
  painter.setFont(widgets::text_font(widgets::TextRole::title));
  const double words = painter.fontMetrics().horizontalAdvance(text()), left = (width() - words - square - 10) / 2;
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawRect(QRectF(left, (height() - square) / 2, square, square));
  painter.setPen(ink);
  painter.drawText(QRectF(left + square + 10, 0, words + 4, height()), Qt::AlignLeft | Qt::AlignVCenter, text());
  if (!hasFocus()) return;
  painter.setPen(QPen(c.accent, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(all, 6, 6);
}

}  // namespace handsight::app
