// SPDX-License-Identifier: Apache-2.0
// Blunders that show in a session's files, before anything is fitted.
#pragma once

#include <vector>

#include "blunders/blunder.h"
#include "session/session.h"

namespace handsight {

/// size_swapped: images have the height that a camera is said to have as their width and the other way round, or points
/// lie outside the image and would lie inside it; image_mirrored: the target is found in hardly an image, but in a
/// mirrored one; gravity_turned: measured torques follow the moments of a gravity along another axis. Empty where
/// nothing shows; images that cannot be read are passed over.
std::vector<Blunder> blunders_in_files(const Session& session);

}  // namespace handsight
