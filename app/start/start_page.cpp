// SPDX-License-Identifier: GPL-3.0-or-later
#include "start/start_page.h"

#include <QAbstractButton>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "start/session_places.h"
#include "widgets/theme.h"

namespace handsight::app {
namespace {

using widgets::colors;
using widgets::TextRole;

/// A row to click: a title and a sentence under it.
class PlaceButton : public QAbstractButton {
 public:
  PlaceButton(const QString& title, const QString& sentence, QWidget* parent)
      : QAbstractButton(parent), sentence_(sentence) {
    setText(title);
    setAccessibleName(title);
    setAccessibleDescription(sentence);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  QSize sizeHint() const override { return {560, 56}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const auto& c = colors();
    p.setPen(QPen(hasFocus() ? c.accent : c.hairline, hasFocus() ? 2 : 1));
    p.setBrush(underMouse() || isDown() ? c.selected_row : c.panel);
    p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    p.setPen(c.ink1);
    QFont title = widgets::text_font(TextRole::body);
    title.setWeight(QFont::DemiBold);
    p.setFont(title);
    p.drawText(QRectF(16, 7, width() - 32, 20), Qt::AlignVCenter, text());
    p.setFont(widgets::text_font(TextRole::small));
    p.setPen(c.ink2);
    p.drawText(QRectF(16, 28, width() - 32, 20), Qt::AlignVCenter,
               p.fontMetrics().elidedText(sentence_, Qt::ElideMiddle, width() - 32));
  }

 private:
  QString sentence_;
};

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(widgets::text_font(TextRole::title));
  return label;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QScrollArea(parent) {
  setObjectName("start_page");
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  content_ = nullptr;
  list_ = nullptr;
  refusal_ = nullptr;
  refresh();
}

void StartPage::changeEvent(QEvent* event) { QScrollArea::changeEvent(event); }

void StartPage::set_refusal(const QString& sentence) {
  refusal_->setText(sentence);
  refusal_->setVisible(!sentence.isEmpty());
}

void StartPage::refresh() {
  content_ = new QWidget(this);
  auto* outer = new QHBoxLayout(content_);
  auto* column = new QWidget(content_);
  column->setMaximumWidth(640);
  outer->addStretch(1);
  outer->addWidget(column, 100);
  outer->addStretch(1);
  list_ = new QVBoxLayout(column);
  list_->setContentsMargins(24, 48, 24, 48);
  list_->setSpacing(8);
  auto* name = new QLabel(tr("Handsight"), column);
  name->setFont(widgets::text_font(TextRole::number));
  list_->addWidget(name);
  auto* lead = new QLabel(tr("Open a session, make one from your images, or try one of these."), column);
  lead->setWordWrap(true);
  list_->addWidget(lead);
  list_->addSpacing(8);

  auto* buttons = new QHBoxLayout;
  auto* open = new QPushButton(tr("Open a session…"), column);
  open->setObjectName("start_open");
  open->setDefault(true);
  auto* make = new QPushButton(tr("New session from images…"), column);
  make->setObjectName("start_new");
  for (QPushButton* b : {open, make}) {
    b->setMinimumSize(b->sizeHint().width() + 32, 36);
    buttons->addWidget(b);
  }
  buttons->addStretch(1);
  list_->addLayout(buttons);
  connect(open, &QPushButton::clicked, this, &StartPage::open_requested);
  connect(make, &QPushButton::clicked, this, &StartPage::new_requested);
  refusal_ = new QLabel(column);
  refusal_->setObjectName("start_refusal");
  refusal_->setWordWrap(true);
  refusal_->setContentsMargins(12, 8, 12, 8);
  refusal_->setAutoFillBackground(true);
  QPalette tinted = refusal_->palette();
  tinted.setColor(QPalette::Window, colors().bad_tint);
  tinted.setColor(QPalette::WindowText, colors().ink1);
  refusal_->setPalette(tinted);
  refusal_->hide();
  list_->addWidget(refusal_);

  const auto recent = recent_sessions();
  if (!recent.empty()) {
    list_->addSpacing(16);
    list_->addWidget(heading(tr("Recent sessions"), column));
    for (std::size_t i = 0; i < recent.size() && i < 5; ++i) {
      const QString path = QString::fromStdString(recent[i].file.string());
      auto* row = new PlaceButton(recent[i].title, path, column);
      row->setObjectName("recent_" + QString::number(i));
      connect(row, &QAbstractButton::clicked, this, [this, path] { emit session_chosen(path); });
      list_->addWidget(row);
    }
  }
  const auto samples = sample_sessions();
  if (!samples.empty()) {
    list_->addSpacing(16);
    list_->addWidget(heading(tr("Sample sessions"), column));
    for (const SampleSession& sample : samples) {
      auto* row = new PlaceButton(sample.title, sample.sentence, column);
      const QString id = QString::fromStdString(sample.name);
      row->setObjectName("sample_" + id);
      connect(row, &QAbstractButton::clicked, this, [this, id] { emit sample_chosen(id); });
      list_->addWidget(row);
    }
  }
  list_->addStretch(1);
  setWidget(content_);
}

}  // namespace handsight::app
