// SPDX-License-Identifier: Apache-2.0
// Which poses of two tables are of one instant, and which are no measurement of their own. Internal to convert.
#pragma once

#include "base/message.h"
#include "convert/brought.h"
#include "convert/conversion.h"
#include "session/find_images.h"

namespace handsight {

/// These rows of a series, or of one with its turns.
PoseSeries take_rows(const PoseSeries& series, const std::vector<std::size_t>& rows);
NamedPoses take_rows(const NamedPoses& poses, const std::vector<std::size_t>& rows);

/// Both with one row an instant: by the images' names, the numbers or the times where both have them, else row by row.
/// Rows that repeat another one in both are left out. InputError where they do not pair. What was done is said.
void pair_poses(NamedPoses& flange, NamedPoses& target, const ConvertOptions& options, std::vector<Message>& notes);

/// The same for images and the poses of the flange.
void pair_images(NamedPoses& flange, std::vector<InstantImages>& images, int cameras, double lag,
                 std::vector<Message>& notes);

}  // namespace handsight
