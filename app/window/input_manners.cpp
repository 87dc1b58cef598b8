// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/input_manners.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>
#include <QTableView>
#include <QTextDocument>

#include "widgets/base/tool_tip.h"

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

/// Has the widget nothing that is moved to the left and to the right? Boxes and rows are chosen from by up and down,
/// and Tab goes from button to button; of a group of buttons one is chosen by the arrows, as everywhere.
bool leaves_left_and_right(const QObject* watched, const QKeyEvent& key) {
  if (key.key() != Qt::Key_Left && key.key() != Qt::Key_Right) return false;
  if (key.modifiers() != Qt::NoModifier && key.modifiers() != Qt::KeypadModifier) return false;
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (!widget || !qobject_cast<const QMainWindow*>(widget->window())) return false;
  if (const auto* box = qobject_cast<const QComboBox*>(widget)) return !box->isEditable();
  if (const auto* table = qobject_cast<const QTableView*>(widget))
    return table->selectionBehavior() == QAbstractItemView::SelectRows;
  if (qobject_cast<const QScrollArea*>(widget)) return true;  // pages scroll up and down
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  return button && !button->group() && !button->autoExclusive();
}

bool turns_by_wheel(const QObject* watched) {
  return qobject_cast<const QComboBox*>(watched) || qobject_cast<const QAbstractSpinBox*>(watched) ||
         qobject_cast<const QSlider*>(watched);
}

/// A tool tip and what of the widget it explains.
struct Tip {
  QString text;
  QRect area;
  bool is_seen = false;  // it can be read there
};

/// Whether a cell shows the whole text.
bool has_room(const QAbstractItemView& view, const QRect& cell, const QString& text) {
  constexpr int rim = 6;
  const auto* table = qobject_cast<const QTableView*>(&view);
  const int wrapping = table && table->wordWrap() ? Qt::TextWordWrap : Qt::TextSingleLine;
  const QRect needed = view.fontMetrics().boundingRect(QRect(0, 0, cell.width() - rim, 1 << 14), wrapping, text);
  return needed.width() <= cell.width() - rim && needed.height() <= cell.height();
}

Tip tip_of_cell(const QAbstractItemView& view, const QPoint& at) {
  if (const auto* header = qobject_cast<const QHeaderView*>(&view)) {
    const int section = header->logicalIndexAt(at);
    if (section < 0 || !header->model()) return {};
    const int from = header->sectionViewportPosition(section), size = header->sectionSize(section);
    return {header->model()->headerData(section, header->orientation(), Qt::ToolTipRole).toString(),
            header->orientation() == Qt::Horizontal ? QRect(from, 0, size, header->height())
                                                    : QRect(0, from, header->width(), size)};
  }
  const QModelIndex index = view.indexAt(at);
  const QString text = index.data(Qt::ToolTipRole).toString();
  const QRect area = view.visualRect(index);
  return {text, area, text == index.data(Qt::DisplayRole).toString() && has_room(view, area, text)};
}

/// Whether the widget shows this text and has the room for it.
bool shows_whole(const QWidget& widget, const QString& text) {
  QString seen;
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) seen = label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) seen = button->text();
  return seen == text && widget.width() + 1 >= widget.fontMetrics().horizontalAdvance(text);
}

/// Of what Qt's own widgets explain; those that paint themselves show their own.
bool shows_tip(QObject* watched, const QHelpEvent& help) {
  auto* const widget = qobject_cast<QWidget*>(watched);
  if (!widget) return false;
  Tip tip{widget->toolTip(), widget->rect()};
  if (const auto* bar = qobject_cast<const QTabBar*>(widget); bar && bar->tabAt(help.pos()) >= 0) {
    tip = {bar->tabToolTip(bar->tabAt(help.pos())), bar->tabRect(bar->tabAt(help.pos()))};
  } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget->parentWidget());
             view && view->viewport() == widget) {
    tip = tip_of_cell(*view, help.pos());
    if (tip.text.isEmpty()) tip = {view->toolTip(), widget->rect()};
  }
  if (tip.text.isEmpty()) return false;
  widgets::show_tip(widget, help, tip.area, tip.is_seen || shows_whole(*widget, tip.text) ? QString() : tip.text);
  return true;
}

}  // namespace

InputManners::InputManners(QObject* parent) : QObject(parent) { qApp->installEventFilter(this); }

bool InputManners::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && swallows(watched, *static_cast<QKeyEvent*>(event))) {
    event->ignore();
    return true;
  }
  if (event->type() == QEvent::KeyPress && leaves_left_and_right(watched, *static_cast<QKeyEvent*>(event))) {
    event->ignore();  // it goes on to the window, which steps through the observations
    return true;
  }
  if (event->type() == QEvent::Wheel && turns_by_wheel(watched) && !static_cast<QWidget*>(watched)->hasFocus()) {
    event->ignore();  // it goes on to what it stands in
    return true;
  }
  if (event->type() == QEvent::ToolTip && shows_tip(watched, *static_cast<QHelpEvent*>(event))) return true;
  return QObject::eventFilter(watched, event);
}

}  // namespace handsight::app
