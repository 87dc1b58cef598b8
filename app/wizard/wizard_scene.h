// SPDX-License-Identifier: GPL-3.0-or-later
// The robot with the links that were chosen for camera and target, before there is a session.
#pragma once

#include <Eigen/Core>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "camera/camera.h"
#include "robot/robot.h"

namespace handsight::widgets {
class RobotView;
}

namespace handsight::app {

struct WizardScene {
  const Robot* robot = nullptr;
  std::vector<std::string> joints;  // of `position`
  Eigen::VectorXd position;         // empty: all joints stand at 0
  std::string camera_link, target_link;
  std::optional<Rigid> mount_from_camera;  // nothing: not known; it is drawn so that it looks at the target
  bool is_on_table = false;                // the target
  Camera camera;
};

/// How many joints move between the two links.
int joints_between(const Robot& robot, int link, int other);

/// Camera and target into a view that shows the robot.
void show_scene(const WizardScene& scene, widgets::RobotView& view);

}  // namespace handsight::app
