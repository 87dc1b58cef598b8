// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of the versions of a session's model, remembered from start to start, so that a session that is opened
// again shows how it came to where it is. Beside the journal; losing it loses a picture and nothing else.
#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

#include "estimation/report/fit_report.h"

namespace handsight::app {

/// The model after so many actions.
struct RememberedStair {
  int index = 0;   // of the undo stack
  QString action;  // the last of them as the undo stack names it: the stair is only true after just this one
  QString cause;
  ErrorSummary fitted, held_out;
};

/// Empty where nothing is remembered, or it cannot be read.
std::vector<RememberedStair> remembered_stairs(const std::filesystem::path& session_file);
void remember_stairs(const std::filesystem::path& session_file, const std::vector<RememberedStair>& stairs);

}  // namespace handsight::app
