// SPDX-License-Identifier: Apache-2.0
// A robot with known truth that can be driven, and one that goes wrong on demand.
#pragma once

#include <filesystem>

#include "experiment/driver/driven_robot.h"
#include "simulation/random.h"
#include "simulation/simulated_files.h"

namespace handsight {

struct SimulatedRobotOptions {
  SimulationOptions truth;          // effects, curves, noise, seed, size of the body
  double repeatability = 0;         // rad (m) a joint: the robot stands so far from what it reads, anew after each move
  std::filesystem::path images_to;  // images are rendered into images/ there; empty: markers or points are reported
};

/// The robot that made a session: the body on its hand, and a mount that was not known, are those of the session's fit
/// with the truth's effects. Where nothing can be fitted the body is drawn by the seed.
SimulatedRobotOptions make_simulated_robot(const Session& session, SimulatedRobotOptions options, Session& like);

/// Stands where the session's last observation was taken. Moves take no time but tell the time that they would have
/// taken. Lenses, rig, noise and target are those of `like`, beside the truth's effects.
class SimulatedRobot : public DrivenRobot {
 public:
  SimulatedRobot(const Session& like, SimulatedRobotOptions options);

  DriverHello hello() override;
  MoveAnswer move(const std::vector<Eigen::VectorXd>& path, double speed) override;
  LookAnswer look() override;
  TouchAnswer touch(const TouchRequest& request) override;
  void stop() noexcept override {}

  /// Everything that was looked at so far, as it truly was.
  const SimulatedSession& simulated() const { return simulated_; }

 private:
  Session like_;
  SimulatedRobotOptions options_;
  Random random_;
  std::vector<Observation> looks_;  // true postures
  Eigen::VectorXd position_, true_position_;
  double time_ = 0;
  SimulatedSession simulated_;
};

}  // namespace handsight
