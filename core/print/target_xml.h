// SPDX-License-Identifier: Apache-2.0
// <target kind="..." .../> in and out.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/xml.h"
#include "print/target.h"

namespace handsight {

/// kind, and by kind: chessboard: columns rows square; charuco: columns rows square marker dictionary [layout="old"]
/// [first_id]; aprilgrid: columns rows tag spacing [dictionary] [border="2"] [first_id]; tags: dictionary, and size and
/// ids or, for a body of tags, <tag id="" [xyz] [rpy] [size] [sigma] [sigma_angle]/> for each of them ([size], [sigma]
/// and [sigma_angle] of the target are those of its tags that have none), [border]; grid, an ArUco grid board, which is
/// kept as tags with places: columns rows marker separation dictionary [first_id] [border]; all: [sigma]. What else is
/// there is not looked at. InputError with a sentence where one is missing or wrong.
Target read_target(const XmlNode& node);

/// The same from words kind, columns, ... = text, as options of a command give them; `where` begins the sentence.
Target target_from_words(const std::vector<std::pair<std::string, std::string>>& words, std::string_view where);

/// The names of all attributes that a target may have.
const std::vector<std::string>& target_attributes();

/// kind="..." and what the kind needs, as `read_target` reads it, bit for bit; defaults are left out. The tags of a
/// body are elements, which `write_target` adds.
std::vector<std::pair<std::string, std::string>> target_words(const Target& target);
void write_target(tinyxml2::XMLElement& element, const Target& target);

}  // namespace handsight
