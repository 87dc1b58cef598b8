// SPDX-License-Identifier: Apache-2.0
#include "readers/kalibr_target.h"

#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

double required(const YAML::Node& yaml, const char* key, const std::string& file) {
  const auto number = yaml_number(yaml, key);
  if (!number)
    throw InputError(message("{}: has no number {}; expected Kalibr's description of a target, whole.", file, key));
  return *number;
}

int required_count(const YAML::Node& yaml, const char* key, const std::string& file) {
  const double number = required(yaml, key, file);
  if (number != std::floor(number) || number < 1 || number > 4096)
    throw InputError(message("{}: {} is {:g}; expected a whole number from 1 on.", file, key, number));
  return static_cast<int>(number);
}

Target checkerboard(const YAML::Node& yaml, const std::string& file) {
  Target t;
  t.kind = TargetKind::chessboard;
  t.columns = required_count(yaml, "targetCols", file);
  t.rows = required_count(yaml, "targetRows", file);
  t.square = required(yaml, "rowSpacingMeters", file);
  const double across = required(yaml, "colSpacingMeters", file);
  if (across != t.square)
    throw InputError(
        message("{}: its fields are {:g} m x {:g} m; expected squares (rowSpacingMeters and colSpacingMeters equal).",
                file, across, t.square));
  return t;
}

Target aprilgrid(const YAML::Node& yaml, const std::string& file) {
  Target t;
  t.kind = TargetKind::aprilgrid;
  t.columns = required_count(yaml, "tagCols", file);
  t.rows = required_count(yaml, "tagRows", file);
  t.tag = required(yaml, "tagSize", file);
  t.spacing = required(yaml, "tagSpacing", file);
  t.dictionary = "tag36h11";
  t.border = 2;
  return t;
}

}  // namespace

bool is_kalibr_target(const YAML::Node& yaml) { return yaml.IsMap() && yaml["target_type"]; }

Target read_kalibr_target(const YAML::Node& yaml, const std::string& file) {
  const std::string kind = yaml_word(yaml, "target_type");
  if (kind == "circlegrid")
    throw InputError(message(
        "{}: describes a grid of circles, without their diameter, which is needed; expected it in words: --target "
        "circles columns={} rows={} spacing={:g} diameter=METRES layout={}.",
        file, required_count(yaml, "targetCols", file), required_count(yaml, "targetRows", file),
        required(yaml, "spacingMeters", file),
        yaml_word(yaml, "asymmetricGrid") == "true" ? "asymmetric" : "symmetric"));
  if (kind != "aprilgrid" && kind != "checkerboard")
    throw InputError(
        message("{}: describes a target of the type {}, which is not found in images; expected aprilgrid or "
                "checkerboard: `handsight-cli target` draws one.",
                file, in_quotes(kind)));
  Target target = kind == "aprilgrid" ? aprilgrid(yaml, file) : checkerboard(yaml, file);
  check_target(target, file + ": the target");
  return target;
}

}  // namespace handsight
