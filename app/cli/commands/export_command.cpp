// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>

#include "base/error.h"
#include "command.h"
#include "export/exported.h"
#include "options/predict_source.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct ExportArguments {
  SourceOptions source;
  std::string kind, file;
};

int run(const ExportArguments& o) {
  const CalibratedRobot robot = predict_source(o.source);
  require_output(o.file, "--out");
  for (const std::string& note : robot.notes) Output::note(note);
  const ExportedFile file = exported_file(robot, o.kind);
  for (const std::string& note : file.notes) Output::note(note);
  if (o.file == "-") {
    std::cout << file.text;
    return done;
  }
  write_output(o.file, file.text, "--out");
  Output{}.line("Written: " + o.file);
  return done;
}

}  // namespace

Command add_export(const CommandLine& program) {
  auto options = std::make_shared<ExportArguments>();
  const CommandLine command =
      program.command("export", "Takes a calibration to the robot: URDF, YAML, ROS 2, OpenCV, C++, Python, CSV");
  add_source_options(command, options->source);
  command
      .option("--as", options->kind,
              "urdf, yaml, static_tf (a ROS 2 launch file), opencv, cpp or python (the corrected hand pose in one "
              "file), csv")
      .required()
      .one_of(std::vector<std::string>(export_kinds.begin(), export_kinds.end()));
  command.option("--out", options->file, "The file to write; - is standard output").required();
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
