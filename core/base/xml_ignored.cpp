// SPDX-License-Identifier: Apache-2.0
// What readers do not know, and the text of a document.
#include <algorithm>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "base/xml.h"

namespace handsight {

namespace {

template <class Names>
bool is_among(std::string_view name, const Names& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void count(Ignored& ignored, std::string kind, int line) {
  constexpr std::size_t most_kinds = 50;
  if (ignored.kinds.size() >= most_kinds && !ignored.kinds.contains(kind)) kind = "more of other kinds";
  Ignored::Count& counted = ignored.kinds[kind];
  if (counted.times++ == 0) counted.first_line = line;
}

class TwoSpacesPrinter : public tinyxml2::XMLPrinter {
 protected:
  void PrintSpace(int depth) override {
    for (int i = 0; i < depth; ++i) Write("  ");
  }
};

}  // namespace

namespace {

template <class Attributes, class Elements>
void note_others(Ignored& ignored, const XmlNode& node, const Attributes& attributes, const Elements& elements,
                 bool holds_text) {
  const std::string tag = shortened(node.tag());
  for (auto* attribute = node.element->FirstAttribute(); attribute; attribute = attribute->Next())
    if (!is_among(attribute->Name(), attributes))
      count(ignored, message("attribute {} of <{}>", shortened(attribute->Name()), tag), attribute->GetLineNum());
  for (auto* child = node.element->FirstChild(); child; child = child->NextSibling()) {
    if (child->ToElement() && !is_among(child->Value(), elements))
      count(ignored, message("element <{}> in <{}>", shortened(child->Value()), tag), child->GetLineNum());
    if (child->ToText() && !holds_text && !split_words(child->Value()).empty())
      count(ignored, message("text in <{}>", tag), child->GetLineNum());
  }
}

}  // namespace

void note_unknown(Ignored& ignored, const XmlNode& node, std::initializer_list<std::string_view> attributes,
                  std::initializer_list<std::string_view> elements, bool holds_text) {
  note_others(ignored, node, attributes, elements, holds_text);
}

void note_unknown(Ignored& ignored, const XmlNode& node, const std::vector<std::string>& attributes,
                  std::initializer_list<std::string_view> elements, bool holds_text) {
  note_others(ignored, node, attributes, elements, holds_text);
}

void note_unknown(Ignored& ignored, const XmlNode& node, std::initializer_list<std::string_view> attributes,
                  const std::vector<std::string>& elements) {
  note_others(ignored, node, attributes, elements, false);
}

std::vector<Message> ignored_sentences(const Ignored& ignored, std::string_view file) {
  std::vector<Message> sentences;
  for (const auto& [kind, counted] : ignored.kinds)
    sentences.push_back(counted.times == 1 ? message("{}: {} is not known and is ignored (line {}).",
                                                     shortened(file, 80), kind, counted.first_line)
                                           : message("{}: {} is not known and is ignored ({} times, first at line {}).",
                                                     shortened(file, 80), kind, counted.times, counted.first_line));
  return sentences;
}

std::string xml_text(const tinyxml2::XMLDocument& document) {
  TwoSpacesPrinter printer;
  document.Print(&printer);
  const std::string_view printed(printer.CStr(), static_cast<std::size_t>(printer.CStrSize() - 1));
  std::string text;
  for (const char character : printed) {
    if (character == '\r')
      text += "&#13;";  // tinyxml2 writes it as it is, but reads a line end
    else
      text += character;
  }
  return text;
}

}  // namespace handsight
