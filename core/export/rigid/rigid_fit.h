// SPDX-License-Identifier: Apache-2.0
// The best robot of rigid links and ideal joints: what such a file cannot hold is left out, and what it can hold is
// fitted again without it, to where the whole model has the hand.
#pragma once

#include "base/message.h"
#include "chain/sites.h"
#include "correct/calibrated_robot.h"
#include "robot/posture.h"

namespace handsight {

/// The numbers that a kind of file may change.
enum class Holds {
  origins,         // of all joints
  moving_origins,  // of the joints that move; what follows the last of them stays
  offsets,         // the zeros of the joints that move by themselves, and nothing else
};

/// What a file misses, m: how far its hand is from where the whole model has it.
struct Missed {
  double rms = 0, largest = 0;
};

struct RigidFit {
  RobotChange change;             // the rigid robot's numbers: angles, frames, multipliers
  Sites sites;                    // with `change` in it: hand, body and mount too
  std::vector<Message> left_out;  // of HeldSites
  std::vector<Message> remarks;
  Missed left;     // over the poses
  Missed nominal;  // of the robot as it was written, its springs left out
  int poses = 0;
  bool are_measured = false;  // the session's poses; else drawn within the joints' limits
};

/// Where nothing is left out the change is the model's own, bit for bit. Else the hand (and the link that carries the
/// sensor, where joints move it) is brought nearest to the whole model's in least squares over the session's poses and
/// poses between them, a radian counting as 0.1 m, and numbers that the poses do not determine stay near the model's.
RigidFit rigid_fit(const CalibratedRobot& robot, Holds holds = Holds::origins);

/// What another change of the rigid robot misses over the same poses.
Missed missed_with(const CalibratedRobot& robot, const RobotChange& change);

/// "0.123 mm rms and 0.456 mm at most over the 36 poses of the session".
Message missed_text(const RigidFit& fit);

}  // namespace handsight
