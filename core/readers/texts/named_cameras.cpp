// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "readers/maker_cameras.h"
#include "readers/texts/plain_text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

/// "%YAML:1.0" is OpenCV's; YAML has "%YAML 1.0".
YAML::Node yaml_of(const std::string& text, const std::string& file) {
  return parse_yaml(text.starts_with('%') ? text.substr(std::min(text.find('\n'), text.size())) : text, file);
}

/// What stands before fx: nothing, or ORB-SLAM's words; nothing where there is no fx.
std::optional<std::string> prefix_of(const YAML::Node& yaml) {
  for (const std::string prefix : {"", "Camera.", "Camera1."}) {
    const auto has = [&](const char* name) { return yaml_number(yaml, (prefix + name).c_str()).has_value(); };
    if (has("fx") && has("fy") && has("cx") && has("cy")) return prefix;
  }
  return std::nullopt;
}

std::vector<double> listed_numbers(const YAML::Node& yaml, const std::string& prefix,
                                   std::initializer_list<const char*> names) {
  std::vector<double> all;
  for (const char* name : names)
    if (const auto number = yaml_number(yaml, (prefix + name).c_str())) all.push_back(*number);
  return all;
}

}  // namespace

bool is_named_camera(const std::string& text) {
  try {
    const YAML::Node yaml = yaml_of(text, "");
    return yaml.IsMap() && prefix_of(yaml).has_value();
  } catch (const InputError&) {
    return false;
  }
}

RosCamera read_named_camera(const std::string& text, const std::string& file, std::vector<Message>& notes) {
  const YAML::Node yaml = yaml_of(text, file);
  const std::string prefix = prefix_of(yaml).value_or("");
  YAML::Node plain;
  const bool is_fisheye = yaml_word(yaml, (prefix + "type").c_str()).starts_with("Kannala") ||
                          yaml_word(yaml, "Camera.type").starts_with("Kannala");
  for (const char* name : {"fx", "fy", "cx", "cy"}) plain[name] = yaml[prefix + name];
  for (const auto& [side, others] : {std::pair{"width", std::array{"image_width", "Camera.width"}},
                                     std::pair{"height", std::array{"image_height", "Camera.height"}}}) {
    plain[side] = yaml_number(yaml, side).value_or(0);
    for (const char* other : others)
      if (const auto number = yaml_number(yaml, other)) plain[side] = *number;
  }
  for (const char* name : {"coeffs", "dist_coeffs", "distortion", "distortion_coefficients", "dist", "D"})
    if (yaml[name]) plain["coeffs"] = yaml[name];
  if (!plain["coeffs"])
    plain["coeffs"] = is_fisheye ? listed_numbers(yaml, prefix, {"k1", "k2", "k3", "k4"})
                                 : listed_numbers(yaml, prefix, {"k1", "k2", "p1", "p2", "k3"});
  if (is_fisheye) plain["model"] = "kannala_brandt";
  return read_realsense(plain, file, notes);
}

}  // namespace handsight
