// SPDX-License-Identifier: Apache-2.0
// Targets on the command line.
#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "print/target.h"

namespace handsight::cli {

/// What was given: a kind and its numbers as options of their own, or all of it after --target.
struct TargetOptions {
  std::string kind, columns, rows, square, marker, tag, spacing, separation, diameter, size, dictionary, ids, layout,
      border, first_id;
  std::vector<std::string> whole;  // "charuco columns=8 rows=6 ...", <target kind="..." .../>, or a file with one
};

/// --kind --columns --rows ... ; with `whole_too` also --target.
void add_target_options(const CommandLine& command, TargetOptions& options, bool whole_too);

/// Was anything of a target given?
bool is_given(const TargetOptions& options);

/// InputError where it is none.
Target target_from(const TargetOptions& options);

}  // namespace handsight::cli
