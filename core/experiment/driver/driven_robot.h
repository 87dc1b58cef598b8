// SPDX-License-Identifier: Apache-2.0
// A robot that is reported where to go and what to look at: a driver's process (child_driver.h), or a simulation.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "session/session.h"

namespace handsight {

/// A driver that died, hangs, lies or sends nonsense: one sentence. Nothing more is asked of it.
class DriverFault : public InputError {
 public:
  explicit DriverFault(const Message& sentence) : InputError(sentence) {}
};

struct DriverHello {
  std::string name;
  std::vector<std::string> joints;          // the order of its positions
  std::vector<std::string> can;             // "move", "look"
  std::optional<Eigen::VectorXd> position;  // rad or m: where the robot stands, where the driver says it
};

struct MoveAnswer {
  bool ok = false;
  Message why;                       // of a move that was refused
  Eigen::VectorXd position, torque;  // rad or m; N m (N), empty where not measured
  std::optional<double> time;        // s, on the driver's clock
};

/// What a look saw: one of images, points, a pose or markers in the images.
struct LookAnswer {
  bool ok = false;
  Message why;                                // where nothing could be seen
  std::map<std::string, std::string> images;  // by camera: file
  std::vector<Sighting> sightings;            // points of a tracker, or markers in the images
  std::optional<Rigid> target_pose;           // of a pose sensor
};

/// What is to be touched, and in which posture (rad or m, in the order of DriverHello::joints) the tip is expected to.
struct TouchRequest {
  std::string fixture;  // its id
  Eigen::VectorXd position;
};

/// What a touch read; the robot stands again where it stood before.
struct TouchAnswer {
  bool ok = false;
  Message why;                       // where nothing could be touched
  std::string fixture;               // its id
  int marker = 0;                    // which tip
  std::optional<double> value;       // m, of a fixture that reads one
  Eigen::VectorXd position, torque;  // rad or m, N m (N), while it touched; empty: where it stood before the look
  std::optional<double> time;        // s, on the driver's clock
};

class DrivenRobot {
 public:
  DrivenRobot() = default;
  DrivenRobot(const DrivenRobot&) = delete;
  DrivenRobot& operator=(const DrivenRobot&) = delete;
  virtual ~DrivenRobot() = default;

  /// Positions and paths are in the order of DriverHello::joints. Each may throw DriverFault.
  virtual DriverHello hello() = 0;
  /// Along the path's points, straight in the joints between them; `speed`: of the fastest joint, rad/s (m/s).
  virtual MoveAnswer move(const std::vector<Eigen::VectorXd>& path, double speed) = 0;
  virtual LookAnswer look() = 0;
  /// A look of a session of touches: from where it stands to the fixture, and back.
  virtual TouchAnswer touch(const TouchRequest& request) = 0;
  /// Stands still as soon as it can. Throws nothing.
  virtual void stop() noexcept = 0;
};

}  // namespace handsight
