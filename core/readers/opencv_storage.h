// SPDX-License-Identifier: Apache-2.0
// What OpenCV's FileStorage writes (YAML, XML, JSON), as far as calibrations need it. A reader of our own: OpenCV's
// crashes on files that are broken.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/message.h"

namespace handsight {

/// The numbers of one entry: a matrix row by row, a list (one column, or a row for each inner list or matrix), one
/// number.
struct StorageEntry {
  int rows = 0, cols = 0;
  std::vector<double> numbers;  // rows * cols of them
  Message fault;                // why the entry is no matrix of numbers; empty: it is one
};

/// The outermost entries by name; those that hold texts or whole structures have a fault. InputError where the text is
/// of none of the three kinds, is longer than 16 MB or is nested deeply; `file` is what the sentence calls it.
std::map<std::string, StorageEntry> parse_opencv_storage(const std::string& text, const std::string& file);

}  // namespace handsight
