// SPDX-License-Identifier: Apache-2.0
#include "target_option.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

#include "base/error.h"
#include "base/files.h"
#include "base/numbers.h"
#include "base/text.h"
#include "print/target_xml.h"
#include "readers/kalibr_target.h"
#include "readers/yaml_text.h"

namespace handsight::cli {
namespace {

using Words = std::vector<std::pair<std::string, std::string>>;

Target target_from_xml(const std::string& text) {
  const auto document = parse_xml(text, "--target");
  return read_target(require_root(*document, "--target", "target"));
}

/// Of a file that is a <target>, or a session's.
Target target_from_xml_file(const std::string& file) {
  const auto document = parse_xml(read_file(file), file);
  const tinyxml2::XMLElement* root = document->RootElement();
  if (root && std::string_view(root->Name()) == "handsight_session")
    return read_target(required_child(require_root(*document, file, "handsight_session"), "target"));
  return read_target(require_root(*document, file, "target"));
}

/// A target of this kind in words.
const char* example_of(const std::string& kind) {
  constexpr std::pair<const char*, const char*> examples[] = {
      {"chessboard", "chessboard columns=9 rows=6 square=25mm"},
      {"circles", "circles columns=4 rows=11 spacing=20mm diameter=15mm layout=asymmetric"},
      {"aprilgrid", "aprilgrid columns=6 rows=6 tag=25mm spacing=0.3"},
      {"grid", "grid columns=5 rows=7 marker=30mm separation=8mm dictionary=DICT_6X6_250"},
      {"tags", "tags dictionary=tag36h11 size=50mm ids=3,7,9"}};
  for (const auto& [name, example] : examples)
    if (kind == name) return example;
  return "charuco columns=8 rows=6 square=30mm marker=22mm dictionary=DICT_5X5_100";
}

/// "25mm" and "2.5cm" in metres; other words as they are.
std::string in_metres(const std::string& value) {
  for (const auto& [unit, metre] : {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}}) {
    if (!value.ends_with(unit)) continue;
    const auto number = parse_number(std::string_view(value).substr(0, value.size() - std::strlen(unit)));
    if (number) return format_number(*number * metre);
  }
  return value;
}

/// "charuco columns=8 ...": the kind first, or kind=charuco.
Words words_from(const std::string& text) {
  Words words;
  for (const std::string_view word : split_words(text)) {
    const auto equals = word.find('=');
    if (equals == std::string_view::npos && words.empty())
      words.emplace_back("kind", word);
    else if (equals == std::string_view::npos && words.back().first == "ids")
      words.back().second += ' ' + std::string(word);
    else if (equals == std::string_view::npos)
      throw InputError(message("--target: {} is no NAME=VALUE; expected, for example, {}.", in_quotes(word),
                               example_of(words.front().second)));
    else
      words.emplace_back(word.substr(0, equals), word.substr(equals + 1));
  }
  for (auto& [name, value] : words)
    if (name == "ids") std::replace(value.begin(), value.end(), ',', ' ');
  return words;
}

/// "square=25" is a board of 25 m a square.
void require_likely_lengths(const Words& words) {
  constexpr double longest = 5;  // m; a house's front is measured otherwise
  const bool is_of_tags = std::any_of(
      words.begin(), words.end(), [](const auto& word) { return word.first == "kind" && word.second == "aprilgrid"; });
  for (const auto& [name, value] : words) {
    const bool is_length = name == "square" || name == "marker" || name == "tag" || name == "size" ||
                           name == "diameter" || name == "separation" || (name == "spacing" && !is_of_tags);
    const auto number = is_length ? parse_number(value) : std::nullopt;
    if (number && *number > longest)
      throw InputError(message("The target: {}={} would be {} m; say the unit, {}={}mm where millimetres are meant.",
                               name, value, value, name, value));
  }
}

/// Kalibr's description, where the words are a file's name.
std::optional<Target> target_from_yaml_file(const std::string& name) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error)) return std::nullopt;
  const std::string file = shown_path(std::filesystem::path(name).filename());
  const YAML::Node yaml = parse_yaml(read_file(name), file);
  if (!is_kalibr_target(yaml))
    throw InputError(message("--target {}: has no target_type; expected Kalibr's description of a target.", file));
  return read_kalibr_target(yaml, file);
}

/// An option that stands for one NAME=VALUE of a target.
struct TargetWord {
  const char *option, *name;
  std::string TargetOptions::*value;
  const char* text;
};
constexpr TargetWord target_words[] = {
    {"--kind", "kind", &TargetOptions::kind, "chessboard, charuco, circles, aprilgrid, grid (of ArUco tags) or tags"},
    {"--columns", "columns", &TargetOptions::columns,
     "Inner corners of a chessboard, squares of a charuco, circles, tags of an aprilgrid or a grid, in a row"},
    {"--rows", "rows", &TargetOptions::rows, "The same, in a column"},
    {"--square", "square", &TargetOptions::square, "m, side of a square (chessboard, charuco)"},
    {"--marker", "marker", &TargetOptions::marker, "m, side of the tags of a charuco or a grid"},
    {"--tag", "tag", &TargetOptions::tag, "m, side of an aprilgrid's tags"},
    {"--spacing", "spacing", &TargetOptions::spacing,
     "Gap between an aprilgrid's tags / side of a tag; of circles: m, OpenCV's unit (their step; half of it along a "
     "row "
     "of an asymmetric grid)"},
    {"--diameter", "diameter", &TargetOptions::diameter, "m, of a circle"},
    {"--separation", "separation", &TargetOptions::separation, "m, between two tags of a grid"},
    {"--size", "size", &TargetOptions::size, "m, side of single tags"},
    {"--dictionary", "dictionary", &TargetOptions::dictionary,
     "DICT_4X4_50 ... DICT_APRILTAG_36h11 as in OpenCV, or AprilTag's tag36h11"},
    {"--ids", "ids", &TargetOptions::ids, "Numbers of single tags, for example \"3 7 9\""},
    {"--layout", "layout", &TargetOptions::layout,
     "old: charuco as OpenCV before 4.6 drew it; symmetric or asymmetric: how circles stand"},
    {"--border", "border", &TargetOptions::border, "Modules of black around a tag: 1, 2 for an aprilgrid"},
    {"--first-id", "first_id", &TargetOptions::first_id,
     "Number of the first tag of a charuco, an aprilgrid or a grid"}};

}  // namespace

bool is_given(const TargetOptions& o) { return !o.whole.empty() || !o.kind.empty(); }

void add_target_options(const CommandLine& command, TargetOptions& o, bool whole_too) {
  if (whole_too)
    command.option(
        "--target", o.whole,
        "The target: its kind and NAME=VALUE of the options below, the element <target .../> of a session, an XML file "
        "with it, or Kalibr's YAML of it");
  for (const TargetWord& word : target_words) command.option(word.option, o.*word.value, word.text);
}

Target target_from(const TargetOptions& o) {
  std::string whole;
  for (const std::string& word : o.whole) whole += (whole.empty() ? "" : " ") + word;
  if (whole.starts_with('<')) return target_from_xml(whole);
  if (whole.ends_with(".xml")) return target_from_xml_file(whole);
  if (const auto target = target_from_yaml_file(whole)) return *target;
  Words words = words_from(whole);
  for (const TargetWord& word : target_words)
    if (!(o.*word.value).empty()) words.emplace_back(word.name, o.*word.value);
  require_likely_lengths(words);
  for (auto& [name, value] : words) value = in_metres(value);
  return target_from_words(words, "The target");
}

}  // namespace handsight::cli
