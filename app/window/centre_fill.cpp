// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/centre_fill.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCursor>
#include <QHeaderView>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>

#include "widgets/images/image_view.h"
#include "widgets/lists/observation_table.h"
#include "widgets/plots/plot_widget.h"
#include "widgets/scene/robot_view.h"

namespace handsight::app {
namespace {

constexpr int title_height = 24;

bool is_view(const QWidget* w) {
  return qobject_cast<const widgets::PlotWidget*>(w) || qobject_cast<const widgets::ImageView*>(w) ||
         qobject_cast<const widgets::RobotView*>(w) || qobject_cast<const widgets::ObservationTable*>(w) ||
         qobject_cast<const QTabWidget*>(w);
}

/// What does something of its own at a double click.
bool has_use_for_it(const QWidget* w) {
  const auto* view = w->parentWidget() ? qobject_cast<const QAbstractItemView*>(w->parentWidget()) : nullptr;
  return qobject_cast<const QAbstractButton*>(w) || qobject_cast<const QLineEdit*>(w) || view;
}

}  // namespace

CentreFill::CentreFill(QWidget* centre) : QObject(centre), centre_(centre) { qApp->installEventFilter(this); }

QWidget* CentreFill::find_panel(QWidget* widget) const {
  if (!widget || !centre_->isAncestorOf(widget)) return nullptr;
  // A plot in a tab is the tab's: the outermost view below a splitter.
  QWidget* best = nullptr;
  for (QWidget* w = widget; w && w != centre_; w = w->parentWidget())
    if (is_view(w)) best = w;
  return best;
}

void CentreFill::toggle() {
  if (put_back()) return;
  QWidget* panel = find_panel(QApplication::focusWidget());
  if (!panel) panel = find_panel(QApplication::widgetAt(QCursor::pos()));
  if (panel) fill_with(panel);
}

void CentreFill::fill_with(QWidget* panel) {
  panel_ = panel;
  for (QWidget* w = panel; w->parentWidget() && w->parentWidget() != centre_; w = w->parentWidget()) {
    // A page of tabs or of a stack is alone already.
    if (qobject_cast<QStackedWidget*>(w->parentWidget())) continue;
    for (QObject* child : w->parentWidget()->children()) {
      auto* sibling = qobject_cast<QWidget*>(child);
      if (!sibling || sibling == w || sibling->isHidden() || sibling->isWindow() ||
          qobject_cast<QSplitterHandle*>(sibling))
        continue;
      sibling->hide();
      hidden_.push_back(sibling);
    }
  }
  panel->setFocus();
}

bool CentreFill::put_back() {
  if (!panel_ && hidden_.empty()) return false;
  panel_.clear();
  for (const QPointer<QWidget>& w : hidden_)
    if (w) w->show();
  hidden_.clear();
  return true;
}

bool CentreFill::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::MouseButtonDblClick) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  auto* mouse = static_cast<QMouseEvent*>(event);
  if (!widget || mouse->button() != Qt::LeftButton || has_use_for_it(widget)) return false;
  QWidget* panel = find_panel(widget);
  if (!panel) return false;
  const bool is_on_tab = qobject_cast<QTabBar*>(widget);
  if (!is_on_tab && widget->mapTo(panel, mouse->position().toPoint()).y() >= title_height) return false;
  if (!put_back()) fill_with(panel);
  return true;
}

}  // namespace handsight::app
