// SPDX-License-Identifier: Apache-2.0
// Which of several hands carries which of the targets that a bag's /tf tells. Internal to convert.
#pragma once

#include <string>
#include <vector>

#include "convert/conversion.h"
#include "readers/bags/bag.h"

namespace handsight {

/// Each session's --target-frame by its motions: the one of these frames that goes with its hand and with no other.
/// `notes` says so. As they came where the motions do not tell, or the robot or its joints are not known.
std::vector<ConvertOptions> frames_by_motion(const Bag& bag, std::vector<ConvertOptions> sessions,
                                             const std::vector<std::string>& frames, std::vector<Message>& notes);

}  // namespace handsight
