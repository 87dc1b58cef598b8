// SPDX-License-Identifier: Apache-2.0
// The tags that are in use: OpenCV's ArUco dictionaries and the AprilTag families among them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace handsight {

/// Tags of bits x bits modules. Bit row * bits + column of a code is 1 where the module is white.
struct Dictionary {
  std::string name;
  int bits = 0;
  std::vector<std::uint64_t> codes;  // by id
};

/// By OpenCV's name (DICT_4X4_50 ... DICT_APRILTAG_36h11), or AprilTag's own (tag16h5, tag25h9, tag36h10, tag36h11), of
/// which the first are the same turned by half a turn. Null where it is none.
const Dictionary* find_dictionary(std::string_view name);

/// All names, OpenCV's order.
const std::vector<std::string>& dictionary_names();

/// A tag's modules row by row, border included, true where white.
struct TagPattern {
  int side = 0;  // modules
  std::vector<bool> white;

  bool is_white(int column, int row) const { return white[static_cast<std::size_t>(row * side + column)]; }
};
TagPattern tag_pattern(const Dictionary& dictionary, int id, int border);

/// The same after quarter turns clockwise.
TagPattern turned(const TagPattern& pattern, int quarter_turns);

}  // namespace handsight
