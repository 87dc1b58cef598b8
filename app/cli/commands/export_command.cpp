// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>

#include "base/error.h"
#include "base/files.h"
#include "command.h"
#include "export/exported.h"
#include "options/predict_source.h"
#include "printing/export_output.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct ExportArguments {
  SourceOptions source;
  std::string kind, file, lerobot;
  Output output;
};

ExportOptions options_of(const ExportArguments& o) {
  if (!o.lerobot.empty() && o.kind != "lerobot")
    throw InputError(message("--lerobot is for --as lerobot, and this is --as {}; leave it out.", o.kind));
  ExportOptions options;
  if (o.file != "-") options.file = std::filesystem::absolute(o.file);
  if (!o.lerobot.empty()) options.lerobot = read_file(o.lerobot);
  return options;
}

int run(const ExportArguments& o) {
  if (o.kind.empty())
    throw InputError(
        message("--as is missing: for what the file is; expected one of {}.", fmt::join(export_kinds, ", ")));
  if (o.file.empty()) throw InputError("--out is missing: name the file to write; - is standard output.");
  note_input(o.lerobot);
  const CalibratedRobot robot = predict_source(o.source);
  require_output(o.file, "--out");
  o.output.require_places();
  if (o.file == "-" && o.output.json_file == "-")
    throw InputError("--out - and --json - would both go to standard output; name a file for one of them.");
  for (const Message& note : robot.notes) Output::note(note);
  const ExportedFile file = exported_file(robot, o.kind, options_of(o));
  for (const Message& note : file.notes) Output::note(note);
  o.output.json(export_json(o.kind, o.file, file));
  if (o.file == "-") {
    std::cout << file.text;
    return done;
  }
  write_output(o.file, file.text, "--out");
  o.output.line("Written: " + o.file);
  return done;
}

}  // namespace

Command add_export(const CommandLine& program) {
  auto options = std::make_shared<ExportArguments>();
  const CommandLine command = program.command(
      "export", "Takes a calibration to the robot: URDF, MuJoCo, Gazebo, ROS 2, UR, DH tables, C++, Python and more");
  add_source_options(command, options->source);
  command
      .option("--as", options->kind,
              "urdf, xacro (a macro with name and parent), mjcf (MuJoCo), sdf (Gazebo), dh (tables, CSV or YAML), "
              "ur_calibration (UR's ROS drivers), static_tf (a ROS 2 launch file), ros2_control and lerobot (joint "
              "offsets), opencv, yaml, csv, cpp or python (the corrected hand pose in one file)")
      .one_of(std::vector<std::string>(export_kinds.begin(), export_kinds.end()));
  command.option("--out", options->file, "The file to write; - is standard output");
  command.option("--lerobot", options->lerobot,
                 "With --as lerobot: the arm's calibration as lerobot wrote it, to be changed");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
