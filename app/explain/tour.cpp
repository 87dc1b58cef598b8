// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/tour.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/base/theme.h"

namespace handsight::app {
namespace {

constexpr int wide = 320, gap = 12;

/// What can be seen of a widget that may be scrolled, in the window's coordinates.
QRect part_in_sight(const QWidget& widget, const QWidget& window) {
  QRect seen = widget.rect();
  for (const QWidget* w = &widget; w != &window && w->parentWidget(); w = w->parentWidget())
    seen = seen.translated(w->pos()).intersected(w->parentWidget()->rect());
  return seen;
}

}  // namespace

Tour::Tour(QWidget* window) : QFrame(window), ring_(new QFrame(window)) {
  setObjectName("tour");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  ring_->setObjectName("tour_ring");
  ring_->setAttribute(Qt::WA_TransparentForMouseEvents);
  ring_->setFrameShape(QFrame::Box);
  ring_->setLineWidth(3);
  ring_->hide();
  text_ = new QLabel(this);
  text_->setObjectName("tour_text");
  text_->setWordWrap(true);
  count_ = new QLabel(this);
  count_->setFont(widgets::text_font(widgets::TextRole::small));
  next_ = new QPushButton(tr("Next"), this);
  next_->setObjectName("tour_next");
  close_ = new QPushButton(tr("Leave the tour"), this);
  close_->setObjectName("tour_close");
  auto* row = new QHBoxLayout;
  row->addWidget(count_);
  row->addStretch(1);
  row->addWidget(close_);
  row->addWidget(next_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 12, 12, 8);
  layout->addWidget(text_);
  layout->addLayout(row);
  hide();
  connect(next_, &QPushButton::clicked, this, [this] { go(step_ + 1); });
  connect(close_, &QPushButton::clicked, this, &Tour::stop);
  window->installEventFilter(this);
}

void Tour::start(std::vector<TourStep> steps) {
  steps_ = std::move(steps);
  QPalette accent = ring_->palette();
  accent.setColor(QPalette::WindowText, widgets::colors().accent);
  ring_->setPalette(accent);
  go(0);
}

void Tour::stop() {
  steps_.clear();
  hide();
  ring_->hide();
  emit ended();
}

void Tour::go(int step) {
  if (step >= static_cast<int>(steps_.size())) return stop();
  step_ = step;
  const TourStep& s = steps_[static_cast<std::size_t>(step)];
  text_->setText(s.text);
  count_->setText(tr("%1 of %2").arg(step + 1).arg(steps_.size()));
  next_->setText(step + 1 == static_cast<int>(steps_.size()) ? tr("Done") : tr("Next"));
  next_->setVisible(!s.is_done);
  place();
  look();
}

void Tour::look() {
  if (steps_.empty()) return;
  const TourStep& s = steps_[static_cast<std::size_t>(step_)];
  if (s.is_done && s.is_done()) return go(step_ + 1);
  place();
}

void Tour::place() {
  if (steps_.empty()) return;
  const TourStep& s = steps_[static_cast<std::size_t>(step_)];
  QWidget* window = parentWidget();
  QWidget* target = s.target ? s.target() : nullptr;
  setFixedWidth(wide);
  setFixedHeight(layout()->heightForWidth(wide) > 0 ? layout()->heightForWidth(wide) : sizeHint().height());
  if (!target || !target->isVisible()) {
    ring_->hide();
    move((window->width() - width()) / 2, (window->height() - height()) / 2);
  } else {
    const QRect at = part_in_sight(*target, *window);
    ring_->setGeometry(at.adjusted(-3, -3, 3, 3).intersected(window->rect()));
    ring_->show();
    ring_->raise();
    // Beside the target, where there is room: right, left, below, above, in this order.
    QPoint spot(at.right() + gap, at.top());
    if (spot.x() + width() > window->width()) spot = QPoint(at.left() - gap - width(), at.top());
    if (spot.x() < 0) spot = QPoint(at.left(), at.bottom() + gap);
    if (spot.y() + height() > window->height()) spot.setY(std::max(0, window->height() - height() - gap));
    if (QRect(spot, size()).intersects(at)) spot.setY(std::max(0, at.top() - gap - height()));
    move(std::clamp(spot.x(), 0, std::max(0, window->width() - width())), std::max(0, spot.y()));
  }
  show();
  raise();
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && !steps_.empty()) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace handsight::app
