// SPDX-License-Identifier: Apache-2.0
#include "correct/robot_file.h"

#include "base/files.h"

namespace handsight {

CalibratedRobot with_robot_file(CalibratedRobot robot, const std::filesystem::path& urdf) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(urdf, error)) return robot;
  robot.urdf_text = read_file(urdf);
  robot.urdf_file = urdf.filename().string();
  robot.robot_folder = std::filesystem::absolute(urdf).parent_path();
  return robot;
}

CalibratedRobot with_robot_file(CalibratedRobot robot, const Session& session) {
  if (session.robot_file.empty()) return robot;
  const std::filesystem::path& file = session.parts.empty() ? session.file : session.parts.front().file;
  return with_robot_file(std::move(robot), file.parent_path() / session.robot_file);
}

}  // namespace handsight
