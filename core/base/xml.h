// SPDX-License-Identifier: Apache-2.0
// Thin helpers over tinyxml2. Every refusal is an InputError sentence with the file, the line, what was found
// and what was expected.
#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/bounds.h"
#include "base/message.h"

namespace handsight {

/// An element and the name of its file, as refusals show it. Both outlive the node.
struct XmlNode {
  const tinyxml2::XMLElement* element = nullptr;
  std::string_view file;

  std::string_view tag() const { return element->Name(); }
  int line() const { return element->GetLineNum(); }
};

/// Refuses a text that would cost far more memory or time than the formats need (too long, too many elements, hundreds
/// of attributes in one), and references to a zero byte.
void check_xml_limits(std::string_view text, std::string_view file);

/// Parses a text that is well-formed XML in UTF-8 and within check_xml_limits.
std::unique_ptr<tinyxml2::XMLDocument> parse_xml(std::string_view text, std::string_view file);

/// The one outermost element, which has this tag.
XmlNode require_root(const tinyxml2::XMLDocument& document, std::string_view file, std::string_view tag);

/// Refuses every version="" but "1".
void require_version_1(const XmlNode& node);

/// Throws InputError "FILE, line LINE: <TAG> SENTENCE".
[[noreturn]] void refuse(const XmlNode& node, const Message& sentence);

/// Child elements; all, or those of one tag.
std::vector<XmlNode> children(const XmlNode& node, std::string_view tag = {});

/// The child of that tag; refuses a second one.
std::optional<XmlNode> find_child(const XmlNode& node, std::string_view tag);
XmlNode required_child(const XmlNode& node, std::string_view tag);

/// Attribute texts, of at most bounds::longest_text bytes.
std::optional<std::string> find_text(const XmlNode& node, const char* attribute);
std::string required_text(const XmlNode& node, const char* attribute);

/// The same, of at most bounds::longest_name bytes; the required one is not empty.
std::optional<std::string> find_name(const XmlNode& node, const char* attribute);
std::string required_name(const XmlNode& node, const char* attribute);

/// Attributes that hold one finite number within bounds.
std::optional<double> find_number(const XmlNode& node, const char* attribute, const Bounds& within = bounds::any);
double required_number(const XmlNode& node, const char* attribute, const Bounds& within = bounds::any);
std::optional<double> find_positive(const XmlNode& node, const char* attribute, const Bounds& within = bounds::any);
double required_positive(const XmlNode& node, const char* attribute, const Bounds& within = bounds::any);

/// Attributes that hold so many finite numbers, each within bounds.
std::optional<std::vector<double>> find_numbers(const XmlNode& node, const char* attribute, std::size_t count,
                                                const Bounds& within = bounds::any);
std::vector<double> required_numbers(const XmlNode& node, const char* attribute, std::size_t count,
                                     const Bounds& within = bounds::any);

/// Attributes that hold an integer from `lowest` to `highest`.
std::optional<std::int64_t> find_integer(const XmlNode& node, const char* attribute, std::int64_t lowest,
                                         std::int64_t highest);
std::int64_t required_integer(const XmlNode& node, const char* attribute, std::int64_t lowest, std::int64_t highest);

/// Index of the attribute's text in `choices`.
std::optional<std::size_t> find_choice(const XmlNode& node, const char* attribute,
                                       std::initializer_list<std::string_view> choices);

/// The texts directly inside an element, comments left out.
std::string inner_text(const XmlNode& node);

/// So many finite numbers within bounds inside an element; `reason` completes "expected COUNT".
std::vector<double> inner_numbers(const XmlNode& node, std::size_t count, const Message& reason = {},
                                  const Bounds& within = bounds::any);

/// Elements, attributes and texts that a reader does not know, counted by kind.
struct Ignored {
  struct Count {
    int times = 0;
    int first_line = 0;
  };
  std::map<std::string, Count> kinds;
};

/// Counts what is unknown in an element. `holds_text`: text is expected.
void note_unknown(Ignored& ignored, const XmlNode& node, std::initializer_list<std::string_view> attributes,
                  std::initializer_list<std::string_view> elements, bool holds_text = false);

/// The same with attributes that are known only when the program runs.
void note_unknown(Ignored& ignored, const XmlNode& node, const std::vector<std::string>& attributes,
                  std::initializer_list<std::string_view> elements, bool holds_text = false);

/// The same with elements that are known only then.
void note_unknown(Ignored& ignored, const XmlNode& node, std::initializer_list<std::string_view> attributes,
                  const std::vector<std::string>& elements);

/// "session.xml: element <foo> in <bar> is not known and is ignored (12 times, first at line 30)."
std::vector<Message> ignored_sentences(const Ignored& ignored, std::string_view file);

/// The document as text, indented by two spaces.
std::string xml_text(const tinyxml2::XMLDocument& document);

}  // namespace handsight
