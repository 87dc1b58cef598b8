// SPDX-License-Identifier: Apache-2.0
#include "base/xml.h"

#include <algorithm>
#include <climits>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {

namespace {

const char* xml_error(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an element is closed by another name or not at all";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute stands twice or is not written as name=\"value\"";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "a text does not end";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "a CDATA section is not closed";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "an XML declaration is misplaced or not closed";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply";
    default:
      return "an element is broken off or misplaced";
  }
}

int line_of_byte(std::string_view text, std::size_t position) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

Message with_attribute(const char* attribute, std::string_view value) {
  return message("has {}={}", verbatim(attribute), in_quotes(value, 80));
}

/// A URDF that is still to be made from a xacro file is a common mistake.
const char* xacro_hint(std::string_view value) {
  return value.find("${") == std::string_view::npos ? "" : " (is this a xacro file? Make a URDF of it first)";
}

void require_utf8(const XmlNode& node, std::string_view value) {
  if (!is_utf8(value)) refuse(node, "holds bytes that are not UTF-8, expected UTF-8 text.");
}

/// Refuses text outside the outermost element, and what follows a closing tag too many. The last node is
/// <end/>.
void refuse_outside(const tinyxml2::XMLDocument& document, std::string_view file) {
  const tinyxml2::XMLNode* last = document.LastChild();
  for (auto* node = document.FirstChild(); node; node = node->NextSibling())
    if (node->ToText())
      refuse(file, node->GetLineNum(),
             message("the text {} stands outside of the outermost element, expected only comments there.",
                     in_quotes(fmt::format("{}", fmt::join(split_words(node->Value()), " ")))));
  if (!last || !last->ToElement() || last->Value() != std::string_view("end"))
    refuse(file, last ? last->GetLineNum() : 0,
           "a closing tag too many stands after what begins here, expected well-formed XML.");
}

double as_number(const XmlNode& node, const char* attribute, std::string_view text, const char* expected) {
  const std::optional<std::vector<double>> numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 1)
    refuse(node, message("{}, expected {}{}.", with_attribute(attribute, text), expected, xacro_hint(text)));
  return numbers->front();
}

void require_within(const XmlNode& node, const Message& place, double number, const Bounds& within) {
  if (!within.hold(number))
    refuse(node, message("has the number {:g}{}, expected a number from {:g} to {:g}.", number, place, within.lowest,
                         within.highest));
}

Message in_attribute(const char* attribute) { return message(" in {}", verbatim(attribute)); }

void require_length(const XmlNode& node, const char* attribute, const std::string& text, std::size_t most) {
  if (text.size() > most)
    refuse(node, message("has {} bytes in {} ({}), expected at most {}.", text.size(), verbatim(attribute),
                         handsight::in_quotes(text, 40), most));
}

[[noreturn]] void refuse_missing(const XmlNode& node, const char* attribute) {
  refuse(node, message("has no attribute {}, expected {}=\"...\".", verbatim(attribute), verbatim(attribute)));
}

}  // namespace

std::unique_ptr<tinyxml2::XMLDocument> parse_xml(std::string_view text, std::string_view file) {
  if (const std::size_t good = utf8_length(text); good < text.size())
    refuse(file, line_of_byte(text, good), "the file holds bytes that are not UTF-8, expected XML saved as UTF-8.");
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    refuse(file, line_of_byte(text, zero), "the file holds a zero byte, expected XML, which is text.");
  if (split_words(text).empty()) refuse(file, 0, "the file is empty, expected well-formed XML.");
  check_xml_limits(text, file);
  // tinyxml2 stops without a word at a closing tag that closes nothing; the element added at the end shows
  // it.
  const std::string with_end = std::string(text) + "<end/>";
  auto document = std::make_unique<tinyxml2::XMLDocument>();
  const tinyxml2::XMLError error = document->Parse(with_end.data(), with_end.size());
  if (error != tinyxml2::XML_SUCCESS)
    refuse(file, document->ErrorLineNum(), message("{}, expected well-formed XML.", xml_error(error)));
  refuse_outside(*document, file);
  document->DeleteChild(document->LastChild());
  return document;
}

XmlNode require_root(const tinyxml2::XMLDocument& document, std::string_view file, std::string_view tag) {
  const tinyxml2::XMLElement* root = document.RootElement();
  if (!root) refuse(file, 0, message("there is no element in the file, expected <{}>.", tag));
  if (root->Name() != tag)
    refuse(file, root->GetLineNum(),
           message("the outermost element is <{}>, expected <{}>.", shortened(root->Name()), tag));
  if (const tinyxml2::XMLElement* second = root->NextSiblingElement())
    refuse(file, second->GetLineNum(),
           message("<{}> is a second outermost element, expected only <{}>.", shortened(second->Name()), tag));
  return {root, file};
}

void require_version_1(const XmlNode& node) {
  const std::string version = required_text(node, "version");
  if (version != "1")
    refuse(node, message("{}, expected version=\"1\", the only one that this program reads.",
                         with_attribute("version", version)));
}

void refuse(const XmlNode& node, const Message& sentence) {
  refuse(node.file, node.line(), message("<{}> {}", shortened(node.tag()), sentence));
}

std::vector<XmlNode> children(const XmlNode& node, std::string_view tag) {
  std::vector<XmlNode> found;
  for (auto* child = node.element->FirstChildElement(); child; child = child->NextSiblingElement())
    if (tag.empty() || child->Name() == tag) found.push_back({child, node.file});
  return found;
}

std::optional<XmlNode> find_child(const XmlNode& node, std::string_view tag) {
  std::optional<XmlNode> found;
  for (auto* child = node.element->FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (child->Name() != tag) continue;
    if (found)
      refuse(XmlNode{child, node.file}, message("stands a second time in <{}>, expected once.", shortened(node.tag())));
    found = XmlNode{child, node.file};
  }
  return found;
}

XmlNode required_child(const XmlNode& node, std::string_view tag) {
  const std::optional<XmlNode> child = find_child(node, tag);
  if (!child) refuse(node, message("has no element <{}>, expected one.", tag));
  return *child;
}

std::optional<std::string> find_text(const XmlNode& node, const char* attribute) {
  const char* text = node.element->Attribute(attribute);
  if (!text) return std::nullopt;
  require_utf8(node, text);
  require_length(node, attribute, text, bounds::longest_text);
  return text;
}

std::optional<std::string> find_name(const XmlNode& node, const char* attribute) {
  std::optional<std::string> name = find_text(node, attribute);
  if (name) require_length(node, attribute, *name, bounds::longest_name);
  return name;
}

std::string required_text(const XmlNode& node, const char* attribute) {
  const std::optional<std::string> text = find_text(node, attribute);
  if (!text) refuse_missing(node, attribute);
  return *text;
}

std::string required_name(const XmlNode& node, const char* attribute) {
  std::string name = required_text(node, attribute);
  require_length(node, attribute, name, bounds::longest_name);
  if (split_words(name).empty()) refuse(node, message("{}, expected a name.", with_attribute(attribute, name)));
  return name;
}

std::optional<double> find_number(const XmlNode& node, const char* attribute, const Bounds& within) {
  const std::optional<std::string> text = find_text(node, attribute);
  if (!text) return std::nullopt;
  const double number = as_number(node, attribute, *text, "one finite number");
  require_within(node, in_attribute(attribute), number, within);
  return number;
}

double required_number(const XmlNode& node, const char* attribute, const Bounds& within) {
  const std::optional<double> number = find_number(node, attribute, within);
  if (!number) refuse_missing(node, attribute);
  return *number;
}

std::optional<double> find_positive(const XmlNode& node, const char* attribute, const Bounds& within) {
  const std::optional<std::string> text = find_text(node, attribute);
  if (!text) return std::nullopt;
  const double number = as_number(node, attribute, *text, "a positive number");
  if (number <= 0) refuse(node, message("{}, expected a positive number.", with_attribute(attribute, *text)));
  require_within(node, in_attribute(attribute), number, within);
  return number;
}

double required_positive(const XmlNode& node, const char* attribute, const Bounds& within) {
  const std::optional<double> number = find_positive(node, attribute, within);
  if (!number) refuse_missing(node, attribute);
  return *number;
}

std::optional<std::vector<double>> find_numbers(const XmlNode& node, const char* attribute, std::size_t count,
                                                const Bounds& within) {
  const std::optional<std::string> text = find_text(node, attribute);
  if (!text) return std::nullopt;
  std::string bad_word;
  std::optional<std::vector<double>> numbers = parse_numbers(*text, &bad_word);
  if (!numbers)
    refuse(node, message("has {} in {}, expected {} finite numbers{}.", handsight::in_quotes(bad_word),
                         verbatim(attribute), count, xacro_hint(*text)));
  if (numbers->size() != count)
    refuse(node, message("has {} numbers in {}, expected {}.", numbers->size(), verbatim(attribute), count));
  for (const double number : *numbers) require_within(node, in_attribute(attribute), number, within);
  return numbers;
}

std::vector<double> required_numbers(const XmlNode& node, const char* attribute, std::size_t count,
                                     const Bounds& within) {
  std::optional<std::vector<double>> numbers = find_numbers(node, attribute, count, within);
  if (!numbers) refuse_missing(node, attribute);
  return std::move(*numbers);
}

std::optional<std::int64_t> find_integer(const XmlNode& node, const char* attribute, std::int64_t lowest,
                                         std::int64_t highest) {
  const std::optional<std::string> text = find_text(node, attribute);
  if (!text) return std::nullopt;
  const std::vector<std::string_view> words = split_words(*text);
  const std::optional<std::int64_t> number = words.size() == 1 ? parse_integer(words[0]) : std::nullopt;
  if (!number || *number < lowest || *number > highest) {
    const Message range =
        highest == INT64_MAX ? message("of at least {}", lowest) : message("from {} to {}", lowest, highest);
    refuse(node, message("{}, expected an integer {}.", with_attribute(attribute, *text), range));
  }
  return number;
}

std::int64_t required_integer(const XmlNode& node, const char* attribute, std::int64_t lowest, std::int64_t highest) {
  const std::optional<std::int64_t> number = find_integer(node, attribute, lowest, highest);
  if (!number) refuse_missing(node, attribute);
  return *number;
}

std::optional<std::size_t> find_choice(const XmlNode& node, const char* attribute,
                                       std::initializer_list<std::string_view> choices) {
  const std::optional<std::string> text = find_text(node, attribute);
  if (!text) return std::nullopt;
  const auto found = std::find(choices.begin(), choices.end(), *text);
  if (found == choices.end())
    refuse(node, message("{}, expected one of: {}.", with_attribute(attribute, *text), fmt::join(choices, ", ")));
  return static_cast<std::size_t>(found - choices.begin());
}

std::string inner_text(const XmlNode& node) {
  std::string text;
  for (auto* child = node.element->FirstChild(); child; child = child->NextSibling()) {
    if (!child->ToText()) continue;
    if (!text.empty()) text += ' ';
    text += child->Value();
  }
  require_utf8(node, text);
  return text;
}

std::vector<double> inner_numbers(const XmlNode& node, std::size_t count, const Message& reason, const Bounds& within) {
  const Message comma = reason.empty() ? Message() : message(", {}", reason);
  std::string bad_word;
  std::optional<std::vector<double>> numbers = parse_numbers(inner_text(node), &bad_word);
  if (!numbers)
    refuse(node, message("has {}, expected {} finite numbers{}.", handsight::in_quotes(bad_word), count, comma));
  if (numbers->size() != count) refuse(node, message("has {} numbers, expected {}{}.", numbers->size(), count, comma));
  for (const double number : *numbers) require_within(node, "", number, within);
  return std::move(*numbers);
}

}  // namespace handsight
