// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/letters.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/maker_cameras.h"
#include "readers/yaml_text.h"

namespace handsight {
namespace {

struct Intrinsics {
  std::string stream, model;
  double width = 0, height = 0, fx = 0, fy = 0, ppx = 0, ppy = 0;
  std::vector<double> coefficients;
};

/// "distortion.inverse_brown_conrady", "Inverse Brown Conrady" and "RS2_DISTORTION_BROWN_CONRADY" in one form.
std::string plain_model(std::string model) {
  model = lower_case(model);
  std::replace(model.begin(), model.end(), ' ', '_');
  for (const char* before : {"distortion.", "rs2_distortion_"})
    if (model.starts_with(before)) model.erase(0, std::string(before).size());
  return model;
}

RosCamera look_up_camera(const Intrinsics& i, const std::string& file, std::vector<Message>& notes) {
  RosCamera c;
  c.file = file;
  c.camera.width = static_cast<int>(std::clamp(i.width, 0.0, 1e6));
  c.camera.height = static_cast<int>(std::clamp(i.height, 0.0, 1e6));
  c.camera.fx = i.fx;
  c.camera.fy = i.fy;
  c.camera.cx = i.ppx;
  c.camera.cy = i.ppy;
  const std::string model = plain_model(i.model);
  const bool bends = std::any_of(i.coefficients.begin(), i.coefficients.end(), [](double k) { return k != 0; });
  std::vector<double> d = i.coefficients;
  if (model.starts_with("kannala_brandt")) {
    d.resize(4);
    set_distortion(c.camera, d, "equidistant", file);
  } else if (!bends || model == "brown_conrady" || model == "inverse_brown_conrady") {
    set_distortion(c.camera, d, "plumb_bob", file);
  } else {
    throw InputError(
        message("{}: the lens is of RealSense's model {}, which sessions do not have; calibrate the camera with "
                "`handsight-cli cameras`.",
                file, in_quotes(i.model)));
  }
  if (bends && model == "inverse_brown_conrady")
    notes.push_back(message(
        "{}: its coefficients are of the model inverse Brown-Conrady; they are taken as Brown's, as librealsense "
        "projects with them.",
        file));
  check_camera(c.camera, file);
  return c;
}

void take_line(Intrinsics& i, const std::string& name, const std::string& value) {
  const std::map<std::string, double*> numbers = {{"Width", &i.width}, {"Height", &i.height}, {"PPX", &i.ppx},
                                                  {"PPY", &i.ppy},     {"Fx", &i.fx},         {"Fy", &i.fy}};
  const auto number = numbers.find(name);
  if (number != numbers.end()) *number->second = parse_number(value).value_or(0);
  if (name == "Distortion") i.model = value;
  if (name != "Coeffs") return;
  for (const std::string_view word : split_words(value)) i.coefficients.push_back(parse_number(word).value_or(0));
}

/// Every "Intrinsic of ..." with the lines "Name: value" behind it.
std::vector<Intrinsics> listed_intrinsics(const std::string& text) {
  std::vector<Intrinsics> all;
  std::istringstream lines(text);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    const std::string reported = trimmed(line);
    if (reported.starts_with("Intrinsic of ")) {
      all.push_back({reported.substr(13), {}});
      inside = true;
      continue;
    }
    const std::size_t colon = reported.find(':');
    inside = inside && colon != std::string::npos;
    if (inside) take_line(all.back(), reported.substr(0, colon), trimmed(reported.substr(colon + 1)));
  }
  return all;
}

}  // namespace

bool is_realsense(const YAML::Node& yaml) {
  return yaml.IsMap() && yaml["fx"] && yaml["fy"] && ((yaml["ppx"] && yaml["ppy"]) || (yaml["cx"] && yaml["cy"]));
}

bool is_realsense_listing(const std::string& text) {
  return text.find("Intrinsic of ") != std::string::npos && text.find("PPX:") != std::string::npos;
}

RosCamera read_realsense(const YAML::Node& yaml, const std::string& file, std::vector<Message>& notes) {
  Intrinsics i;
  const std::pair<const char*, double*> numbers[] = {{"width", &i.width}, {"height", &i.height}, {"fx", &i.fx},
                                                     {"fy", &i.fy},       {"ppx", &i.ppx},       {"ppy", &i.ppy}};
  for (const auto& [name, number] : numbers) {
    const std::string other = std::string(name) == "ppx" ? "cx" : std::string(name) == "ppy" ? "cy" : name;
    const auto reported = yaml[name] ? yaml_number(yaml, name) : yaml_number(yaml, other.c_str());
    if (!reported) throw InputError(message("{}: has no number {}; expected width height ppx ppy fx fy.", file, name));
    *number = *reported;
  }
  i.model = yaml_word(yaml, "model");
  for (const char* name : {"coeffs", "dist_coeffs", "distortion", "distortion_coefficients", "dist", "D"})
    if (yaml[name] && i.coefficients.empty()) i.coefficients = yaml_numbers(yaml[name]).value_or(std::vector<double>());
  if (!yaml["ppx"] && i.model.empty()) i.model = "brown_conrady";  // the coefficients of OpenCV, as people write them
  return look_up_camera(i, file, notes);
}

RosCamera read_realsense_listing(const std::string& text, const std::string& file, std::vector<Message>& notes) {
  const std::vector<Intrinsics> all = listed_intrinsics(text);
  if (all.size() != 1) {
    std::string streams;
    for (const Intrinsics& i : all) streams += (streams.empty() ? "" : "; ") + i.stream;
    throw InputError(
        message("{}: lists {} streams ({}); keep the lines of the one that the images are of, from \"Intrinsic of\" to "
                "\"Coeffs\".",
                file, all.size(), shortened(streams, 200)));
  }
  return look_up_camera(all.front(), file, notes);
}

}  // namespace handsight
