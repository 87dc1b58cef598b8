// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/control_bar.h"

#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "experiment/drivers.h"
#include "experiment/experiment_texts.h"
#include "experiment/stop_button.h"
#include "widgets/base/theme.h"

namespace handsight::app {

ControlBar::ControlBar(ExperimentRun& run, QWidget* parent) : QWidget(parent), run_(run) {
  make_layout();
  connect(begin_, &QPushButton::clicked, this, [this] {
    if (run_.state() == RunState::asking) return emit question_wanted();
    remember_driver(command());
    fill_recent();
    emit begin_wanted();
  });
  connect(driver_->lineEdit(), &QLineEdit::returnPressed, this, [this] {
    if (begin_->isEnabled() && !run_.is_on()) begin_->click();
  });
  connect(driver_, &QComboBox::editTextChanged, this, &ControlBar::refresh);
  connect(end_, &QPushButton::clicked, this, &ControlBar::disconnect_wanted);
  connect(try_, &QPushButton::clicked, this, &ControlBar::try_wanted);
  connect(yes_, &QPushButton::clicked, this, [this] {
    is_asking_ = false;
    emit start_wanted();
    refresh();
  });
  connect(no_, &QPushButton::clicked, this, &ControlBar::take_back);
  connect(stop_, &QPushButton::clicked, &run_, &ExperimentRun::stop);
  connect(&run_, &ExperimentRun::state_changed, this, [this] {
    if (run_.state() != RunState::asking) is_asking_ = false;
    refresh();
    if (run_.state() == RunState::asking && isVisible()) begin_->setFocus();
  });
  fill_recent();
  refresh();
}

void ControlBar::make_layout() {
  driver_ = new QComboBox(this);
  driver_->setObjectName("experiment_driver");
  driver_->setAccessibleName(tr("Command of the driver"));
  driver_->setEditable(true);
  driver_->setInsertPolicy(QComboBox::NoInsert);
  driver_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  driver_->setMinimumContentsLength(20);
  driver_->lineEdit()->setPlaceholderText(tr("the command of your robot's driver: python3 my_driver.py"));
  driver_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  const auto button = [this](const char* name, const QString& text, const QString& tip) {
    auto* b = new QPushButton(text, this);
    b->setObjectName(name);
    b->setToolTip(tip);
    b->setAutoDefault(false);
    return b;
  };
  begin_ = button("experiment_begin", {}, {});
  begin_->setDefault(true);
  end_ = button("experiment_disconnect", tr("Disconnect"), tr("The driver is ended; nothing has moved"));
  try_ = button("experiment_try", tr("Try it with the simulated robot"),
                tr("A copy of this session with a few observations, and a robot that is computed: one of its joints is "
                   "a little off, and the experiment finds out which"));
  yes_ = button("experiment_yes", tr("Move the robot"), {});
  no_ = button("experiment_no", tr("Not now"), tr("Nothing moves (Esc)"));
  stop_ = new StopButton(this);
  state_box_ = new QFrame(this);
  state_box_->setAutoFillBackground(true);
  state_ = new QLabel(state_box_);
  state_->setObjectName("experiment_said");
  state_->setWordWrap(true);
  state_->setTextFormat(Qt::PlainText);
  state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  state_->setFocusPolicy(Qt::NoFocus);
  for (QWidget* w : std::initializer_list<QWidget*>{driver_, begin_, end_, try_, yes_, no_})
    w->setMinimumHeight(widgets::control_height);
  auto* label = new QLabel(tr("Driver"), this);
  label->setBuddy(driver_);
  auto* first = new QHBoxLayout;
  first->setSpacing(8);
  first->addWidget(label);
  first->addWidget(driver_, 1);
  first->addWidget(try_);
  auto* said = new QHBoxLayout(state_box_);
  said->setContentsMargins(12, 4, 8, 4);
  said->setSpacing(8);
  said->addWidget(state_, 1);
  for (QWidget* w : std::initializer_list<QWidget*>{begin_, yes_, no_, end_}) said->addWidget(w);
  auto* second = new QHBoxLayout;
  second->setSpacing(8);
  second->addWidget(state_box_, 1);
  second->addWidget(stop_);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 4, 0, 4);
  rows->setSpacing(6);
  rows->addLayout(first);
  rows->addLayout(second);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ControlBar::fill_recent() {
  const QString now = driver_->currentText();
  const QSignalBlocker quiet(driver_);
  driver_->clear();
  driver_->addItems(recent_drivers());
  driver_->setEditText(now.isEmpty() && driver_->count() > 0 ? driver_->itemText(0) : now);
  driver_->lineEdit()->setCursorPosition(0);
}

QString ControlBar::command() const { return driver_->currentText().trimmed(); }

void ControlBar::set_command(const QString& command) {
  driver_->setEditText(command);
  driver_->lineEdit()->setCursorPosition(0);
}

void ControlBar::set_hindrance(const QString& sentence) {
  hindrance_ = sentence;
  refresh();
}

void ControlBar::set_recheck(bool recheck) {
  is_recheck_ = recheck;
  refresh();
}

void ControlBar::set_said(const QString& sentence, bool is_bad) {
  said_ = sentence;
  is_bad_ = is_bad;
  refresh();
}

void ControlBar::ask(const QString& question) {
  if (run_.state() != RunState::asking) return;
  is_asking_ = true;
  said_ = question;
  refresh();
  no_->setFocus();  // Enter moves nothing
}

void ControlBar::take_back() {
  is_asking_ = false;
  refresh();
}

void ControlBar::refresh() {
  const RunState state = run_.state();
  const bool rests = state == RunState::resting, is_ready = state == RunState::asking && !is_asking_;
  driver_->setEnabled(rests && hindrance_.isEmpty());
  try_->setEnabled(rests && hindrance_.isEmpty());
  begin_->setVisible(rests || is_ready);
  begin_->setEnabled(!rests || (hindrance_.isEmpty() && !command().isEmpty()));
  begin_->setText(is_ready ? tr("Start…") : tr("Connect"));
  begin_->setToolTip(is_ready      ? tr("Asks once more before the robot moves")
                     : is_recheck_ ? tr("Starts the driver and chooses the poses to recheck in; nothing moves yet")
                                   : tr("Starts the driver and shows the first poses; nothing moves yet"));
  end_->setVisible(is_ready);
  yes_->setVisible(is_asking_);
  no_->setVisible(is_asking_);
  stop_->setEnabled(!rests && state != RunState::asking && state != RunState::stopping && state != RunState::halted);
  QString text = state_text(state, run_.driver_name(), run_.is_of_touches());
  if (rests && !hindrance_.isEmpty())
    text = hindrance_;
  else if (is_asking_ || (rests && !said_.isEmpty()))
    text = said_;
  state_->setText(text);
  const widgets::Colors& c = widgets::colors();
  QPalette ground = state_box_->palette();
  ground.setColor(QPalette::Window, is_asking_                             ? c.care_tint
                                    : rests && is_bad_ && !said_.isEmpty() ? c.bad_tint
                                                                           : c.sunken);
  state_box_->setPalette(ground);
}

}  // namespace handsight::app
