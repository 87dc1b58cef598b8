// SPDX-License-Identifier: Apache-2.0
// Messages in files, with their parts, so that they are said in the language of who reads the file.
#pragma once

#include "base/xml.h"

namespace handsight {

/// Whether the English alone tells less than the message: parts are put into a form.
bool has_parts(const Message& message);

/// Appends <form text="...">, <verbatim text="...">, <number text="..."> or <sequence>, each with its arguments inside.
void write_message(tinyxml2::XMLElement& parent, const Message& message);

/// The message of such an element. Refuses more than eight of them one inside another.
Message read_message(const XmlNode& node);

}  // namespace handsight
