// SPDX-License-Identifier: Apache-2.0
// A driver as a child process that speaks JSON, a line a message, on its standard input and output.
#pragma once

#include <functional>
#include <memory>

#include "experiment/driver/child_process.h"
#include "experiment/driver/driven_robot.h"

namespace handsight {

/// How long answers are waited for, s.
struct DriverPatience {
  double hello = 60, look = 30;
  double move = 30;  // beside three times what the path takes at its speed
  double stop = 1;
};

class ChildDriver : public DrivenRobot {
 public:
  /// `session` says which cameras and markers there are. `is_interrupted` may be asked from any wait: where it says yes
  /// the driver is asked to stop and DriverFault is thrown.
  ChildDriver(const std::string& command, const Session& session, DriverPatience patience = {},
              std::function<bool()> is_interrupted = {});
  ~ChildDriver() override;

  DriverHello hello() override;
  MoveAnswer move(const std::vector<Eigen::VectorXd>& path, double speed) override;
  LookAnswer look() override;
  TouchAnswer touch(const TouchRequest& request) override;
  void stop() noexcept override;

 private:
  std::string asked(const std::string& line, const char* what, double seconds);
  [[noreturn]] void fail(LineEnd end, const char* what, double seconds);

  ChildProcess process_;
  std::optional<Rig> rig_;
  int markers_;
  DriverPatience patience_;
  std::function<bool()> is_interrupted_;
  std::int64_t next_id_ = 1;
  std::size_t joints_ = 0;
  std::optional<Eigen::VectorXd> last_;  // where it said that it stood
  bool is_moving_ = false;               // a move was sent and not answered
  bool is_lost_ = false;                 // it is not spoken to any more
};

}  // namespace handsight
