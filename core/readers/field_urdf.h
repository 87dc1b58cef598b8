// SPDX-License-Identifier: Apache-2.0
// URDFs as users have them, made fit for a session.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "robot/robot.h"

namespace handsight {

struct FieldUrdf {
  std::string text;  // as it goes into the session
  Robot robot;
  std::vector<Message> notes;  // what was changed, what is missing and what that means; a sentence each
};

/// Floating and planar joints stand still in the session's copy. InputError where the file is no URDF, xacro among
/// them, with the command that expands it.
FieldUrdf field_urdf(const std::string& text, const std::string& file);

/// The links at the ends of the robot, where hands and cameras sit.
std::vector<std::string> end_links(const Robot& robot);

}  // namespace handsight
