// SPDX-License-Identifier: Apache-2.0
// The command line in words of its own: manual page and completions of shells, made from what the parser knows.
#pragma once

#include <string>

#include "options/command_line.h"

namespace handsight::cli {

/// A manual page (roff, man(7)) of all commands and their options.
std::string manual_page(const CommandLine& program, const std::string& version);

/// Completion for `shell`: bash, zsh or fish.
std::string completion(const CommandLine& program, const std::string& shell);

}  // namespace handsight::cli
