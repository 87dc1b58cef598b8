// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/explain/candidate_card.h"

#include <QApplication>
#include <QCursor>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <array>

#include "widgets/base/number_text.h"
#include "widgets/base/paint_tools.h"
#include "widgets/base/theme.h"
#include "widgets/base/tool_tip.h"
#include "widgets/explain/candidate_layout.h"
#include "widgets/explain/main_button.h"

namespace handsight::widgets {

CandidateCard::CandidateCard(QWidget* parent) : QFrame(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMinimumWidth(320);
  setMouseTracking(true);  // see resting_pointer_
  const auto button = [this](const QString& name, auto&& signal) {
    auto* made = new FilledButton(this);
    made->setObjectName(name);
    made->setFixedHeight(control_height);
    made->setAutoDefault(true);  // Enter presses it
    made->setMouseTracking(true);
    made->installEventFilter(this);
    connect(made, &QPushButton::clicked, this, signal);
    return made;
  };
  add_ = button(QStringLiteral("add"), [this] { emit add(state_.id); });
  what_if_ = button(QStringLiteral("what_if"), [this] { emit what_if(state_.id); });
  poses_ = button(QStringLiteral("poses"), [this] { emit show_poses(state_.id); });
  action_ = button(QStringLiteral("action"), [this] { emit action(state_.action_id); });
  add_->setText(tr("Add"));
  what_if_->setText(tr("What if"));
  poses_->setText(tr("Poses that would tell"));
  measured_ = new QLineEdit(this);
  measured_->setObjectName(QStringLiteral("measured"));
  measured_->setFont(number_font(TextRole::body));
  measured_->setAlignment(Qt::AlignRight);
  measured_->setAccessibleName(tr("Measured on the robot"));
  measured_->setToolTip(tr("What the real robot shows, with what it may be off by: 1.3 ± 0.1"));
  measured_->installEventFilter(this);
  measured_->setMouseTracking(true);
  connect(measured_, &QLineEdit::editingFinished, this, &CandidateCard::take_measured);
  connect(measured_, &QLineEdit::textEdited, this, [this] {
    if (state_.check_number) state_.check_number->answer.clear();
    update();
  });
}

void CandidateCard::set_state(CardState state) {
  const std::optional<CardCheck> before = std::exchange(state_, std::move(state)).check_number;
  const bool is_candidate = state_.kind == CardKind::candidate;
  add_->setVisible(is_candidate);
  add_->setEnabled(state_.can_add);
  add_->setToolTip(state_.can_add ? tr("Adds it to the model and fits (Enter)") : state_.why_not);
  what_if_->setVisible(is_candidate && state_.can_what_if);
  poses_->setVisible(is_candidate && state_.can_show_poses);
  action_->setVisible(!is_candidate && !state_.action.isEmpty());
  action_->setText(state_.action);
  setAccessibleName(state_.where.isEmpty() ? state_.title : tr("%1 of %2").arg(state_.title, state_.where));
  QString description = state_.words;
  if (is_candidate) description += QLatin1Char(' ') + error_left_text(state_.error);
  if (state_.check_number) description += QLatin1Char(' ') + state_.check_number->prediction;
  setAccessibleDescription(description);
  show_check(before);
  place_buttons();
  update();
}

void CandidateCard::show_check(const std::optional<CardCheck>& before) {
  measured_->setVisible(state_.kind == CardKind::candidate && state_.check_number.has_value());
  if (!state_.check_number) return measured_->clear();
  CardCheck& check = *state_.check_number;
  // What is being typed is not overwritten by news of something else.
  if (before && measured_->isModified() && before->measured == check.measured) {
    check.answer = before->answer;
    check.is_inside = before->is_inside;
    return;
  }
  measured_->setText(check.measured);
}

void CandidateCard::take_measured() {
  if (!measured_->isModified()) return;
  measured_->setModified(false);
  emit measured(state_.id, measured_->text());
}

void CandidateCard::set_measured_note(const QString& sentence) {
  if (!state_.check_number) return;
  state_.check_number->answer = sentence;
  state_.check_number->is_inside = false;
  measured_->setModified(true);  // it is still to be taken
  update();
}

void CandidateCard::set_main(bool is_main) {
  is_main_ = is_main;
  add_->setPalette(QApplication::palette());  // the filled one stands below the cards
  fill_button(*action_, is_main);
  update();
}

void CandidateCard::set_previewed(bool previewed) {
  if (previewed == is_previewed_) return;
  is_previewed_ = previewed;
  update();
}

QSize CandidateCard::sizeHint() const { return {464, heightForWidth(464)}; }

int CandidateCard::heightForWidth(int width) const { return static_cast<int>(lay_out(state_, width).height); }

void CandidateCard::place_buttons() {
  const CardLayout layout = lay_out(state_, width());
  if (height() != static_cast<int>(layout.height)) setFixedHeight(static_cast<int>(layout.height));
  measured_->setGeometry(layout.field.toRect());
  const std::array<QPushButton*, 4> buttons = {add_, action_, what_if_, poses_};
  const auto wide = [](const QPushButton* button) {
    return std::max(QFontMetrics(button->font()).horizontalAdvance(button->text()) + 28, 72);
  };
  int total = -layout_gap;
  for (const QPushButton* button : buttons) total += button->isHidden() ? 0 : wide(button) + layout_gap;
  const bool is_narrow = total > layout.buttons.width();  // then from below the drawing on
  int x = static_cast<int>(is_narrow ? layout.drawing.left() : layout.buttons.left());
  for (QPushButton* button : buttons) {
    if (button->isHidden()) continue;
    button->setGeometry(x, static_cast<int>(layout.buttons.top()), wide(button), control_height);
    x += wide(button) + layout_gap;
  }
}

void CandidateCard::paintEvent(QPaintEvent*) {
  const Colors& c = colors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(QPen(c.hairline, 1));
  painter.setBrush(c.panel);
  painter.drawRoundedRect(frame, 4, 4);
  if (is_previewed_ || (is_attended_ && state_.kind == CardKind::candidate)) {
    QPen pen(c.candidate, 2);
    pen.setDashPattern({4, 3});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(frame.adjusted(1, 1, -1, -1), 4, 4);
  }
  paint_card(painter, state_, lay_out(state_, width()));
  if (hasFocus()) draw_focus(painter, rect());
}

void CandidateCard::look_at_attention() {
  const QWidget* focus = QApplication::focusWidget();
  const bool has_focus = focus == this || isAncestorOf(focus);
  const bool is_attended = is_hovered_ || has_focus;
  update();
  if (is_attended == is_attended_) return;
  is_attended_ = is_attended;
  if (state_.kind != CardKind::candidate) return;
  if (is_attended)
    emit preview(state_.id);
  else
    emit preview_ended(state_.id);
}

// The pointer enters also where a dialog or a menu closes over the card, or the window comes to the front: only one
// that moves points at something.
void CandidateCard::pointed_at(const QMouseEvent& move) {
  if (move.globalPosition().toPoint() != resting_pointer_) is_hovered_ = true;
  look_at_attention();
}

void CandidateCard::mouseMoveEvent(QMouseEvent* event) {
  pointed_at(*event);
  QFrame::mouseMoveEvent(event);
}

// A pointer that rests while cards come, go and change their places points at none of them.
void CandidateCard::showEvent(QShowEvent* event) {
  resting_pointer_ = QCursor::pos();
  QFrame::showEvent(event);
}

void CandidateCard::moveEvent(QMoveEvent* event) {
  resting_pointer_ = QCursor::pos();
  if (is_hovered_ && !rect().contains(mapFromGlobal(*resting_pointer_))) {
    is_hovered_ = false;
    look_at_attention();
  }
  QFrame::moveEvent(event);
}

void CandidateCard::leaveEvent(QEvent* event) {
  is_hovered_ = false;
  look_at_attention();
  QFrame::leaveEvent(event);
}

// The focus may go from the card to its own button: only afterwards is it known where it has gone.
void CandidateCard::focusInEvent(QFocusEvent* event) {
  QFrame::focusInEvent(event);
  QMetaObject::invokeMethod(this, &CandidateCard::look_at_attention, Qt::QueuedConnection);
}

void CandidateCard::focusOutEvent(QFocusEvent* event) {
  QFrame::focusOutEvent(event);
  QMetaObject::invokeMethod(this, &CandidateCard::look_at_attention, Qt::QueuedConnection);
}

bool CandidateCard::eventFilter(QObject* watched, QEvent* event) {
  if (watched == measured_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {  // takes the number, and does not add the candidate
      setFocus(Qt::OtherFocusReason);                     // which takes what was typed; and undo is the window's again
      return true;
    }
  }
  if (event->type() == QEvent::MouseMove) pointed_at(*static_cast<QMouseEvent*>(event));
  if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
    QMetaObject::invokeMethod(this, &CandidateCard::look_at_attention, Qt::QueuedConnection);
  return QFrame::eventFilter(watched, event);
}

void CandidateCard::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  place_buttons();
}

void CandidateCard::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  QFrame::mousePressEvent(event);
}

void CandidateCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) return QFrame::keyPressEvent(event);
  if (state_.kind == CardKind::candidate && state_.can_add)
    emit add(state_.id);
  else if (state_.kind != CardKind::candidate && !state_.action.isEmpty())
    emit action(state_.action_id);
}

bool CandidateCard::event(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && action_) set_main(is_main_);
  if (event->type() != QEvent::ToolTip) return QFrame::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const CardTip tip = card_tip(state_, lay_out(state_, width()), help->pos());
  show_tip(this, *help, tip.area.toAlignedRect(), tip.text);
  return true;
}

}  // namespace handsight::widgets
