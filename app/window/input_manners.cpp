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
  return QObject::eventFilter(watched, event);
}

}  // namespace handsight::app
