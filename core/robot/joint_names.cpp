// SPDX-License-Identifier: Apache-2.0
#include "robot/joint_names.h"

#include "base/text.h"

namespace handsight {

std::string list_moving_joints(const Robot& robot) {
  constexpr std::size_t most = 300;
  std::string list;
  for (const Joint& joint : robot.joints)
    if (joint.moves()) list += (list.empty() ? "" : ", ") + joint.name;
  return list.empty() ? "none" : shortened(list, most);
}

}  // namespace handsight
