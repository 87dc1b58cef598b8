// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experiment_page.h"

#include <QLabel>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>

#include "experiment/experiment_texts.h"
#include "experiment/goals_form.h"
#include "experiment/moving_robot.h"
#include "widgets/base/theme.h"
#include "widgets/plots/history_plot.h"
#include "widgets/scene/robot_view.h"
#include "words/core_words.h"
#include "words/counted.h"

namespace handsight::app {
namespace {

enum Tab { goals_tab, known_tab };
enum Side { welcome, work };

constexpr double feeling_speed = 0.1;  // rad/s, as it is drawn: the driver's own is not told

QTableWidgetItem* cell(const QString& text, const QColor& ink) {
  auto* item = new QTableWidgetItem(text);
  item->setForeground(ink);
  item->setToolTip(text);
  return item;
}

}  // namespace

ExperimentPage::ExperimentPage(Workbench& workbench, ExperimentRun& run, QWidget* parent)
    : QWidget(parent), workbench_(workbench), run_(run) {
  setObjectName("experiment_page");
  make_layout();
  robot_ = new MovingRobot(workbench, *scene_, this);
  connect_run();
  connect(poses_, &QTableWidget::currentCellChanged, this, [this](int row) {
    const int taken = static_cast<int>(steps_.size());
    if (row >= taken && run_.state() == RunState::asking) robot_->point_at(row - taken);
    if (row >= 0 && row < taken && steps_[static_cast<std::size_t>(row)].id >= 0)
      workbench_.selection.select_observation(steps_[static_cast<std::size_t>(row)].id);
  });
  set_session();
}

void ExperimentPage::connect_run() {
  connect(&run_, &ExperimentRun::stood, this, [this](const Eigen::VectorXd& at) { robot_->stand(at); });
  connect(&run_, &ExperimentRun::planned, this, [this](const std::vector<PlannedMove>& moves) {
    robot_->plan(moves);
    show_poses();
    show_next();
  });
  connect(&run_, &ExperimentRun::moving, this, [this](const std::vector<Eigen::VectorXd>& path, double speed) {
    show_next();  // while it is still among those that come
    now_ = robot_->move(path, speed);
    show_poses();
  });
  connect(&run_, &ExperimentRun::feeling, this,
          [this](const Eigen::VectorXd& touching) { robot_->move({touching}, feeling_speed); });
  connect(&run_, &ExperimentRun::stepped, this, [this](const ExperimentStep& step) {
    steps_.push_back(step);
    now_.reset();
    show_poses();
  });
  connect(&run_, &ExperimentRun::measured, this,
          [this](const std::shared_ptr<const Session>&, qint64 id) { workbench_.selection.select_observation(id); });
  connect(&run_, &ExperimentRun::learned, this, [this](const std::shared_ptr<const Knowledge>& known) {
    known_ = known;
    const std::optional<double> odds = known->settled ? std::optional(known->settled->odds) : std::nullopt;
    if (!grown_.empty() && grown_.back().used == known->used) grown_.pop_back();
    grown_.push_back({known->used, known->hand_limit, odds, steps_.empty() ? -1 : steps_.back().id});
    show_knowledge();
    show_curves();
  });
  connect(&run_, &ExperimentRun::state_changed, this, [this] {
    const RunState state = run_.state();
    if (run_.is_on()) side_->setCurrentIndex(work);
    if (state == RunState::asking) tabs_->setCurrentIndex(goals_tab);
    if (state == RunState::moving) tabs_->setCurrentIndex(known_tab);
    if (state == RunState::stopping || state == RunState::halted) robot_->halt();
    goals_->set_places_enabled(!run_.is_on());
    if (state == RunState::resting) {
      robot_->forget_plan();
      now_.reset();
      show_poses();
    }
    show_next();
  });
}

void ExperimentPage::set_session() {
  steps_.clear();
  now_.reset();
  grown_.clear();
  known_.reset();
  is_set_ = false;
  more_->setText(tr("told when it ends"));
  side_->setCurrentIndex(welcome);
  tabs_->setCurrentIndex(goals_tab);
  show_poses();
  show_knowledge();
  show_curves();
  if (isVisible()) activate();
}

void ExperimentPage::activate() {
  if (is_set_) return;
  is_set_ = true;
  robot_->set_session();
}

std::size_t ExperimentPage::planned() const { return robot_->planned().size(); }

void ExperimentPage::show_end(const ExperimentResult& result) {
  if (result.known.fit) {
    auto known = std::make_shared<Knowledge>(result.known);
    // What was diagnosed last stands where the end was too sudden to ask again.
    if (!known->diagnosis && known_) {
      known->diagnosis = known_->diagnosis;
      known->settled = known_->settled;
    }
    known_ = known;
  }
  more_->setText(result.more.empty() ? tr("cannot be predicted") : translated(result.more));
  if (result.end != ExperimentEnd::not_confirmed && result.end != ExperimentEnd::dry_run)
    tabs_->setCurrentIndex(known_tab);
  show_knowledge();
}

void ExperimentPage::show_knowledge() {
  const bool is_known = known_ && known_->fit;
  used_->setText(known_ ? counted(static_cast<qint64>(known_->used), "%n observation(s)") : tr("nothing measured yet"));
  const bool has_box = goals_->has_box();
  hand_->setText(is_known ? hand_text(*known_, has_box, run_.is_of_touches()) : tr("not known yet"));
  missing_->setText(is_known ? verdict_in_words(*known_) : tr("not known yet"));
  const std::vector<CauseInWords> causes = is_known ? likeliest_causes(*known_) : std::vector<CauseInWords>();
  for (std::size_t i = 0; i < causes_.size(); ++i)
    causes_[i]->setText(i < causes.size() ? tr("%1: %2").arg(causes[i].cause, causes[i].odds) : tr("none yet"));
  show_next();
}

void ExperimentPage::show_next() {
  const std::vector<PlannedMove>& planned = robot_->planned();
  if (planned.empty()) return next_->setText(tr("none chosen yet"));
  const QString reason = reason_in_words(planned.front().pose.reason);
  const QString fixture = touched_by(planned.front().pose, workbench_.document.session());
  next_->setText(fixture.isEmpty() ? reason : tr("touches %1, %2").arg(fixture, reason));
}

void ExperimentPage::show_poses() {
  const QSignalBlocker quiet(poses_);
  const auto& c = widgets::colors();
  const std::vector<PlannedMove>& planned = robot_ ? robot_->planned() : std::vector<PlannedMove>();
  poses_->setRowCount(static_cast<int>(steps_.size() + planned.size()) + (now_ ? 1 : 0));
  int row = 0;
  const auto put = [&](const QString& name, PoseReason reason, const QString& result, const QColor& ink) {
    poses_->setItem(row, 0, cell(name, c.ink1));
    poses_->setItem(row, 1, cell(reason_in_words(reason), c.ink1));
    poses_->setItem(row++, 2, cell(result, ink));
  };
  const auto named = [this](const QString& name, const ChosenPose& pose) {
    const QString fixture = touched_by(pose, workbench_.document.session());
    return fixture.isEmpty() ? name : tr("%1, %2").arg(name, fixture);
  };
  for (const ExperimentStep& step : steps_)
    put(named(step.id < 0 ? QStringLiteral("-") : tr("obs %1").arg(step.id), step.move.pose), step.move.pose.reason,
        step_text(step), step.accepted ? c.good : c.care);
  const int taken = row;
  if (now_) put(named(tr("now"), *now_), now_->reason, tr("on its way"), c.accent);
  for (const PlannedMove& move : planned) put(named(tr("next"), move.pose), move.pose.reason, way_text(move), c.ink2);
  if (const int last = std::min(row - 1, taken + 1); last >= 0) poses_->scrollToItem(poses_->item(last, 0));
}

void ExperimentPage::show_curves() {
  std::vector<widgets::HistoryPoint> hand, odds;
  for (const Grown& g : grown_) {
    const auto used = static_cast<double>(g.used);
    if (g.hand) hand.push_back({.x = used, .y = 1e3 * *g.hand, .observation = g.last});
    if (g.odds) odds.push_back({.x = used, .y = std::min(*g.odds, 1e9), .observation = g.last});
  }
  const Goals until = goals_->until();
  hand_plot_->set_limit(until.hand ? std::optional(1e3 * *until.hand) : std::nullopt, tr("goal"));
  odds_plot_->set_limit(until.odds, tr("goal"));
  hand_plot_->set_points(std::move(hand));
  odds_plot_->set_points(std::move(odds));
}

}  // namespace handsight::app
