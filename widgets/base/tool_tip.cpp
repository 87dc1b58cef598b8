// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/tool_tip.h"

#include <QApplication>
#include <QFontMetrics>
#include <QHelpEvent>
#include <QScreen>
#include <QToolTip>
#include <QWidget>
#include <algorithm>

namespace handsight::widgets {
namespace {

constexpr int gap = 4, of_pointer = 20, large = 120;  // px

QWidget* tip_label() {
  for (QWidget* top : QApplication::topLevelWidgets())
    if (top->inherits("QTipLabel") && top->isVisible()) return top;
  return nullptr;
}

/// What of the area is explained: all of it, or where the pointer is.
QRect explained(const QRect& area, const QPoint& pointer) {
  return area.height() <= large ? area : QRect(pointer - QPoint(4, 4), QSize(8, of_pointer));
}

}  // namespace

QString wrapped_tip(const QString& text) {
  const QFontMetrics metrics(QToolTip::font());
  QStringList lines;
  for (const QString& paragraph : text.split('\n')) {
    QString line;
    for (const QString& word : paragraph.split(' ')) {
      const QString longer = line.isEmpty() ? word : line + ' ' + word;
      if (!line.isEmpty() && metrics.horizontalAdvance(longer) > tip_width) {
        lines << line;
        line = word;
      } else {
        line = longer;
      }
    }
    lines << line;
  }
  return lines.join('\n');
}

QRect place_of_tip(const QSize& tip, const QRect& area, const QRect& screen) {
  const int most_left = std::max(screen.left(), screen.right() - tip.width());
  int top = area.bottom() + gap;
  if (top + tip.height() > screen.bottom()) top = std::max(screen.top(), area.top() - gap - tip.height());
  return {QPoint(std::clamp(area.left(), screen.left(), most_left), top), tip};
}

void show_tip(QWidget* widget, const QHelpEvent& help, const QRect& area, const QString& text) {
  if (text.isEmpty()) return QToolTip::hideText();
  const QRect on_screen(widget->mapToGlobal(area.topLeft()), area.size());
  QToolTip::showText(help.globalPos(), wrapped_tip(text), widget, area);
  const QScreen* screen = widget->screen();
  QWidget* const tip = tip_label();
  if (tip && screen)
    tip->move(place_of_tip(tip->size(), explained(on_screen, help.globalPos()), screen->geometry()).topLeft());
}

}  // namespace handsight::widgets
