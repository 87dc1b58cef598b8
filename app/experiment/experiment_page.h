// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment as it goes on: the robot and its next poses in 3D, what became of each pose, and what is known by now.
#pragma once

#include <QWidget>
#include <array>

#include "experiment/experiment_run.h"

class QLabel;
class QStackedWidget;
class QTableWidget;
class QTabWidget;

namespace handsight::widgets {
class HistoryPlot;
class RobotView;
}  // namespace handsight::widgets

namespace handsight::app {

class GoalsForm;
class MovingRobot;

class ExperimentPage : public QWidget {
  Q_OBJECT

 public:
  ExperimentPage(Workbench& workbench, ExperimentRun& run, QWidget* parent = nullptr);

  /// Of another session: nothing is known.
  void set_session();
  void activate();
  GoalsForm& goals() { return *goals_; }
  const MovingRobot& robot() const { return *robot_; }
  std::size_t planned() const;
  /// How the run that ended went.
  void show_end(const ExperimentResult& result);

 private:
  void make_layout();
  QWidget* make_views();
  QWidget* make_welcome();
  QWidget* make_known();
  void connect_run();
  void show_knowledge();
  void show_next();
  void show_poses();
  void show_curves();

  Workbench& workbench_;
  ExperimentRun& run_;
  MovingRobot* robot_ = nullptr;
  widgets::RobotView* scene_;
  widgets::HistoryPlot *hand_plot_, *odds_plot_;
  QStackedWidget* side_;
  QTabWidget* tabs_;
  GoalsForm* goals_;
  QTableWidget* poses_;
  QLabel *hand_, *missing_, *next_, *used_, *more_;
  std::array<QLabel*, 2> causes_{};
  std::vector<ExperimentStep> steps_;
  std::optional<ChosenPose> now_;  // of the pose that the robot is on its way to
  std::shared_ptr<const Knowledge> known_;
  struct Grown {
    std::size_t used = 0;
    std::optional<double> hand, odds;
    qint64 last = -1;
  };
  std::vector<Grown> grown_;
  bool is_set_ = false;
};

}  // namespace handsight::app
