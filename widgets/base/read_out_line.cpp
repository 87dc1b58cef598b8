// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/read_out_line.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>

#include "widgets/base/theme.h"

namespace handsight::widgets {
namespace {

constexpr int message_time = 6000;  // ms

QLabel* quiet_label(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(text_font(TextRole::small));
  label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

QToolButton* text_button(const QString& text, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setAutoRaise(true);
  button->setFont(text_font(TextRole::small));
  button->setFixedHeight(row_height_px);
  return button;
}

}  // namespace

ReadOutLine::ReadOutLine(QWidget* parent) : QWidget(parent) {
  setFixedHeight(row_height_px);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(layout_gap, 0, layout_gap, 0);
  layout->setSpacing(layout_gap);
  left_ = new QWidget(this);
  auto* crumbs = new QHBoxLayout(left_);
  crumbs->setContentsMargins(0, 0, 0, 0);
  crumbs->setSpacing(2);
  right_ = new QLabel(this);
  right_->setFont(text_font(TextRole::small));
  right_->setMinimumWidth(40);
  right_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  right_->setTextFormat(Qt::PlainText);
  right_->installEventFilter(this);
  layout->addWidget(left_, 0);
  layout->addSpacing(wide_gap);
  layout->addWidget(right_, 1);
  timer_ = new QTimer(this);
  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, &ReadOutLine::show_right);
  rebuild();
}

void ReadOutLine::add_at_end(QWidget* widget) { layout()->addWidget(widget); }

QSize ReadOutLine::sizeHint() const { return {800, row_height_px}; }

void ReadOutLine::set_crumbs(const QStringList& crumbs) {
  if (crumbs == crumbs_) return;
  crumbs_ = crumbs;
  rebuild();
}

void ReadOutLine::set_pointer(const QString& text) {
  if (text == pointer_) return;
  pointer_ = text;
  show_right();
}

QString ReadOutLine::pointer_text() const { return reported_; }

void ReadOutLine::show_message(const QString& sentence) {
  message_ = sentence;
  timer_->start(message_time);
  show_right();
}

void ReadOutLine::show_right() {
  // A message keeps the slot for its time; afterwards it gives way as soon as the pointer says something.
  const bool is_message = !message_.isEmpty() && (timer_->isActive() || pointer_.isEmpty());
  if (!is_message) message_.clear();
  reported_ = is_message ? message_ : pointer_.isEmpty() ? QString() : QObject::tr("Pointer: ") + pointer_;
  elide_right();
}

/// What does not fit ends in an ellipsis; the tool tip has it whole.
void ReadOutLine::elide_right() {
  right_->setText(right_->fontMetrics().elidedText(reported_, Qt::ElideRight, right_->width()));
  right_->setToolTip(reported_);
}

bool ReadOutLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == right_ && event->type() == QEvent::Resize) elide_right();
  return QWidget::eventFilter(watched, event);
}

void ReadOutLine::rebuild() {
  QLayout* layout = left_->layout();
  while (QLayoutItem* item = layout->takeAt(0)) {
    // A crumb's own click may be what led here: it must outlive its signal.
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  if (crumbs_.isEmpty()) {
    layout->addWidget(quiet_label(QObject::tr("Nothing selected"), left_));
    return;
  }
  layout->addWidget(quiet_label(QObject::tr("Selected:"), left_));
  for (int i = 0; i < crumbs_.size(); ++i) {
    if (i > 0) layout->addWidget(quiet_label(QStringLiteral("›"), left_));
    QToolButton* crumb = text_button(crumbs_[i], left_);
    crumb->setObjectName(QStringLiteral("crumb_%1").arg(i));
    connect(crumb, &QToolButton::clicked, this, [this, i] { emit crumb_clicked(i); });
    layout->addWidget(crumb);
  }
}

void ReadOutLine::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) rebuild();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
