// SPDX-License-Identifier: Apache-2.0
#include "targets/sheet.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "print/target_xml.h"

namespace handsight {
namespace {

constexpr double rim = 0.010;           // m, white, around everything
constexpr double below = 0.022;         // m, for the ruler and the texts
constexpr double line = 0.0002;         // m, of the ruler's lines
constexpr double text_height = 0.0028;  // m
constexpr double letter_width = 0.55;   // of the height, on average

struct Paper {
  const char* name;
  double width, height;  // m
};
constexpr Paper papers[] = {
    {"A4", 0.210, 0.297}, {"A3", 0.297, 0.420}, {"A2", 0.420, 0.594}, {"A1", 0.594, 0.841}, {"A0", 0.841, 1.189}};

/// What stands on the sheet before it has a place: top left at 0.
struct Arrangement {
  std::vector<Box> black;
  std::vector<SheetText> texts;
  std::vector<Vector2> origins;
  Vector2 size = Vector2::Zero();
};

Arrangement one_piece(const Target& target) {
  const PrintedPattern pattern = pattern_of(target);
  Arrangement a{pattern.black, {}, {-pattern.outline.top_left}, pattern.outline.size};
  for (Box& box : a.black) box.top_left -= pattern.outline.top_left;
  return a;
}

void add_tag(const Target& target, int piece, const Vector2& origin, Arrangement& a) {
  for (Box box : pattern_of(target, piece).black) {
    box.top_left += origin;
    a.black.push_back(box);
  }
  a.origins.push_back(origin);
}

/// An ArUco grid board: its tags where they lie.
Arrangement grid_of_tags(const Target& target) {
  Arrangement a;
  for (std::size_t k = 0; k < target.places.size(); ++k)
    add_tag(target, static_cast<int>(k), target.places[k].xyz.head<2>(), a);
  const double step = target.tag + target.separation;
  a.size = Vector2(target.columns * step, target.rows * step) - Vector2::Constant(target.separation);
  return a;
}

/// Tags side by side, as nearly square as they fill it, a third of a tag (at least 8 mm) between them.
Arrangement several_pieces(const Target& target) {
  Arrangement a;
  const std::vector<PlacedTag> tags = placed_tags(target);
  const auto count = static_cast<int>(tags.size());
  double largest = 0;
  for (const PlacedTag& tag : tags) largest = std::max(largest, tag.size);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count * 0.7)));
  const double gap = std::max(largest / 3, 0.008), step = largest + gap;
  for (int i = 0; i < count; ++i) {
    const PlacedTag& tag = tags[static_cast<std::size_t>(i)];
    const int column = i % columns, row = i / columns;
    const Vector2 top_left(column * step, row * step);
    add_tag(target, i, top_left + Vector2::Constant(0.5 * tag.size), a);
    a.texts.push_back(
        {top_left + Vector2(0, tag.size + 0.7 * gap), std::min(text_height, 0.4 * gap), fmt::format("{}", tag.id)});
  }
  const int rows = (count + columns - 1) / columns;
  a.size = Vector2(columns * step - gap, rows * step);
  return a;
}

/// `<target ... />` broken into lines of so many letters.
std::vector<std::string> reported(const Target& target, std::size_t most) {
  std::vector<std::string> words{"<target"}, lines{describe_target(target), ""};
  for (const auto& [name, text] : target_words(target)) words.push_back(fmt::format("{}=\"{}\"", name, text));
  words.emplace_back("/>");
  for (const std::string& word : words) {
    if (!lines.back().empty() && lines.back().size() + word.size() + 1 > most) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

void add_ruler(Sheet& sheet, const Vector2& at) {
  const int length_mm = std::min(100, static_cast<int>((sheet.width - 2 * rim) * 1e3) / 10 * 10);
  if (length_mm < 10) return;
  const double length = 1e-3 * length_mm;
  // Lines do not overlap: the ticks hang below the base line, each with its middle at its millimetre.
  sheet.black.push_back({at - Vector2(0.5 * line, 0), Vector2(length + line, line)});
  for (int mm = 0; mm <= length_mm; ++mm) {
    const double down = mm % 10 == 0 ? 0.004 : mm % 5 == 0 ? 0.003 : 0.002;
    sheet.black.push_back({at + Vector2(1e-3 * mm - 0.5 * line, line), Vector2(line, down)});
    if (mm % 50 == 0 || mm == length_mm)
      sheet.texts.push_back(
          {at + Vector2(1e-3 * mm + 0.001, 0.0065), 0.0025, fmt::format("{}{}", mm, mm == length_mm ? " mm" : "")});
  }
}

Sheet paper_for(const Vector2& needed) {
  for (const Paper& paper : papers) {
    if (needed.x() <= paper.width && needed.y() <= paper.height) return {paper.name, paper.width, paper.height};
    if (needed.x() <= paper.height && needed.y() <= paper.width)
      return {std::string(paper.name) + " landscape", paper.height, paper.width};
  }
  return {"own size", needed.x(), needed.y()};
}

}  // namespace

Sheet make_sheet(const Target& target) {
  check_target(target, "target");
  const Arrangement a = is_tag_grid(target)               ? grid_of_tags(target)
                        : target.kind == TargetKind::tags ? several_pieces(target)
                                                          : one_piece(target);
  Sheet sheet = paper_for({std::max(a.size.x(), 0.03) + 2 * rim, a.size.y() + 2 * rim + below});
  const Vector2 shift(0.5 * (sheet.width - a.size.x()), rim + 0.5 * (sheet.height - 2 * rim - below - a.size.y()));
  for (Box box : a.black) {
    box.top_left += shift;
    sheet.black.push_back(box);
  }
  for (SheetText text : a.texts) {
    text.at += shift;
    sheet.texts.push_back(text);
  }
  for (const Vector2& origin : a.origins) sheet.piece_origins.push_back(origin + shift);
  const double top = sheet.height - rim - below + 0.006;
  add_ruler(sheet, {rim, top});
  const auto most = static_cast<std::size_t>((sheet.width - 2 * rim) / (text_height * letter_width));
  double y = top + 0.0105;
  for (const std::string& text : reported(target, most)) {
    sheet.texts.push_back({{rim, y}, 0.9 * text_height, text});
    y += 0.95 * text_height;
  }
  return sheet;
}

}  // namespace handsight
