// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of drivers that were used lately, and the simulated robot to try it with. Never from a session's file.
#pragma once

#include <QStringList>
#include <filesystem>

#include "session/session.h"

namespace handsight::app {

/// The latest first; what the user typed, kept with the window's preferences.
QStringList recent_drivers();
void remember_driver(const QString& command);

/// A session to try an experiment in: of the same robot and sensor, with its first observations alone, in a folder of
/// the user's own state, so that nothing invented comes among what was measured. InputError where it cannot be made.
std::filesystem::path session_to_try(const Session& session);
/// Was this session made by session_to_try?
bool is_to_try(const std::filesystem::path& session_file);

/// The command of handsight-driver-simulated as a robot that made this session, with a joint whose zero is off. Empty
/// where the program is not installed.
QString simulated_driver(const Session& session);

}  // namespace handsight::app
