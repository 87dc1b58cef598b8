// SPDX-License-Identifier: GPL-3.0-or-later
// The Calibrate workspace: the session is played, and four things move together.
#pragma once

#include <QTimer>
#include <set>

#include "calibrate/player.h"
#include "workbench/workspace.h"

class QTabWidget;

namespace handsight::widgets {
class ConvergenceBoard;
class DecisionList;
class ImageView;
class RobotView;
}  // namespace handsight::widgets

namespace handsight::app {

class CameraStrip;

class FixturesPage;
class HandsPage;
class ObjectivePage;
class OneMarkerPage;
class OwnPosePage;
class Transport;

class CalibrateWorkspace : public Workspace {
  Q_OBJECT

 public:
  explicit CalibrateWorkspace(Workbench& workbench, QWidget* parent = nullptr);

  std::vector<Action> own_actions() const override;
  WorkStatus status() const override;
  Panel panel() const override { return Panel::folded; }
  void activate() override;
  bool key(QKeyEvent* event) override;
  Player& player() { return player_; }

 private:
  void make_layout();
  void connect_player();
  void connect_selection();
  /// What was played since the last time, in all views at once: they need not be painted for each observation.
  void show_played();
  void refresh_transport();
  void refresh_observation();
  void refresh_model();
  void refresh_decisions();
  void refresh_decision_title(bool is_present);
  void set_robot();
  void say_notes();
  /// Of a collection each hand in the place of the convergence, which is of one session.
  void show_hands();
  /// The convergence of a session that was played before it was opened.
  void recall();

  Player player_;
  Transport* transport_;
  widgets::ImageView *left_, *right_;
  CameraStrip* cameras_;
  widgets::RobotView* scene_ = nullptr;
  widgets::ConvergenceBoard* board_;
  widgets::DecisionList* decisions_;
  QTabWidget* tabs_;
  ObjectivePage* objectives_;
  OneMarkerPage* one_marker_;
  OwnPosePage* own_pose_;
  HandsPage* hands_;
  FixturesPage* fixtures_;
  std::vector<PlayedStep> unshown_;  // played, not yet in the views
  std::set<std::int64_t> shown_;     // observations that are in the views
  QTimer show_timer_;
  bool robot_is_set_ = false, is_stale_ = true, is_recalled_ = false;
};

}  // namespace handsight::app
