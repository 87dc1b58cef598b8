// SPDX-License-Identifier: GPL-3.0-or-later
// What the box of Ctrl+K finds in a session.
#pragma once

#include "window/find_box.h"
#include "workbench/workbench.h"

namespace handsight::app {

/// Every observation, the session's joints and the catalogue's effects; a choice selects the first two and opens
/// Explain for the last.
std::vector<FindEntry> session_entries(Workbench& workbench);

}  // namespace handsight::app
