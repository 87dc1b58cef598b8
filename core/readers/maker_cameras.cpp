// SPDX-License-Identifier: Apache-2.0
#include "readers/maker_cameras.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

double required_number(const YAML::Node& map, const char* key, const std::string& file) {
  const auto number = yaml_number(map, key);
  if (!number) throw InputError(message("{}: has no number {}; expected a calibration that is whole.", file, key));
  return *number;
}

void set_size(Camera& c, const YAML::Node& map, const char* width, const char* height) {
  c.width = static_cast<int>(std::clamp(yaml_number(map, width).value_or(0), 0.0, 1e6));
  c.height = static_cast<int>(std::clamp(yaml_number(map, height).value_or(0), 0.0, 1e6));
}

YAML::Node either(const YAML::Node& map, const char* small, const char* capital) {
  return map[small] ? map[small] : map[capital];
}

}  // namespace

bool is_echoed_camera_info(const YAML::Node& yaml) {
  return yaml.IsMap() && yaml["width"] && yaml["distortion_model"] && (yaml["k"] || yaml["K"]);
}

RosCamera read_echoed_camera_info(const YAML::Node& yaml, const std::string& file) {
  ros::CameraInfo info;
  const auto k = yaml_numbers(either(yaml, "k", "K")), r = yaml_numbers(either(yaml, "r", "R")),
             p = yaml_numbers(either(yaml, "p", "P")), d = yaml_numbers(either(yaml, "d", "D"));
  if (!k || k->size() != 9)
    throw InputError(message(
        "{}: k does not hold 9 finite numbers; expected the whole text of `ros2 topic echo --full-length`.", file));
  std::copy(k->begin(), k->end(), info.k);
  if (r && r->size() == 9) std::copy(r->begin(), r->end(), info.r);
  if (p && p->size() == 12) std::copy(p->begin(), p->end(), info.p);
  info.d = d.value_or(std::vector<double>());
  info.model = yaml_word(yaml, "distortion_model");
  info.width = static_cast<std::uint32_t>(std::clamp(yaml_number(yaml, "width").value_or(0), 0.0, 1e6));
  info.height = static_cast<std::uint32_t>(std::clamp(yaml_number(yaml, "height").value_or(0), 0.0, 1e6));
  RosCamera camera = camera_from_message(info, file);
  camera.name.clear();
  return camera;
}

bool is_camodocal(const std::string& text) {
  return text.find("model_type:") != std::string::npos && (text.find("projection_parameters:") != std::string::npos ||
                                                           text.find("poly_parameters:") != std::string::npos);
}

RosCamera read_camodocal(const std::string& text, const std::string& file) {
  // "%YAML:1.0" is OpenCV's; YAML has "%YAML 1.0".
  const YAML::Node yaml =
      parse_yaml(text.starts_with('%') ? text.substr(std::min(text.find('\n'), text.size())) : text, file);
  const std::string model = yaml_word(yaml, "model_type");
  const bool is_fisheye = model == "KANNALA_BRANDT";
  if (model != "PINHOLE" && !is_fisheye)
    throw InputError(
        message("{}: the camera is of camodocal's model {}, which sessions do not have; calibrate it as PINHOLE or, a "
                "wide lens, as KANNALA_BRANDT, or with `handsight-cli cameras`.",
                file, in_quotes(model)));
  RosCamera c;
  c.file = file;
  c.name = yaml_word(yaml, "camera_name");
  set_size(c.camera, yaml, "image_width", "image_height");
  const YAML::Node projection = yaml["projection_parameters"],
                   bend = is_fisheye ? projection : yaml["distortion_parameters"];
  if (!projection.IsMap())
    throw InputError(message("{}: has no projection_parameters; expected a calibration that is whole.", file));
  c.camera.fx = required_number(projection, is_fisheye ? "mu" : "fx", file);
  c.camera.fy = required_number(projection, is_fisheye ? "mv" : "fy", file);
  c.camera.cx = required_number(projection, is_fisheye ? "u0" : "cx", file);
  c.camera.cy = required_number(projection, is_fisheye ? "v0" : "cy", file);
  std::vector<double> d;
  for (const char* name : is_fisheye ? std::vector{"k2", "k3", "k4", "k5"} : std::vector{"k1", "k2", "p1", "p2"})
    if (bend.IsMap()) d.push_back(required_number(bend, name, file));
  set_distortion(c.camera, d, is_fisheye ? "equidistant" : "plumb_bob", file);
  check_camera(c.camera, file);
  return c;
}

}  // namespace handsight
