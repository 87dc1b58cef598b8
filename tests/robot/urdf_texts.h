// SPDX-License-Identifier: Apache-2.0
// Small robots as text.
#pragma once

#include <string>

namespace handsight {

inline const std::string two_links = R"(<robot name="r"><link name="a"/><link name="b"/>)";

/// A robot of links a and b and one joint between them with these attributes' type and content.
inline std::string one_joint(const std::string& content, const std::string& type = "revolute") {
  return two_links + "<joint name='j' type='" + type + "'><parent link='a'/><child link='b'/>" + content +
         "</joint></robot>";
}

}  // namespace handsight
