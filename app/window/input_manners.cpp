// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/input_manners.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSlider>
#include <QTextDocument>
#include <QToolTip>

namespace handsight::app {
namespace {

/// Would the field do nothing with this key but keep it?
bool swallows(const QObject* watched, const QKeyEvent& key) {
  const bool is_undo = key.matches(QKeySequence::Undo);
  const bool is_redo = key.matches(QKeySequence::Redo);
  if (!is_undo && !is_redo) return false;
  if (const auto* line = qobject_cast<const QLineEdit*>(watched))
    return line->isReadOnly() || (is_undo ? !line->isUndoAvailable() : !line->isRedoAvailable());
  if (const auto* text = qobject_cast<const QPlainTextEdit*>(watched))
    return text->isReadOnly() ||
           (is_undo ? !text->document()->isUndoAvailable() : !text->document()->isRedoAvailable());
  return false;
}

bool turns_by_wheel(const QObject* watched) {
  return qobject_cast<const QComboBox*>(watched) || qobject_cast<const QAbstractSpinBox*>(watched) ||
         qobject_cast<const QSlider*>(watched);
}

/// A long tool tip in several lines, below what it explains and not over it. Widgets that tell by themselves what is
/// under the pointer have no tip of their own.
bool shows_wrapped_tip(const QObject* watched) {
  constexpr int long_line = 60;  // letters
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (!widget || widget->toolTip().size() <= long_line || Qt::mightBeRichText(widget->toolTip())) return false;
  const QString lines = widget->toolTip().toHtmlEscaped().replace('\n', "<br/>");
  QToolTip::showText(widget->mapToGlobal(QPoint(0, widget->height() + 2)), "<qt>" + lines + "</qt>",
                     const_cast<QWidget*>(widget), widget->rect());
  return true;
}

}  // namespace

InputManners::InputManners(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool InputManners::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && swallows(watched, *static_cast<QKeyEvent*>(event))) {
    event->ignore();
    return true;
  }
  if (event->type() == QEvent::Wheel && turns_by_wheel(watched) && !static_cast<QWidget*>(watched)->hasFocus()) {
    event->ignore();  // it goes on to what it stands in
    return true;
  }
  if (event->type() == QEvent::ToolTip && shows_wrapped_tip(watched)) return true;
  return QObject::eventFilter(watched, event);
}

}  // namespace handsight::app
