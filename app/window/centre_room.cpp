// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/centre_room.h"

#include <QEvent>
#include <QLayout>
#include <QScrollBar>
#include <QStackedWidget>

namespace handsight::app {
namespace {

/// What a page needs at least at this width: words that wrap need more height where there is less of it.
QSize least_size(const QWidget& page, int width) {
  QSize least = page.minimumSizeHint().expandedTo(page.minimumSize());
  const QLayout* layout = page.layout();
  if (layout && layout->hasHeightForWidth())
    least.setHeight(std::max(least.height(), layout->minimumHeightForWidth(std::max(width, least.width()))));
  return least;
}

}  // namespace

CentreRoom::CentreRoom(QStackedWidget* pages, QWidget* parent) : QScrollArea(parent), pages_(pages) {
  setObjectName("centre_room");
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setWidget(pages);  // sized by fit(): the scroll area's own way asks all pages at once
  pages->installEventFilter(this);
  connect(pages, &QStackedWidget::currentChanged, this, &CentreRoom::fit);
}

void CentreRoom::fit() {
  const QWidget* page = pages_->currentWidget();
  if (!page || is_fitting_) return;
  is_fitting_ = true;
  const QSize all = maximumViewportSize();
  QSize least = least_size(*page, all.width());
  // A bar takes room from the other direction.
  const int bar = verticalScrollBar()->sizeHint().width();
  const bool is_high = least.height() > all.height() - (least.width() > all.width() ? bar : 0);
  const int width = all.width() - (is_high ? bar : 0);
  if (is_high) least = least_size(*page, width);
  const int height = all.height() - (least.width() > width ? bar : 0);
  pages_->resize(std::max(width, least.width()), std::max(height, least.height()));
  is_fitting_ = false;
}

bool CentreRoom::eventFilter(QObject* watched, QEvent* event) {
  if (watched == pages_ && event->type() == QEvent::LayoutRequest)
    QMetaObject::invokeMethod(this, &CentreRoom::fit, Qt::QueuedConnection);
  return QScrollArea::eventFilter(watched, event);
}

void CentreRoom::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

}  // namespace handsight::app
