// SPDX-License-Identifier: Apache-2.0
// A section a camera ("[narrow_stereo/left]"), in it names with their numbers in the lines below.
#include <algorithm>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/numbers.h"
#include "base/text.h"
#include "readers/maker_cameras.h"

namespace handsight {
namespace {

using SectionNumbers = std::map<std::string, std::vector<double>>;

struct NamedSection {
  std::string name;
  SectionNumbers numbers;
};

std::vector<NamedSection> ost_sections(const std::string& text, const std::string& file) {
  std::vector<NamedSection> all;
  std::istringstream lines(text);
  std::string line, key;
  for (int number = 1; std::getline(lines, line); ++number) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    const auto words = split_words(line);
    if (line[0] == '[') {
      all.push_back({line.substr(1, line.find(']') - 1), {}});
    } else if (all.empty()) {
      refuse(file, number, "stands before the first section; expected [image].");
    } else if (std::isalpha(static_cast<unsigned char>(line[0]))) {
      key = line;
    } else {
      for (const std::string_view word : words) {
        const auto value = parse_number(word);
        if (!value) refuse(file, number, message("{} is no finite number.", in_quotes(word)));
        all.back().numbers[key].push_back(*value);
      }
    }
  }
  return all;
}

RosCamera look_up_camera(const NamedSection& section, const std::vector<double>& size, const std::string& file) {
  const auto numbers = [&](const char* name) {
    const auto found = section.numbers.find(name);
    return found == section.numbers.end() ? std::vector<double>() : found->second;
  };
  const std::vector<double> k = numbers("camera matrix"), r = numbers("rectification"), p = numbers("projection");
  if (k.size() != 9)
    throw InputError(
        message("{}: [{}] has a camera matrix of {} numbers; expected 9.", file, shortened(section.name), k.size()));
  ros::CameraInfo message;
  std::copy(k.begin(), k.end(), message.k);
  if (r.size() == 9) std::copy(r.begin(), r.end(), message.r);
  if (p.size() == 12) std::copy(p.begin(), p.end(), message.p);
  message.d = numbers("distortion");
  message.width = static_cast<std::uint32_t>(std::clamp(size[0], 0.0, 1e6));
  message.height = static_cast<std::uint32_t>(std::clamp(size[1], 0.0, 1e6));
  RosCamera camera = camera_from_message(message, file);
  camera.name = section.name.substr(section.name.rfind('/') + 1);
  return camera;
}

}  // namespace

bool is_ost(const std::string& text) {
  return text.find("[image]") != std::string::npos && text.find("camera matrix") != std::string::npos;
}

std::vector<RosCamera> read_ost(const std::string& text, const std::string& file) {
  std::vector<double> size = {0, 0};
  std::vector<RosCamera> cameras;
  for (const NamedSection& section : ost_sections(text, file)) {
    for (const auto& [place, name] : {std::pair{std::size_t{0}, "width"}, {std::size_t{1}, "height"}})
      if (const auto found = section.numbers.find(name); section.name == "image" && found != section.numbers.end())
        size[place] = found->second.front();
    if (section.name != "image" && section.numbers.contains("camera matrix"))
      cameras.push_back(look_up_camera(section, size, file));
  }
  if (cameras.empty() || cameras.size() > 2)
    throw InputError(message("{}: has {} cameras; expected one, or a left and a right one.", file, cameras.size()));
  return cameras;
}

}  // namespace handsight
