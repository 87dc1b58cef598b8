// SPDX-License-Identifier: Apache-2.0
#include "base/message_xml.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace handsight {
namespace {

constexpr int most_deep = 8;  // one inside another; the core's own have four at most
constexpr std::array kind_tags{"form", "verbatim", "number", "sequence"};  // as Message::Kind counts them

Message read_part(const XmlNode& node, int deep) {
  const auto tag = std::find(kind_tags.begin(), kind_tags.end(), node.tag());
  if (tag == kind_tags.end()) refuse(node, "is not known in a message, expected form, verbatim, number or sequence.");
  if (deep > most_deep) refuse(node, message("stands too deep in a message, expected {} levels at most.", most_deep));
  std::vector<Message> arguments;
  for (const XmlNode& part : children(node)) arguments.push_back(read_part(part, deep + 1));
  return {static_cast<Message::Kind>(tag - kind_tags.begin()), find_text(node, "text").value_or(""),
          std::move(arguments)};
}

}  // namespace

bool has_parts(const Message& message) { return !message.arguments().empty(); }

void write_message(tinyxml2::XMLElement& parent, const Message& message) {
  tinyxml2::XMLElement& element = *parent.InsertNewChildElement(kind_tags[static_cast<std::size_t>(message.kind())]);
  if (!message.form().empty()) element.SetAttribute("text", message.form().c_str());
  for (const Message& part : message.arguments()) write_message(element, part);
}

Message read_message(const XmlNode& node) { return read_part(node, 1); }

}  // namespace handsight
