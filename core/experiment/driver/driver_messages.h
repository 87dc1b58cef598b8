// SPDX-License-Identifier: Apache-2.0
// What is said to a driver and what it answers: JSON, a line a message (docs/experiment.md).
#pragma once

#include "experiment/driver/driven_robot.h"

namespace handsight {

/// Lines without their end.
std::string hello_line(std::int64_t id);
std::string move_line(std::int64_t id, const std::vector<Eigen::VectorXd>& path, double speed);
std::string look_line(std::int64_t id);
std::string touch_line(std::int64_t id, const TouchRequest& request);
std::string stop_line(std::int64_t id);

/// The id that an answer repeats. DriverFault where the line is no JSON object with one.
std::int64_t answered_id(const std::string& line);

/// Answers as they are read; DriverFault names what is not as it must be.
DriverHello hello_answer(const std::string& line);
MoveAnswer move_answer(const std::string& line, std::size_t joints);
/// `rig`: the names of the cameras, null where there is none; `markers`: how many the session has.
LookAnswer look_answer(const std::string& line, const Rig* rig, int markers);
TouchAnswer touch_answer(const std::string& line, std::size_t joints, int markers);

/// The same from the other side: what a driver of ours reads and writes.
struct DriverRequest {
  std::int64_t id = 0;
  std::string what;
  std::vector<Eigen::VectorXd> path;
  double speed = 0;
  std::optional<TouchRequest> touch;  // of a look
};
DriverRequest driver_request(const std::string& line);
std::string answer_line(std::int64_t id, const DriverHello& hello);
std::string answer_line(std::int64_t id, const MoveAnswer& answer);
std::string answer_line(std::int64_t id, const LookAnswer& answer, const Rig* rig);
std::string answer_line(std::int64_t id, const TouchAnswer& answer);
std::string stopped_line(std::int64_t id);

}  // namespace handsight
