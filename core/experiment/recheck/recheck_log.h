// SPDX-License-Identifier: Apache-2.0
// The log of rechecks: a CSV file to which a line is added for every observation, and which is read for its history.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/message.h"
#include "compare/watch_step.h"

namespace handsight {

/// One number, by how much it would have changed if it alone had.
struct RecheckNumber {
  std::string what, where, name;  // "joint_offset", "a3", "offset"; where may be empty
  double value = 0, sigma = 0;
  std::string unit;  // of the catalogue: "m", "rad"
};

/// One line of the log.
struct RecheckEntry {
  std::string utc;  // "2026-11-26T05:09:00Z"
  std::int64_t id = 0;
  double e_value = 0;
  bool changed = false;
  std::string what, where;             // the likeliest change, as WatchStep has it
  Message text;                        // with its parts, so that it is said in the reader's language
  std::vector<RecheckNumber> numbers;  // of mount, body and joint zeros
};

/// The e-value itself, as large as a number can be.
double compute_e_value(const WatchStep& step);

RecheckEntry recheck_entry(const std::string& utc, std::int64_t id, const WatchStep& step);

/// A line more, with a header where the file is new. A log that was begun without numbers or without the parts of its
/// texts goes on without them.
/// InputError where it cannot be written.
void add_to_log(const std::filesystem::path& csv, const RecheckEntry& entry);

/// All lines, the oldest first; none where there is no such file. InputError names file and line.
std::vector<RecheckEntry> read_recheck_log(const std::filesystem::path& csv);

}  // namespace handsight
