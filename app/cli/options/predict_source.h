// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command.h"
#include "correct/calibrated_robot.h"

namespace handsight::cli {

/// What predictions, corrections and exports are made from: a session, which is fitted with these effects, or a
/// calibration file and a robot; of a collection, or its calibration, the named session's hand. InputError where a
/// calibration stands without a robot, or with effects.
CalibratedRobot predict_source(const std::string& session_or_calibration, const std::string& robot_file,
                               const std::vector<std::string>& effects = {}, const std::string& session = {});

/// InputError where the robot is known by its flange's poses alone: what bends or is off in it was not asked.
void require_joints(const CalibratedRobot& robot);

/// Where the same is asked for in options: SESSION, --robot, --session, --effects.
struct SourceOptions {
  std::string source, robot, session;
  std::vector<std::string> effects;
};
void add_source_options(const CommandLine& command, SourceOptions& options);
CalibratedRobot predict_source(const SourceOptions& options);

}  // namespace handsight::cli
