// SPDX-License-Identifier: Apache-2.0
// A session put right, by the name of what was wrong with it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "session/session.h"

namespace handsight {

/// The session with the blunder ID[:WHERE] put right ("joint_sense:elbow"). Numbers that WHERE leaves out ("joint_zero:
/// a3", "euler_convention:flange") are found from the measurements. InputError for ids and places that there are not:
/// it names those that there are.
Session mended(const Session& session, const std::string& id_with_where);

/// Writes such a session, all blunders put right one after the other, into a new folder beside the old one, with its
/// robot, images and own effects; gives it back as it is read from there. InputError where there is a session already,
/// or where a file cannot be written.
Session write_mended(const Session& session, const std::vector<std::string>& ids, const std::filesystem::path& folder);

}  // namespace handsight
