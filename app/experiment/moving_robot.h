// SPDX-License-Identifier: GPL-3.0-or-later
// The robot of an experiment in the 3D view: where it stands, where it is to go, and each move as it happens.
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "experiment/loop/experiment.h"
#include "workbench/workbench.h"

namespace handsight::widgets {
class RobotView;
}

namespace handsight::app {

class MovingRobot : public QObject {
  Q_OBJECT

 public:
  MovingRobot(Workbench& workbench, widgets::RobotView& view, QObject* parent);

  /// Of the open session; it stands where the last observation was taken until somebody knows better.
  void set_session();
  /// Here it stands, whatever was drawn before.
  void stand(const Eigen::VectorXd& position);
  /// Poses that come next, with their ways; the next one also as an outline.
  void plan(const std::vector<PlannedMove>& moves);
  /// Shows one of them as an outline; none where there is no such place.
  void point_at(int place);
  /// It goes along these points now, the fastest joint at `speed`, rad/s (m/s); drawn where it is by then.
  /// The pose, where it is one of those that were planned.
  std::optional<ChosenPose> move(const std::vector<Eigen::VectorXd>& path, double speed);
  /// It stands still where it is drawn.
  void halt();
  void forget_plan();

  /// Where it is drawn, in the order of the session's joints.
  const Eigen::VectorXd& position() const { return at_; }
  const std::vector<PlannedMove>& planned() const { return planned_; }

 private:
  void draw();
  void draw_paths();
  void set_outline(const std::optional<Eigen::VectorXd>& position);
  std::vector<Vector3> tcp_along(const Eigen::VectorXd& from, const std::vector<Eigen::VectorXd>& way) const;
  Vector3 tcp_at(const Eigen::VectorXd& position) const;
  void go_on();

  Workbench& workbench_;
  widgets::RobotView& view_;
  Eigen::VectorXd at_;
  std::vector<PlannedMove> planned_;
  std::optional<std::vector<Rigid>> outline_;  // the robot where it is to go
  std::vector<Eigen::VectorXd> path_;          // of the move that is on; its first point is where it began
  double speed_ = 0;
  QElapsedTimer clock_;  // since the move began
  QTimer timer_;
};

}  // namespace handsight::app
