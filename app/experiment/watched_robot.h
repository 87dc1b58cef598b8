// SPDX-License-Identifier: GPL-3.0-or-later
// A driven robot that somebody watches: what it is asked and what it answers is reported as it happens.
#pragma once

#include <functional>

#include "experiment/driver/driven_robot.h"

namespace handsight::app {

/// Called in the thread that asks the robot; positions in the order of DriverHello::joints.
struct RobotWatch {
  std::function<void(const DriverHello&)> greeted;
  std::function<void(const std::vector<Eigen::VectorXd>& path, double speed)> moving;
  std::function<void(const MoveAnswer&)> stood;
  std::function<void()> looking;
  std::function<void(const TouchRequest&)> touching;
  std::function<void()> went_back;  // after a touch, to where it stood
  std::function<void()> halted;     // it was asked to stop, and has answered or never will
};

class WatchedRobot : public DrivenRobot {
 public:
  /// `robot` outlives it.
  WatchedRobot(DrivenRobot& robot, RobotWatch watch) : robot_(robot), watch_(std::move(watch)) {}

  DriverHello hello() override {
    DriverHello hello = robot_.hello();
    watch_.greeted(hello);
    return hello;
  }
  MoveAnswer move(const std::vector<Eigen::VectorXd>& path, double speed) override {
    watch_.moving(path, speed);
    MoveAnswer answer = robot_.move(path, speed);
    watch_.stood(answer);
    return answer;
  }
  LookAnswer look() override {
    watch_.looking();
    return robot_.look();
  }
  TouchAnswer touch(const TouchRequest& request) override {
    watch_.touching(request);
    TouchAnswer answer = robot_.touch(request);
    watch_.went_back();
    return answer;
  }
  void stop() noexcept override {
    robot_.stop();
    watch_.halted();
  }

 private:
  DrivenRobot& robot_;
  RobotWatch watch_;
};

}  // namespace handsight::app
