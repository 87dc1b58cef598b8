// SPDX-License-Identifier: Apache-2.0
#include "readers/yaml_text.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"

namespace handsight {
namespace {

constexpr std::size_t largest_text = std::size_t{16} << 20;
constexpr int deepest = 64;

bool is_nested_deeply(std::string_view text) {
  int brackets = 0, indent = 0;
  bool at_start = true;
  for (const char c : text) {
    brackets += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    indent = c == '\n' ? 0 : at_start && (c == ' ' || c == '-' || c == '?') ? indent + 1 : indent;
    at_start = c == '\n' || (at_start && (c == ' ' || c == '-' || c == '?'));
    if (brackets > deepest || (at_start && indent > 4 * deepest)) return true;
  }
  return false;
}

bool add_numbers(const YAML::Node& node, std::vector<double>& all, int depth) {
  if (node.IsScalar()) {
    const auto number = parse_number(node.Scalar());
    if (number) all.push_back(*number);
    return number.has_value();
  }
  if (!node.IsSequence() || depth == 0 || node.size() > 100000) return false;
  return std::all_of(node.begin(), node.end(),
                     [&](const YAML::Node& part) { return add_numbers(part, all, depth - 1); });
}

}  // namespace

YAML::Node parse_yaml(const std::string& text, const std::string& file) {
  if (text.size() > largest_text) throw InputError(message("{}: is longer than 16 MB, which no calibration is.", file));
  if (is_nested_deeply(text)) throw InputError(message("{}: is nested more deeply than any calibration is.", file));
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw InputError(message("{}, line {}: is no YAML: {}; expected `name: value` lines.", file, error.mark.line + 1,
                             shortened(error.msg, 200)));
  }
}

std::optional<std::vector<double>> yaml_numbers(const YAML::Node& node) {
  if (!node) return std::nullopt;
  if (node.IsMap()) return yaml_numbers(node["data"]);
  std::vector<double> all;
  if (!add_numbers(node, all, 3)) return std::nullopt;
  return all;
}

std::optional<double> yaml_number(const YAML::Node& map, const char* key) {
  if (!map.IsMap() || !map[key] || !map[key].IsScalar()) return std::nullopt;
  return parse_number(map[key].Scalar());
}

std::string yaml_word(const YAML::Node& map, const char* key) {
  return map.IsMap() && map[key] && map[key].IsScalar() ? map[key].Scalar() : "";
}

}  // namespace handsight
