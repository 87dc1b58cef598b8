// SPDX-License-Identifier: Apache-2.0
// The calibrated robot as a URDF that any reader opens.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "export/rigid/rigid_fit.h"

namespace handsight {

struct UrdfFile {
  std::string text;
  std::string hand_link;               // whose frame is the hand's, where a URDF can say it: the tcp link or a new one
  std::string body_link, sensor_link;  // new links; the sensor's is empty where its mount is not known
  std::vector<Message> not_said;       // what a URDF cannot say, a phrase each; a comment in the text holds them too
  RigidFit fit;                        // what it says of the joints, and what it misses
};

/// The robot as it was written, with origins moved by joint offsets, geometry and every effect that is the same in all
/// poses after the session (a slip that has come stays), multipliers of joints that follow others, and links for the
/// marker body and the sensor. Where the model has more than that, springs too, the origins are those of rigid_fit: the
/// best robot without it; <stiffness> is then left out. InputError where CalibratedRobot::urdf_text is empty.
UrdfFile urdf_file(const CalibratedRobot& robot, Holds holds = Holds::origins);

}  // namespace handsight
