// SPDX-License-Identifier: Apache-2.0
// Which of a model's effects a file of rigid links and ideal joints can hold as they are.
#pragma once

#include "base/message.h"
#include "correct/calibrated_robot.h"

namespace handsight {

struct HeldSites {
  Sites sites;                    // what is the same in all poses after the session; a place for every joint
  std::vector<Message> left_out;  // effects and springs that are not in `sites`, a phrase each
  std::vector<Message> remarks;   // what is in the file and read by some programs alone, a phrase each
};

/// A rigid file holds motions of joints' frames, their zeros, multipliers of joints that follow others, and motions of
/// hand, body and mount, as long as they are the same in every pose.
HeldSites held_sites(const CalibratedRobot& robot);

/// Of a change the part that a rigid file holds: angles, multipliers, frames.
RobotChange rigid_part(const RobotChange& change);

}  // namespace handsight
