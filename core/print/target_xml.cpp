// SPDX-License-Identifier: Apache-2.0
#include "print/target_xml.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "print/circle_grid.h"
#include "print/tag_places_xml.h"

namespace handsight {
namespace {

using Words = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view grid = "grid";  // an ArUco grid board: tags with places

bool is_of_kind(const Words& words, std::string_view kind) {
  return std::any_of(words.begin(), words.end(),
                     [&](const auto& word) { return word.first == "kind" && word.second == kind; });
}
bool is_grid(const Words& words) { return is_of_kind(words, grid); }
bool is_circles(const Words& words) { return is_of_kind(words, circles_kind); }

/// What a kind of target cannot be described without.
const std::vector<std::string_view>& needed_words(TargetKind kind, const Words& words) {
  static const std::vector<std::string_view> of_grid{"columns", "rows", "marker", "separation", "dictionary"},
      of_circles{"columns", "rows", "spacing", "diameter", "layout"};
  if (is_grid(words)) return of_grid;
  if (is_circles(words)) return of_circles;
  static const std::array<std::vector<std::string_view>, 4> all{{
      {"columns", "rows", "square"},
      {"columns", "rows", "square", "marker", "dictionary"},
      {"columns", "rows", "tag", "spacing"},
      {"dictionary", "size", "ids"},
  }};
  return all[static_cast<std::size_t>(kind)];
}

const std::string* find(const Words& words, std::string_view name) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.first == name; });
  return found == words.end() ? nullptr : &found->second;
}

[[noreturn]] void refuse_word(std::string_view where, std::string_view name, const std::string& text,
                              const Message& expected) {
  throw InputError(
      message("{}: {} is {}; expected {}.", looked_up(std::string(where)), name, in_quotes(text), expected));
}

void take_integer(const Words& words, std::string_view where, std::string_view name, int& into) {
  const std::string* text = find(words, name);
  if (!text) return;
  const auto number = parse_integer(*text);
  if (!number || *number < -2147483647 || *number > 2147483647) refuse_word(where, name, *text, "an integer");
  into = static_cast<int>(*number);
}

void take_number(const Words& words, std::string_view where, std::string_view name, double& into) {
  const std::string* text = find(words, name);
  if (!text) return;
  const auto number = parse_number(*text);
  if (!number) refuse_word(where, name, *text, "one finite number");
  into = *number;
}

std::vector<int> ids_from(const std::string& text, std::string_view where) {
  std::vector<int> ids;
  for (const std::string_view word : split_words(text)) {
    const auto id = parse_integer(word);
    if (!id || *id < 0 || *id > 1000000)
      refuse_word(where, "ids", std::string(word), "numbers of tags, for example \"3 7 9\"");
    ids.push_back(static_cast<int>(*id));
  }
  return ids;
}

void take_sigma(const Words& words, std::string_view where, Target& target) {
  const std::string* text = find(words, "sigma");
  if (!text) return;
  if (*text == "free") {
    target.sigma.reset();
    return;
  }
  const auto number = parse_number(*text);
  if (!number) refuse_word(where, "sigma", *text, "a length in m, or \"free\"");
  target.sigma = *number;
}

void take_layout(const Words& words, std::string_view where, Target& target) {
  const std::string* text = find(words, "layout");
  if (!text) return;
  if (is_circles(words)) {
    if (*text != "symmetric" && *text != "asymmetric")
      refuse_word(where, "layout", *text, "symmetric or asymmetric, how the rows of circles stand");
    target.dictionary = *text;
    return;
  }
  if (*text != "old" && *text != "new") refuse_word(where, "layout", *text, "\"old\" (OpenCV before 4.6) or \"new\"");
  target.old_layout = *text == "old";
}

TargetKind kind_from(const Words& words, std::string_view where) {
  constexpr const char* kinds = "chessboard, charuco, circles, aprilgrid, grid or tags";
  const std::string* text = find(words, "kind");
  if (!text) throw InputError(message("{}: it has no kind; expected {}.", looked_up(std::string(where)), kinds));
  if (*text == grid) return TargetKind::tags;
  if (*text == circles_kind) return TargetKind::chessboard;
  const auto kind = target_kind(*text);
  if (!kind) refuse_word(where, "kind", *text, kinds);
  return *kind;
}

void require_words(const Words& words, TargetKind kind, std::string_view where) {
  const auto& needed = needed_words(kind, words);
  for (const std::string_view name : needed)
    if (!find(words, name))
      throw InputError(message("{}: a target of kind {} needs {}, which is missing; expected {}.",
                               looked_up(std::string(where)),
                               is_grid(words)      ? grid
                               : is_circles(words) ? circles_kind
                                                   : display_name(kind),
                               name, fmt::join(needed, ", ")));
}

/// The tags of a grid board, each known to lie there within the target's sigma.
void take_grid(const Words& words, std::string_view where, Target& target) {
  take_number(words, where, "separation", target.separation);
  check_grid(target, where);
  lay_out_grid(target);
  double sigma_angle = 0;
  take_number(words, where, "sigma_angle", sigma_angle);
  for (TagPlace& place : target.places) {
    place.sigma = target.sigma.value_or(0);
    place.sigma_angle = find(words, "sigma_angle") ? sigma_angle : usual_sigma_angle(place);
  }
  if (target.sigma) target.sigma = 0;
}

/// What the words say, not yet checked.
Target reported_by(const Words& words, std::string_view where) {
  Target target;
  target.kind = kind_from(words, where);
  if (target.kind == TargetKind::aprilgrid) target.dictionary = "tag36h11", target.border = 2;
  take_integer(words, where, "columns", target.columns);
  take_integer(words, where, "rows", target.rows);
  take_integer(words, where, "border", target.border);
  take_integer(words, where, "first_id", target.first_id);
  take_number(words, where, "square", target.square);
  if (!is_circles(words)) take_number(words, where, "spacing", target.spacing);
  for (const char* name : {"marker", "tag", "size"})
    if (const auto& needed = needed_words(target.kind, words);
        std::find(needed.begin(), needed.end(), name) != needed.end())
      take_number(words, where, name, target.tag);
  if (is_circles(words)) take_number(words, where, "spacing", target.square);
  if (is_circles(words)) take_number(words, where, "diameter", target.tag);
  if (const std::string* name = find(words, "dictionary"); name && target.kind != TargetKind::chessboard)
    target.dictionary = *name;
  if (const std::string* ids = find(words, "ids")) target.ids = ids_from(*ids, where);
  take_layout(words, where, target);
  take_sigma(words, where, target);
  if (target.kind == TargetKind::tags && !is_grid(words)) target.columns = target.rows = 0;
  return target;
}

Target read_tags(const XmlNode& node, const Words& words, std::string_view where) {
  if (find(words, "ids"))
    throw InputError(
        message("{}: it has ids and <tag> elements; expected one of the two.", looked_up(std::string(where))));
  if (!find(words, "dictionary"))
    throw InputError(
        message("{}: a target of kind tags needs dictionary, which is missing; expected dictionary and a <tag> "
                "element for every tag.",
                looked_up(std::string(where))));
  Target target = reported_by(words, where);
  read_tag_places(node, target);
  check_target(target, where);
  return target;
}

}  // namespace

Target target_from_words(const Words& words, std::string_view where) {
  require_words(words, kind_from(words, where), where);
  Target target = reported_by(words, where);
  if (is_grid(words)) take_grid(words, where, target);
  check_target(target, where);
  return target;
}

Target read_target(const XmlNode& node) {
  Words words;
  for (const auto* a = node.element->FirstAttribute(); a; a = a->Next())
    words.emplace_back(a->Name(), required_text(node, a->Name()));
  const std::string where = fmt::format("{}, line {}: <{}>", node.file, node.line(), node.tag());
  const bool has_tags = kind_from(words, where) == TargetKind::tags && !is_grid(words) && find_tag(node);
  return has_tags ? read_tags(node, words, where) : target_from_words(words, where);
}

const std::vector<std::string>& target_attributes() {
  static const std::vector<std::string> all{"kind",    "columns",    "rows",       "square",      "marker",  "tag",
                                            "spacing", "separation", "dictionary", "size",        "ids",     "border",
                                            "layout",  "first_id",   "sigma",      "sigma_angle", "diameter"};
  return all;
}

namespace {

Words circles_words(const Target& target) {
  return {{"kind", std::string(circles_kind)},     {"columns", std::to_string(target.columns)},
          {"rows", std::to_string(target.rows)},   {"spacing", format_number(target.square)},
          {"diameter", format_number(target.tag)}, {"layout", target.dictionary}};
}

Words kind_words(const Target& target) {
  if (is_circle_grid(target)) return circles_words(target);
  const bool is_grid = is_tag_grid(target);
  Words words{{"kind", std::string(is_grid ? grid : display_name(target.kind))}};
  const auto add = [&](const char* name, std::string text) { words.emplace_back(name, std::move(text)); };
  if (target.kind != TargetKind::tags || is_grid) {
    add("columns", std::to_string(target.columns));
    add("rows", std::to_string(target.rows));
  }
  const bool has_squares = target.kind == TargetKind::chessboard || target.kind == TargetKind::charuco;
  if (has_squares) add("square", format_number(target.square));
  if (target.kind == TargetKind::charuco || is_grid) add("marker", format_number(target.tag));
  if (is_grid) add("separation", format_number(target.separation));
  if (target.kind == TargetKind::aprilgrid)
    add("tag", format_number(target.tag)), add("spacing", format_number(target.spacing));
  if (target.kind != TargetKind::chessboard) add("dictionary", target.dictionary);
  if (target.kind == TargetKind::tags && !is_grid) add("size", format_number(target.tag));
  if (target.kind == TargetKind::tags && target.places.empty())
    add("ids", fmt::format("{}", fmt::join(target.ids, " ")));
  return words;
}

}  // namespace

Words target_words(const Target& target) {
  Words words = kind_words(target);
  const auto add = [&](const char* name, std::string text) { words.emplace_back(name, std::move(text)); };
  if (target.kind != TargetKind::chessboard && target.border != (target.kind == TargetKind::aprilgrid ? 2 : 1))
    add("border", std::to_string(target.border));
  if (target.old_layout) add("layout", "old");
  if (target.first_id != 0) add("first_id", std::to_string(target.first_id));
  if (is_tag_grid(target) && target.places.front().sigma_angle != 0)
    add("sigma_angle", format_number(target.places.front().sigma_angle));
  const std::optional<double> sigma =
      is_tag_grid(target) && target.sigma ? std::optional(target.places.front().sigma) : target.sigma;
  if (!sigma)
    add("sigma", "free");
  else if (*sigma != 0)
    add("sigma", format_number(*sigma));
  return words;
}

void write_target(tinyxml2::XMLElement& element, const Target& target) {
  for (const auto& [name, text] : target_words(target)) element.SetAttribute(name.c_str(), text.c_str());
  if (!is_tag_grid(target)) write_tag_places(element, target);
}

}  // namespace handsight
