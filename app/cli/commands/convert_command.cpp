// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/numbers.h"
#include "blunders/mended.h"
#include "command.h"
#include "convert/convert.h"
#include "geometry/angle_kinds.h"
#include "options/target_option.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct ConvertArguments {
  std::vector<std::string> files, fixes;
  std::string out, robot;
  std::string columns;
  double sigma = 0, sigma_angle = 0;  // 0: not given
  ConvertOptions convert;
  TargetOptions target;
  Output output;
};

std::string sensor_text(const Session& s) {
  if (s.pose_sensor) return "poses of the target";
  if (s.is_touch()) return fmt::format("{} fixture{} touched", s.fixtures.size(), s.fixtures.size() == 1 ? "" : "s");
  if (!s.rig) return fmt::format("{} points of a tracker", s.marker_count);
  return fmt::format("{} {}", s.rig->count(), s.rig->count() == 1 ? "camera" : "cameras");
}

/// A session with its blunders put right beside it, in place of one that is made of other files.
int run_fix(const ConvertArguments& o) {
  if (o.files.size() != 1)
    throw InputError(
        fmt::format("--fix puts one session right; name its folder and no other file ({} are named).", o.files.size()));
  const Session session = open_searched_session(o.files.front(), o.output);
  const Session made = write_mended(session, o.fixes, o.out);
  o.output.line(
      fmt::format("{}: {} observations, put right: {}", o.out, made.observations.size(), fmt::join(o.fixes, ", ")));
  o.output.line(fmt::format("Next: handsight-cli fit {}", o.out));
  o.output.json(
      {{"out", o.out}, {"observations", made.observations.size()}, {"joints", made.joints}, {"fixed", o.fixes}});
  return done;
}

int run(const ConvertArguments& o) {
  if (!o.fixes.empty()) return run_fix(o);
  ConvertOptions options = o.convert;
  options.out = o.out;
  options.robot = o.robot;
  for (const std::string_view name : split_words(o.columns)) options.columns.emplace_back(name);
  if (o.sigma > 0) options.sigma = o.sigma;
  if (o.sigma_angle > 0) options.sigma_angle = o.sigma_angle;
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
      .option(
          "WHAT", o->files,
          "Image folders, joint tables, calibrations of OpenCV, ROS or Kalibr, easy_handeye samples, tables, "
          "lists, matrices or a folder of poses, tables of points, motion capture, bags of ROS, a URDF or a model of "
          "MuJoCo; with --fix a session")
      .required();
  command.option("--out", o->out, "Folder to make; it must not hold a session already").required();
  command.option("--fix", o->fixes,
                 "Puts right what check, fit and diagnose name, ID or ID:WHERE, of a session, and writes it to --out");
  command.option("--robot", o->robot, "URDF");
  command.option("--tcp", o->convert.tcp, "The link that is the hand");
  command.option("--mount", o->convert.mount, "The link that carries the sensor; the root link where it stands");
  command.option("--title", o->convert.title, "Title of the session");
  command.option("--markers", o->convert.markers, "How many markers the images show").from_to(1, 64);
  command.flag("--degrees", o->convert.degrees,
               "Tables of joints and angles of poses are in degrees where they do not say so");
  command
      .option("--angles", o->convert.angles,
              "What three or four numbers of a pose are: rotation_vector (UR), rpy, abc (KUKA), wpr (Fanuc), oat "
              "(Kawasaki), staubli, quaternion_xyzw, quaternion_wxyz (ABB) ...; otherwise it is found out")
      .one_of(angle_kind_names());
  command
      .option(
          "--sigma", o->sigma,
          "m: how exactly the tracker or the sensor of poses tells a place; of images how exactly the target is known")
      .within(0, 1);
  command.option("--sigma-angle", o->sigma_angle, "rad: how exactly a sensor of poses tells a turn").within(0, 3);
  command.flag("--eye-on-base", o->convert.eye_on_base,
               "Poses of the flange in place of a robot: the camera stands, the flange carries the target");
  command.option("--target-frame", o->convert.target_frame,
                 "The target: its frame in /tf of a bag, its topic, or its rigid body in motion capture");
  command.option("--fixture", o->convert.fixtures,
                 "Of touches: what was touched, \"plane table\", \"point socket_1\", \"gauge dial xyz=0.6,0,0.5 "
                 "axis=0,1,0\", also sigma=, mount=, place_sigma=, value= (m)");
  command.option("--apart", o->convert.apart, "Of touches: \"socket_1 socket_2 by=0.05 sigma=1e-5\" (m)");
  command.option("--table-columns", o->columns,
                 "Of tables of touches without a header: \"a1 a2 - fixture value[mm]\"; - is left out");
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
