// SPDX-License-Identifier: Apache-2.0
// Which of many files belong to which of several sessions, by their names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace handsight {

/// The files of each session, in the order given: a file in whose path (below the folder that holds them all) stands a
/// word of a session is that session's alone, of several sessions theirs whose word is the longest; what names none is
/// of all, and so are robots. A word stands there whole, between other signs than letters and digits: "left_hand" in
/// "left_hand/points.csv", not in "left_hands.csv".
std::vector<std::vector<std::filesystem::path>> files_of_sessions(
    const std::vector<std::filesystem::path>& files, const std::vector<std::vector<std::string>>& words_of_sessions);

}  // namespace handsight
