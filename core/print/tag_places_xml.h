// SPDX-License-Identifier: Apache-2.0
// <tag id="" xyz="" rpy="" size="" sigma="" sigma_angle=""/> inside a <target>, in and out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/xml.h"
#include "print/target.h"

namespace handsight {

/// The names of all attributes that a <tag> may have.
const std::vector<std::string>& tag_attributes();

/// The first <tag> inside a target; null where there is none.
const tinyxml2::XMLElement* find_tag(const XmlNode& target);

/// rad: the turn that moves a tag's corner as far as the sigma of its place.
double usual_sigma_angle(const TagPlace& place);

/// Gives the target the ids and places of its <tag> elements. What one does not say of size, sigma and sigma_angle is
/// that of the target. InputError with a sentence where something is missing or out of bounds.
void read_tag_places(const XmlNode& node, Target& target);

/// A <tag> for each of the target's places, as read_tag_places reads it, bit for bit; none where there are none.
void write_tag_places(tinyxml2::XMLElement& element, const Target& target);

/// InputError that begins with `where` unless the columns, rows and lengths make an ArUco grid board.
void check_grid(const Target& target, std::string_view where);

}  // namespace handsight
