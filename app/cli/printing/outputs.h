// SPDX-License-Identifier: Apache-2.0
// Where results may go: new files and regular ones, never over what the run has read or what a session consists of.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "session/session.h"

namespace handsight::cli {

/// Remembers a file that the run reads: no output goes there.
void note_input(const std::filesystem::path& file);

/// The same for all files of a session: its XML, robot, images, truth and own effects.
void note_inputs(const Session& session);

/// InputError where nothing may be written there; empty and "-" are always right. Called before the work begins, so
/// that nobody waits for a result that has no place.
void require_output(const std::string& file, const char* option);

/// Replaces (or makes) the file, whole or not at all, after the same question.
void write_output(const std::string& file, std::string_view content, const char* option);

}  // namespace handsight::cli
