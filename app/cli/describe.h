// SPDX-License-Identifier: Apache-2.0
// The command line in words of its own: manual page and completions of shells, made from what the parser knows.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace handsight::cli {

/// A manual page (roff, man(7)) of all commands and their options.
std::string manual_page(const CLI::App& app, const std::string& version);

/// Completion for `shell`: bash, zsh or fish.
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace handsight::cli
