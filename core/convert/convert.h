// SPDX-License-Identifier: Apache-2.0
// A session from what a user has. One sensor measures in each: images of cameras, points, or poses of a target.
#pragma once

#include <filesystem>
#include <vector>

#include "convert/conversion.h"

namespace handsight {

/// Makes the session's folder. InputError where the files do not make a session: what is missing and what to do;
/// ConversionStopped.
Conversion convert(const std::vector<std::filesystem::path>& files, const ConvertOptions& options);

}  // namespace handsight
