// SPDX-License-Identifier: Apache-2.0
// What another program says.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace handsight {

struct ProgramOutput {
  int status = 0;  // its exit code; 128 and the signal's number where one ended it
  std::string out, err;
};

/// Runs a program (found in PATH, no shell between) with these arguments and nothing to read; nothing where it is not
/// installed. It is ended after `seconds`, and where it says more than 64 MiB.
std::optional<ProgramOutput> run_for_output(const std::vector<std::string>& command, int seconds);

}  // namespace handsight
