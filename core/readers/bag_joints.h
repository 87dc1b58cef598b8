// SPDX-License-Identifier: Apache-2.0
// Joint readings as a bag's topics tell them, brought together.
#pragma once

#include <map>

#include "readers/bags/messages.h"
#include "readers/series.h"
#include "robot/robot.h"

namespace handsight {

/// Readings as they come in, from one topic or several.
class JointTaker {
 public:
  explicit JointTaker(const Robot& robot) : robot_(robot) {}

  void see(const ros::JointState& state, double time);

  /// Every joint at every time at which any was reported, once all that are reported at all are known: the last that
  /// was known of it by then.
  JointSeries series();

  /// How many names were no moving joint of the robot.
  std::size_t unknown() const { return unknown_.size(); }

 private:
  struct Told {
    double time, value;
  };
  const Robot& robot_;
  std::map<int, std::vector<Told>> values_;
  std::vector<double> times_;
  std::map<std::string, int> unknown_;
};

}  // namespace handsight
