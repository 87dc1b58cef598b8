// SPDX-License-Identifier: Apache-2.0
// YAML files of other programs, by yaml-cpp.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

namespace handsight {

/// InputError where the text is longer than 16 MB, nested deeply or no YAML; `file` is what sentences call it.
YAML::Node parse_yaml(const std::string& text, const std::string& file);

/// The numbers of a node: a list, a list of lists row by row, or "data" of a matrix of ROS; nothing where it is none of
/// them or a number is not finite.
std::optional<std::vector<double>> yaml_numbers(const YAML::Node& node);

/// One finite number of a map; nothing where it has none.
std::optional<double> yaml_number(const YAML::Node& map, const char* key);

/// A text of a map; empty where it has none.
std::string yaml_word(const YAML::Node& map, const char* key);

}  // namespace handsight
