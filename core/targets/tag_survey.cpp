// SPDX-License-Identifier: Apache-2.0
#include "targets/tag_survey.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include "base/error.h"
#include "print/dictionary.h"
#include "targets/tag_reading.h"

namespace handsight {
namespace {

constexpr double least_side = 9;      // px
constexpr float least_contrast = 25;  // grey levels

/// Dictionaries that are not the beginning of a larger one.
constexpr std::array<const char*, 9> families{"DICT_4X4_1000",      "DICT_5X5_1000",       "DICT_6X6_1000",
                                              "DICT_7X7_1000",      "DICT_ARUCO_ORIGINAL", "DICT_APRILTAG_16h5",
                                              "DICT_APRILTAG_25h9", "DICT_APRILTAG_36h10", "DICT_APRILTAG_36h11"};

/// The bits of a tag with its black border, row by row from the quad's first corner; nothing where the border is not
/// black.
std::optional<std::uint64_t> bits_of(const std::vector<float>& modules, int bits, int border) {
  const int side = bits + 2 * border;
  float black = 0, white = 0;
  int rim = 0;
  const auto at = [&](int row, int column) { return modules[static_cast<std::size_t>(row * side + column)]; };
  const auto is_rim = [&](int row, int column) {
    return std::min({row, column, side - 1 - row, side - 1 - column}) < border;
  };
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      if (is_rim(row, column))
        black += at(row, column), ++rim;
      else
        white = std::max(white, at(row, column));
  black /= static_cast<float>(rim);
  if (white - black < least_contrast) return std::nullopt;
  const float middle = 0.5F * (black + white);
  std::uint64_t code = 0;
  int bright = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const bool is_white = at(row, column) > middle;
      if (is_rim(row, column))
        bright += is_white;
      else if (is_white)
        code |= std::uint64_t{1} << ((row - border) * bits + column - border);
    }
  return bright <= 1 ? std::optional(code) : std::nullopt;
}

std::uint64_t turned_bits(std::uint64_t code, int bits) {
  std::uint64_t result = 0;
  for (int row = 0; row < bits; ++row)
    for (int column = 0; column < bits; ++column)
      if ((code >> ((bits - 1 - column) * bits + row)) & 1) result |= std::uint64_t{1} << (row * bits + column);
  return result;
}

/// Id, and by how many quarter turns clockwise the tag stands turned in the quad.
std::optional<std::pair<int, int>> looked_up(const Dictionary& dictionary, std::uint64_t seen) {
  const int most_wrong = dictionary.bits <= 4 ? 0 : dictionary.bits - 4;
  std::optional<std::pair<int, int>> found;
  int least = most_wrong + 1;
  std::array<std::uint64_t, 4> turns{seen};
  // What a turn of the tag has done is undone by three more.
  for (std::size_t i = 1; i < 4; ++i) turns[i] = turned_bits(turns[i - 1], dictionary.bits);
  for (std::size_t id = 0; id < dictionary.codes.size(); ++id)
    for (int turn = 0; turn < 4; ++turn)
      if (const int wrong = std::popcount(turns[static_cast<std::size_t>((4 - turn) % 4)] ^ dictionary.codes[id]);
          wrong < least)
        least = wrong, found = {static_cast<int>(id), turn};
  return found;
}

/// The same square at the same place once.
std::vector<Quad> without_doubles(const std::vector<Quad>& quads) {
  std::vector<Quad> kept;
  for (const Quad& quad : quads) {
    const Vector2 centre = 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
    const double side = (quad[0] - quad[2]).norm();
    const bool is_known = std::any_of(kept.begin(), kept.end(), [&](const Quad& other) {
      return (0.25 * (other[0] + other[1] + other[2] + other[3]) - centre).norm() < 0.15 * side &&
             std::abs((other[0] - other[2]).norm() - side) < 0.15 * side;
    });
    if (!is_known) kept.push_back(quad);
  }
  return kept;
}

struct Way {
  std::string dictionary;
  int border = 1;
  bool is_inverted = false, is_mirrored = false;
  auto operator<=>(const Way&) const = default;  // NOLINT(modernize-use-nullptr): not of the code
};

/// Clockwise again in the mirrored image, from the same corner.
Quad mirrored_quad(const Quad& quad, int width) {
  Quad result{quad[0], quad[3], quad[2], quad[1]};
  for (Vector2& corner : result) corner.x() = width - 1 - corner.x();
  return result;
}

/// A tag that is read from two squares at the same place is one.
void add_once(std::vector<SurveyedTag>& tags, const SurveyedTag& tag) {
  const bool is_there = std::any_of(tags.begin(), tags.end(), [&](const SurveyedTag& other) {
    return other.id == tag.id && (other.corners[0] - tag.corners[0]).norm() < (tag.corners[0] - tag.corners[2]).norm();
  });
  if (!is_there) tags.push_back(tag);
}

void read_all(const Image& image, bool is_inverted, std::map<Way, std::vector<SurveyedTag>>& by_way) {
  const std::vector<Quad> quads = without_doubles(find_quads(image, least_side));
  const Image in_mirror = mirrored(image);
  for (const bool is_mirrored : {false, true})
    for (const Quad& found : quads) {
      const Quad quad = is_mirrored ? mirrored_quad(found, image.width) : found;
      std::map<int, std::vector<float>> modules;  // by their number along a side
      for (const char* name : families) {
        const Dictionary& dictionary = *find_dictionary(name);
        for (const int border : {1, 2}) {
          const int side = dictionary.bits + 2 * border;
          if ((quad[0] - quad[2]).norm() < 1.2 * 1.41 * side) continue;
          if (!modules.contains(side)) modules[side] = module_values(is_mirrored ? in_mirror : image, quad, side);
          const auto bits = bits_of(modules[side], dictionary.bits, border);
          const auto read = bits ? looked_up(dictionary, *bits) : std::nullopt;
          if (!read) continue;
          SurveyedTag tag{read->first, {}};
          for (std::size_t i = 0; i < 4; ++i) tag.corners[i] = quad[(i + static_cast<std::size_t>(read->second)) % 4];
          add_once(by_way[{name, border, is_inverted, is_mirrored}], tag);
        }
      }
    }
}

}  // namespace

Image mirrored(const Image& image) {
  Image result = image;
  for (int v = 0; v < image.height; ++v) std::reverse(result.row(v), result.row(v) + image.width);
  return result;
}

Image inverted(const Image& image) {
  Image result = image;
  for (std::uint8_t& pixel : result.pixels) pixel = static_cast<std::uint8_t>(255 - pixel);
  return result;
}

TagSurvey survey_tags(const Image& image) {
  std::map<Way, std::vector<SurveyedTag>> by_way;
  read_all(image, false, by_way);
  read_all(inverted(image), true, by_way);
  TagSurvey best;
  for (auto& [way, tags] : by_way)
    if (tags.size() > best.tags.size()) best = {way.dictionary, way.border, way.is_inverted, way.is_mirrored, tags};
  return best;
}

std::string smallest_dictionary(const std::string& largest, int id) {
  const auto end = largest.rfind("_1000");
  if (end == std::string::npos) return largest;
  for (const int size : {50, 100, 250})
    if (id < size) return largest.substr(0, end + 1) + std::to_string(size);
  return largest;
}

}  // namespace handsight
