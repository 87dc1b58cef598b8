// SPDX-License-Identifier: Apache-2.0
#include "target_option.h"

#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "targets/target_xml.h"

namespace handsight::cli {
namespace {

using Words = std::vector<std::pair<std::string, std::string>>;

Target target_from_xml(const std::string& text) {
  const auto document = parse_xml(text, "--target");
  return read_target(root_of(*document, "--target", "target"));
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
      throw InputError(
          fmt::format("--target: {} is no NAME=VALUE; expected, for example, charuco columns=8 rows=6 square=0.03 "
                      "marker=0.022 dictionary=DICT_5X5_100.",
                      in_quotes(word)));
    else
      words.emplace_back(word.substr(0, equals), word.substr(equals + 1));
  }
  for (auto& [name, value] : words)
    if (name == "ids") std::replace(value.begin(), value.end(), ',', ' ');
  return words;
}

}  // namespace

void add_target_options(CLI::App& app, TargetOptions& o, bool whole_too) {
  if (whole_too)
    app.add_option(
        "--target", o.whole,
        "The target: its kind and NAME=VALUE of the options below, or the element <target .../> of a session");
  app.add_option("--kind", o.kind, "chessboard, charuco, aprilgrid or tags");
  app.add_option("--columns", o.columns,
                 "Inner corners of a chessboard, squares of a charuco, tags of an aprilgrid, in a row");
  app.add_option("--rows", o.rows, "The same, in a column");
  app.add_option("--square", o.square, "m, side of a square (chessboard, charuco)");
  app.add_option("--marker", o.marker, "m, side of a charuco's tags");
  app.add_option("--tag", o.tag, "m, side of an aprilgrid's tags");
  app.add_option("--spacing", o.spacing, "Gap between an aprilgrid's tags / side of a tag");
  app.add_option("--size", o.size, "m, side of single tags");
  app.add_option("--dictionary", o.dictionary,
                 "DICT_4X4_50 ... DICT_APRILTAG_36h11 as in OpenCV, or AprilTag's tag36h11");
  app.add_option("--ids", o.ids, "Numbers of single tags, for example \"3 7 9\"");
  app.add_option("--layout", o.layout, "old: charuco as OpenCV before 4.6 drew it");
  app.add_option("--border", o.border, "Modules of black around a tag: 1, 2 for an aprilgrid");
  app.add_option("--first-id", o.first_id, "Number of the first tag of a charuco or an aprilgrid");
}

Target target_from(const TargetOptions& o) {
  std::string whole;
  for (const std::string& word : o.whole) whole += (whole.empty() ? "" : " ") + word;
  if (whole.starts_with('<')) return target_from_xml(whole);
  Words words = words_from(whole);
  for (const auto& [name, text] :
       std::initializer_list<std::pair<const char*, const std::string&>>{{"kind", o.kind},
                                                                         {"columns", o.columns},
                                                                         {"rows", o.rows},
                                                                         {"square", o.square},
                                                                         {"marker", o.marker},
                                                                         {"tag", o.tag},
                                                                         {"spacing", o.spacing},
                                                                         {"size", o.size},
                                                                         {"dictionary", o.dictionary},
                                                                         {"ids", o.ids},
                                                                         {"layout", o.layout},
                                                                         {"border", o.border},
                                                                         {"first_id", o.first_id}})
    if (!text.empty()) words.emplace_back(name, text);
  return target_from_words(words, "The target");
}

}  // namespace handsight::cli
