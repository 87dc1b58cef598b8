// SPDX-License-Identifier: Apache-2.0
// Recordings that keep each sample in a folder of its own. Internal to convert.
#pragma once

#include <filesystem>

namespace handsight {

/// InputError with the commands that sort it by camera, where a folder holds a folder for each sample, with images of
/// the same names in each ("sample_0/left.png", "sample_0/joints.csv").
void refuse_sample_folders(const std::filesystem::path& folder);

}  // namespace handsight
