// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/lists/whole_rows.h"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>
#include <algorithm>

namespace handsight::widgets {

void end_below_rows(QTableView* table) {
  const auto end = [table] {
    const int rows = table->horizontalHeader()->height() + table->verticalHeader()->length() + 2 * table->frameWidth();
    table->setMaximumHeight(std::max(table->minimumHeight(), rows));
  };
  QObject::connect(table->verticalHeader(), &QHeaderView::sectionResized, table, end);
  QObject::connect(table->verticalHeader(), &QHeaderView::sectionCountChanged, table, end);
  QObject::connect(table->horizontalHeader(), &QHeaderView::geometriesChanged, table, end);
}

WholeRows::WholeRows(QAbstractItemView* list, int row_height, QWidget* parent)
    : QWidget(parent), list_(list), row_height_(row_height) {
  setBackgroundRole(QPalette::Base);
  setAutoFillBackground(true);
  setFocusProxy(list);
  list->setParent(this);
  list->viewport()->installEventFilter(this);
}

QSize WholeRows::sizeHint() const { return list_->sizeHint(); }
QSize WholeRows::minimumSizeHint() const { return list_->minimumSizeHint().expandedTo(list_->minimumSize()); }

void WholeRows::resizeEvent(QResizeEvent*) { fit(); }

bool WholeRows::eventFilter(QObject* watched, QEvent* event) {
  // A scroll bar along the lower edge comes and goes.
  if (event->type() == QEvent::Resize && !is_fitting_) fit();
  return QWidget::eventFilter(watched, event);
}

void WholeRows::fit() {
  is_fitting_ = true;
  list_->setGeometry(rect());
  list_->resize(width(), height() - list_->viewport()->height() % row_height_);
  is_fitting_ = false;
}

}  // namespace handsight::widgets
