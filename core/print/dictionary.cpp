// SPDX-License-Identifier: Apache-2.0
#include "print/dictionary.h"

#include <array>
#include <map>
#include <mutex>
#include <opencv2/aruco/dictionary.hpp>
#include <utility>

#include "base/error.h"

namespace handsight {
namespace {

constexpr std::array<std::string_view, 21> opencv_names{
    "DICT_4X4_50",        "DICT_4X4_100",        "DICT_4X4_250",       "DICT_4X4_1000",      "DICT_5X5_50",
    "DICT_5X5_100",       "DICT_5X5_250",        "DICT_5X5_1000",      "DICT_6X6_50",        "DICT_6X6_100",
    "DICT_6X6_250",       "DICT_6X6_1000",       "DICT_7X7_50",        "DICT_7X7_100",       "DICT_7X7_250",
    "DICT_7X7_1000",      "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_16h5", "DICT_APRILTAG_25h9", "DICT_APRILTAG_36h10",
    "DICT_APRILTAG_36h11"};

/// Index in OpenCV's list, and whether it is turned by half a turn; -1: none.
std::pair<int, bool> look_up(std::string_view name) {
  const bool is_apriltag = name.starts_with("tag");
  const std::string wanted = is_apriltag ? "DICT_APRILTAG_" + std::string(name.substr(3)) : std::string(name);
  for (std::size_t i = 0; i < opencv_names.size(); ++i)
    if (opencv_names[i] == wanted) return {static_cast<int>(i), is_apriltag};
  return {-1, false};
}

Dictionary load(std::string_view name, int index, bool is_turned) {
  const auto table = cv::aruco::getPredefinedDictionary(index);
  Dictionary dictionary{std::string(name), table->markerSize, {}};
  const int count = dictionary.bits * dictionary.bits;
  for (int id = 0; id < table->bytesList.rows; ++id) {
    const cv::Mat bits =
        cv::aruco::Dictionary::getBitsFromByteList(table->bytesList.rowRange(id, id + 1), dictionary.bits);
    std::uint64_t code = 0;
    for (int i = 0; i < count; ++i)
      if (bits.at<unsigned char>(i / dictionary.bits, i % dictionary.bits))
        code |= std::uint64_t{1} << (is_turned ? count - 1 - i : i);
    dictionary.codes.push_back(code);
  }
  return dictionary;
}

}  // namespace

const Dictionary* find_dictionary(std::string_view name) {
  static std::mutex mutex;
  static std::map<std::string, Dictionary, std::less<>> loaded;
  const std::lock_guard lock(mutex);
  if (const auto found = loaded.find(name); found != loaded.end()) return &found->second;
  const auto [index, is_turned] = look_up(name);
  if (index < 0) return nullptr;
  return &loaded.emplace(std::string(name), load(name, index, is_turned)).first->second;
}

const std::vector<std::string>& dictionary_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all(opencv_names.begin(), opencv_names.end());
    for (const char* name : {"tag16h5", "tag25h9", "tag36h10", "tag36h11"}) all.emplace_back(name);
    return all;
  }();
  return names;
}

TagPattern tag_pattern(const Dictionary& dictionary, int id, int border) {
  check(id >= 0 && id < static_cast<int>(dictionary.codes.size()), "tag {} is not in {}", id, dictionary.name);
  TagPattern pattern;
  pattern.side = dictionary.bits + 2 * border;
  pattern.white.assign(static_cast<std::size_t>(pattern.side) * pattern.side, false);
  const std::uint64_t code = dictionary.codes[static_cast<std::size_t>(id)];
  for (int row = 0; row < dictionary.bits; ++row)
    for (int column = 0; column < dictionary.bits; ++column)
      pattern.white[static_cast<std::size_t>((row + border) * pattern.side + column + border)] =
          (code >> (row * dictionary.bits + column)) & 1;
  return pattern;
}

TagPattern turned(const TagPattern& pattern, int quarter_turns) {
  TagPattern result = pattern;
  for (int turn = 0; turn < quarter_turns % 4; ++turn) {
    const TagPattern before = result;
    for (int row = 0; row < result.side; ++row)
      for (int column = 0; column < result.side; ++column)
        result.white[static_cast<std::size_t>(row * result.side + column)] =
            before.is_white(row, result.side - 1 - column);
  }
  return result;
}

}  // namespace handsight
