// SPDX-License-Identifier: Apache-2.0
#include "readers/robots/robot_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "readers/robots/mjcf.h"
#include "readers/robots/program_output.h"

namespace handsight {
namespace {

namespace fs = std::filesystem;

bool is_xacro(const fs::path& path, const std::string& text) {
  return path.extension() == ".xacro" || text.find("<xacro:") != std::string::npos;
}

std::string last_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  return text.substr(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
}

/// Nothing where the program is not installed: the reader of URDF then says how to expand the file.
std::optional<std::string> expanded(const fs::path& path, const std::string& file) {
  constexpr int seconds = 60;
  const auto output = run_for_output({"xacro", fs::absolute(path).string()}, seconds);
  if (!output) return std::nullopt;
  if (output->status != 0 || !is_robot_text(output->out))
    throw InputError(
        message("{}: xacro cannot expand it ({}); expand it with the arguments that the robot's launch file gives, "
                "`xacro {} NAME:=VALUE > robot.urdf`, and name robot.urdf.",
                file, shortened(last_line(output->err), 200), file));
  return output->out;
}

}  // namespace

bool is_robot_text(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return begin != std::string::npos && text[begin] == '<' &&
         (text.find("<robot") != std::string::npos || is_mjcf(text));
}

FieldUrdf robot_of_file(const fs::path& path) {
  const std::string text = read_file(path), file = shown_path(path.filename());
  if (is_mjcf(text)) {
    std::vector<Message> notes;
    const std::string urdf = urdf_of_mjcf(path, file, notes);
    FieldUrdf robot = field_urdf(urdf, file);
    robot.notes.insert(robot.notes.begin(), notes.begin(), notes.end());
    robot.notes.insert(
        robot.notes.begin(),
        message("{}: is a model of MuJoCo; the session's robot is a URDF of its bodies and joints.", file));
    return robot;
  }
  if (is_xacro(path, text))
    if (const auto urdf = expanded(path, file)) {
      FieldUrdf robot = field_urdf(*urdf, file);
      robot.notes.insert(robot.notes.begin(),
                         message("{}: was expanded by xacro, with the arguments that it has by itself.", file));
      return robot;
    }
  return field_urdf(text, file);
}

}  // namespace handsight
