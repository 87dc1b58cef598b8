// SPDX-License-Identifier: Apache-2.0
// A camera's matrix and its lens as plain numbers, as NumPy's savetxt and people write them.
#pragma once

#include <optional>
#include <string>

namespace handsight {

/// The three rows of a camera's matrix, or in a file whose name (without its ending) says so the four to fourteen
/// numbers of OpenCV's distortion, as entries that parse_rig_calibration reads. Nothing where the text is neither.
std::optional<std::string> camera_entries(const std::string& text, const std::string& name);

}  // namespace handsight
