// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/what_if_slider.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/base/number_text.h"
#include "widgets/base/theme.h"
#include "widgets/explain/what_if_track.h"

namespace handsight::widgets {
namespace {

/// A box whose wheel changes nothing while it has no focus.
class QuietBox : public QComboBox {
 public:
  explicit QuietBox(QWidget* parent) : QComboBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setFixedHeight(control_height);
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
  }

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      QComboBox::wheelEvent(event);
    else
      event->ignore();
  }
};

void fill(QComboBox& box, const std::vector<QString>& names, int current) {
  box.clear();
  for (const QString& name : names) box.addItem(name);
  box.setCurrentIndex(current);
  box.setVisible(names.size() > 1);
}

}  // namespace

WhatIfSlider::WhatIfSlider(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(layout_gap, 4, layout_gap, 4);
  layout->setSpacing(4);
  auto* head = new QHBoxLayout;
  head->setSpacing(layout_gap);
  title_ = new QLabel(this);
  title_->setFont(text_font(TextRole::title));
  title_->setWordWrap(true);  // a long name must not widen the window
  places_ = new QuietBox(this);
  places_->setAccessibleName(tr("Where it sits"));
  parameters_ = new QuietBox(this);
  parameters_->setAccessibleName(tr("Which number"));
  close_ = new QPushButton(tr("Close"), this);
  close_->setFixedHeight(control_height);
  head->addWidget(title_, 1);
  head->addWidget(places_);
  head->addWidget(parameters_);
  head->addWidget(close_);
  layout->addLayout(head);
  auto* row = new QHBoxLayout;
  row->setSpacing(layout_gap);
  track_ = new WhatIfTrack(this);
  value_ = new QLabel(this);
  value_->setFont(number_font(TextRole::title));
  value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  best_ = new QPushButton(tr("Best"), this);
  best_->setFixedHeight(control_height);
  best_->setToolTip(tr("To the size that fits best (B, or a double click on the track)"));
  row->addWidget(track_, 1);
  row->addWidget(value_);
  row->addWidget(best_);
  layout->addLayout(row);
  answer_ = new QLabel(this);
  answer_->setWordWrap(true);
  layout->addWidget(answer_);
  connect(track_, &WhatIfTrack::moved, this, [this](double value) { take(value, false); });
  connect(track_, &WhatIfTrack::released, this, [this](double value) { take(value, true); });
  connect(best_, &QPushButton::clicked, this, [this] {
    if (const auto& best = track_->parameter().best) {
      track_->set_value(*best);
      take(*best, false);
      take(*best, true);
    }
  });
  connect(close_, &QPushButton::clicked, this, &WhatIfSlider::closed);
  connect(places_, &QComboBox::currentIndexChanged, this, [this](int place) {
    if (is_filling_ || place < 0) return;
    state_.place = place;
    emit place_chosen(place);
  });
  connect(parameters_, &QComboBox::currentIndexChanged, this, [this](int parameter) {
    if (is_filling_ || parameter < 0) return;
    state_.parameter = parameter;
    refresh();
    emit parameter_chosen(parameter);
  });
  refresh();
}

void WhatIfSlider::set_state(WhatIfState state) {
  state_ = std::move(state);
  is_filling_ = true;
  fill(*places_, state_.places, state_.place);
  std::vector<QString> names;
  for (const WhatIfParameter& parameter : state_.parameters) names.push_back(parameter.name);
  fill(*parameters_, names, state_.parameter);
  is_filling_ = false;
  refresh();
}

void WhatIfSlider::refresh() {
  title_->setText(tr("What if: %1").arg(state_.title));
  const auto at = static_cast<std::size_t>(state_.parameter);
  const bool has_parameter = at < state_.parameters.size();
  track_->setEnabled(has_parameter);
  if (has_parameter) track_->set_parameter(state_.parameters[at]);
  best_->setEnabled(has_parameter && state_.parameters[at].best.has_value());
  value_->setMinimumWidth(QFontMetrics(value_->font()).horizontalAdvance(QStringLiteral("−888 µrad/(N m)")));
  value_->setText(has_parameter ? with_unit_text(value(), state_.parameters[at].unit, 3) : QStringLiteral("-"));
  set_answer(state_.answer);
}

void WhatIfSlider::set_answer(const QString& sentence) {
  state_.answer = sentence;
  answer_->setText(sentence);
}

void WhatIfSlider::set_value(double value) {
  const auto at = static_cast<std::size_t>(state_.parameter);
  if (at >= state_.parameters.size()) return;
  track_->set_value(value);
  state_.parameters[at].value = track_->parameter().value;
  value_->setText(with_unit_text(this->value(), state_.parameters[at].unit, 3));
}

double WhatIfSlider::value() const {
  const auto at = static_cast<std::size_t>(state_.parameter);
  return at < state_.parameters.size() ? state_.parameters[at].value : 0;
}

void WhatIfSlider::take(double value, bool is_final) {
  set_value(value);
  if (is_final)
    emit settled(this->value());
  else
    emit changed(this->value());
}

void WhatIfSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape)
    emit closed();
  else
    QWidget::keyPressEvent(event);
}

void WhatIfSlider::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && track_) track_->update();
  QWidget::changeEvent(event);
}

}  // namespace handsight::widgets
