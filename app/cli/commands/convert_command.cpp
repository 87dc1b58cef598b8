// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "command.h"
#include "convert/convert.h"
#include "options/target_option.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct ConvertArguments {
  std::vector<std::string> files;
  std::string out, robot;
  ConvertOptions convert;
  TargetOptions target;
  Output output;
};

std::string sensor_text(const Session& s) {
  if (s.pose_sensor) return "poses of the target";
  if (!s.rig) return fmt::format("{} points of a tracker", s.marker_count);
  return fmt::format("{} {}", s.rig->count(), s.rig->count() == 1 ? "camera" : "cameras");
}

int run(const ConvertArguments& o) {
  ConvertOptions options = o.convert;
  options.out = o.out;
  options.robot = o.robot;
  if (is_given(o.target)) options.target = target_from(o.target);
  note_input(o.robot);
  std::vector<std::filesystem::path> files;
  for (const std::string& file : o.files) {
    files.emplace_back(file);
    note_input(file);
  }
  o.output.require_places();
  const Conversion made = convert(files, options);
  for (const std::string& note : made.notes) Output::note(note);
  for (const std::string& file : made.took) o.output.line(file);
  const Session& s = made.session;
  o.output.line(
      fmt::format("{}: {} observations, {} joints, {}", o.out, s.observations.size(), s.joints.size(), sensor_text(s)));
  o.output.line(
      fmt::format("Next: handsight-cli check {0}, then {1} {0}", o.out,
                  needs_label(s) ? "label the first observation with handsight-cli label" : "handsight-cli fit"));
  o.output.json({{"out", o.out},
                 {"observations", s.observations.size()},
                 {"joints", s.joints},
                 {"took", made.took},
                 {"notes", made.notes}});
  return done;
}

}  // namespace

Command add_convert(const CommandLine& program) {
  auto o = std::make_shared<ConvertArguments>();
  const CommandLine command =
      program.command("convert", "Makes a session of what you have: each file is known by its content");
  command
      .option("WHAT", o->files,
              "Image folders, joint tables, calibrations of OpenCV, ROS or Kalibr, easy_handeye samples, tables of "
              "poses or points, ROS 2 bags, a URDF")
      .required();
  command.option("--out", o->out, "Folder to make; it must not hold a session already").required();
  command.option("--robot", o->robot, "URDF");
  command.option("--tcp", o->convert.tcp, "The link that is the hand");
  command.option("--mount", o->convert.mount, "The link that carries the sensor; the root link where it stands");
  command.option("--title", o->convert.title, "Title of the session");
  command.option("--markers", o->convert.markers, "How many markers the images show").from_to(1, 64);
  command.flag("--degrees", o->convert.degrees, "Joint tables are in degrees");
  command.flag("--eye-on-base", o->convert.eye_on_base,
               "Poses of the flange in place of a robot: the camera stands, the flange carries the target");
  command.option("--target-frame", o->convert.target_frame, "The target's frame in /tf of a bag");
  command.option("--lag", o->convert.pairing.lag, "s: how much later the sensor's times are than the joints'")
      .within(-100, 100);
  command.flag("--estimate-lag", o->convert.estimate_lag, "Find the lag from movements that both show");
  command.option("--still", o->convert.pairing.still_for, "s for which the robot must stand; 0: it may move")
      .within(0, 60);
  add_target_options(command, o->target, true);
  add_json_option(command, o->output);
  return {command, [o] { return run(*o); }};
}

}  // namespace handsight::cli
