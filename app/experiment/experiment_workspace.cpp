// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experiment_workspace.h"

#include <QApplication>
#include <QKeyEvent>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "experiment/control_bar.h"
#include "experiment/drivers.h"
#include "experiment/experiment_page.h"
#include "experiment/experiment_texts.h"
#include "experiment/goals_form.h"
#include "experiment/recheck_page.h"
#include "words/core_words.h"

namespace handsight::app {

ExperimentWorkspace::ExperimentWorkspace(Workbench& workbench, QWidget* parent)
    : Workspace(workbench, parent), run_(workbench) {
  setObjectName("experiment");
  make_layout();
  connect_run();
  connect(bar_, &ControlBar::begin_wanted, this, &ExperimentWorkspace::begin);
  connect(bar_, &ControlBar::question_wanted, this, &ExperimentWorkspace::ask);
  connect(bar_, &ControlBar::start_wanted, this,
          [this] { run_.start(begun_as_recheck_ ? Goals{} : page_->goals().until(), page_->goals().speed()); });
  connect(bar_, &ControlBar::disconnect_wanted, &run_, &ExperimentRun::refuse);
  connect(bar_, &ControlBar::try_wanted, this, &ExperimentWorkspace::try_it);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    bar_->set_recheck(is_recheck());
    if (is_recheck()) recheck_->refresh();
  });
  connect(&workbench.document, &Document::opened, this, &ExperimentWorkspace::set_session);
  connect(&workbench.document, &Document::closed, this, &ExperimentWorkspace::set_session);
  qApp->installEventFilter(this);
}

ExperimentWorkspace::~ExperimentWorkspace() { qApp->removeEventFilter(this); }

void ExperimentWorkspace::make_layout() {
  bar_ = new ControlBar(run_, this);
  page_ = new ExperimentPage(workbench_, run_, this);
  recheck_ = new RecheckPage(workbench_, this);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("experiment_tabs");
  tabs_->setDocumentMode(true);
  tabs_->addTab(page_, tr("Measure"));
  tabs_->addTab(recheck_, tr("Recheck"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 8);
  layout->setSpacing(4);
  layout->addWidget(bar_);
  layout->addWidget(tabs_, 1);
}

void ExperimentWorkspace::connect_run() {
  connect(&run_, &ExperimentRun::state_changed, this, [this] {
    // What is being asked is answered where it was begun.
    tabs_->tabBar()->setEnabled(!run_.is_on());
    emit status_changed();
  });
  connect(&run_, &ExperimentRun::measured, this, [this] {
    ++measured_;
    if (begun_as_recheck_) recheck_->refresh();
    emit status_changed();
  });
  connect(&run_, &ExperimentRun::noted, &workbench_.document, &Document::noticed);
  connect(&run_, &ExperimentRun::failed, this, [this](const QString& sentence) { bar_->set_said(sentence, true); });
  connect(&run_, &ExperimentRun::ended, this, [this](const std::shared_ptr<const ExperimentResult>& result) {
    bar_->set_said(translated(result->reason), result->end == ExperimentEnd::fault);
    page_->show_end(*result);
    if (begun_as_recheck_) recheck_->refresh();
  });
}

void ExperimentWorkspace::set_session() {
  measured_ = 0;
  bar_->set_said({}, false);
  bar_->set_hindrance(workbench_.document.is_open() ? why_no_experiment(workbench_.document.session()) : QString());
  page_->set_session();
  recheck_->set_session();
  emit status_changed();
}

bool ExperimentWorkspace::is_recheck() const { return tabs_->currentWidget() == recheck_; }

void ExperimentWorkspace::begin() {
  try {
    RunWish wish{bar_->command(), page_->goals().options(), {}, {}};
    if (is_recheck()) {
      wish.options.box.reset();
      recheck_->complete(wish);
    }
    wish.options.fit_each_look = true;
    begun_as_recheck_ = is_recheck();
    bar_->set_said({}, false);
    run_.begin(wish);
  } catch (const std::exception& error) {
    bar_->set_said(translated_error(error), true);
  }
}

void ExperimentWorkspace::ask() {
  bar_->ask(question_text(page_->planned(), page_->goals().speed(), run_.is_of_touches()));
}

/// In a session of its own, so that nothing invented comes among what was measured.
void ExperimentWorkspace::try_it() {
  try {
    if (!is_to_try(workbench_.document.file())) workbench_.document.open(session_to_try(workbench_.document.session()));
    const QString command = simulated_driver(workbench_.document.session());
    if (command.isEmpty())
      throw InputError("handsight-driver-simulated is not found beside this program; install it with Handsight.");
    bar_->set_command(command);
    emit workbench_.workspace_requested(Place::experiment);
    begin();
  } catch (const std::exception& error) {
    bar_->set_said(translated_error(error), true);
  }
}

void ExperimentWorkspace::activate() { page_->activate(); }

WorkStatus ExperimentWorkspace::status() const {
  if (!workbench_.document.is_open() || !why_no_experiment(workbench_.document.session()).isEmpty())
    return {WorkState::waiting, tr("not of this session")};
  switch (run_.state()) {
    case RunState::resting:
      return measured_ > 0 ? WorkStatus{WorkState::done, tr("%1 measured").arg(measured_)}
                           : WorkStatus{WorkState::waiting, tr("no robot connected")};
    case RunState::asking:
      return {WorkState::open, tr("ready to start")};
    case RunState::moving:
    case RunState::looking:
      return {WorkState::care, tr("the robot moves")};
    case RunState::greeting:
      return {WorkState::open, tr("connecting")};
    default:
      return {WorkState::open, run_.is_driving() ? tr("the robot waits") : tr("choosing poses")};
  }
}

bool ExperimentWorkspace::key(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !bar_->is_asking()) return false;
  bar_->take_back();
  return true;
}

bool ExperimentWorkspace::eventFilter(QObject* watched, QEvent* event) {
  const bool is_key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!is_key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || !run_.is_driving())
    return Workspace::eventFilter(watched, event);
  run_.stop();
  event->accept();
  return true;
}

std::vector<Action> ExperimentWorkspace::own_actions() const {
  return {Action{.id = "experiment_stop_key",
                 .group = tr("Experiment"),
                 .text = tr("stop the robot, from everywhere"),
                 .gesture = tr("Esc")}};
}

}  // namespace handsight::app
