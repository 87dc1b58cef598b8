// SPDX-License-Identifier: Apache-2.0
// What is odd in a session and probably a slip of whoever wrote it: looked through at once, without reading images.
#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "session/session.h"

namespace handsight {

/// A sentence each: what is odd, and what to do. Points outside the image (and whether width and height are swapped),
/// markers that are never seen, angles that can only be degrees or look like them, poses that are all one pose, a joint
/// between camera and hand that is not measured, masses of nothing, cameras that see nothing or everything, a camera's
/// points or images that are another's, a baseline of no rig, gravity of another planet,
/// readings that were not made anew. Empty where nothing is.
std::vector<Message> session_warnings(const Session& session);

/// Does the robot stand in one and the same pose in all observations?
bool never_moved(const Session& session);

/// The same of what a fit found: a body farther from the TCP than any hand is long, m. Empty where it is not.
Message body_warning(const Rigid& tcp_from_body);

}  // namespace handsight
