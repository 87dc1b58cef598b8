// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/numbers.h"
#include "blunders/mended.h"
#include "command.h"
#include "convert/bags/bag_sessions.h"
#include "convert/convert.h"
#include "convert/convert_collection.h"
#include "geometry/angle_kinds.h"
#include "options/session_lists.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct ConvertArguments {
  std::vector<std::string> files, fixes;
  std::string out, robot;
  std::string columns;
  bool one_sensor = false;
  ConvertOptions convert;
  SessionLists sessions;
  Output output;
};

std::string sensor_summary(const Session& s) {
  if (s.pose_sensor) return "poses of the target";
  if (s.is_touch()) return fmt::format("{} fixture{} touched", s.fixtures.size(), s.fixtures.size() == 1 ? "" : "s");
  if (!s.rig) return fmt::format("{} points of a tracker", s.marker_count);
  return fmt::format("{} {}", s.rig->count(), s.rig->count() == 1 ? "camera" : "cameras");
}

/// A session with its blunders put right beside it, in place of one that is made of other files.
int run_fix(const ConvertArguments& o) {
  if (o.files.size() != 1)
    throw InputError(
        message("--fix puts one session right; name its folder and no other file ({} are named).", o.files.size()));
  const Session session = open_searched_session(o.files.front(), o.output);
  const Session made = write_mended(session, o.fixes, o.out);
  o.output.line(
      fmt::format("{}: {} observations, put right: {}", o.out, made.observations.size(), fmt::join(o.fixes, ", ")));
  o.output.line(fmt::format("Next: handsight-cli fit {}", o.out));
  o.output.json(
      {{"out", o.out}, {"observations", made.observations.size()}, {"joints", made.joints}, {"fixed", o.fixes}});
  return done;
}

std::string summary(const std::string& folder, const Session& s) {
  const std::string robot =
      s.robot.is_of_poses ? std::string("poses of the flange") : fmt::format("{} joints", s.joints.size());
  return fmt::format("{}: {} observations, {}, {}", folder, s.observations.size(), robot, sensor_summary(s));
}

void print_notes(const std::vector<Message>& notes) {
  for (const Message& note : notes) Output::note(note);
}

int make_session(const std::vector<std::filesystem::path>& files, const ConvertOptions& options, const Output& output) {
  const Conversion made = convert(files, options);
  print_notes(made.notes);
  for (const Message& file : made.took) output.line(file);
  const Session& s = made.session;
  const std::string out = options.out.string();
  output.line(summary(out, s));
  output.line(
      fmt::format("Next: handsight-cli check {0}, then {1} {0}", out,
                  needs_label(s) ? "label the first observation with handsight-cli label" : "handsight-cli fit"));
  output.json({{"out", out},
               {"observations", s.observations.size()},
               {"joints", s.joints},
               {"took", made.took},
               {"notes", made.notes}});
  return done;
}

/// What is said of every session is said once.
std::vector<Message> said_of_each(const ConvertedCollection& made, std::vector<Message> Conversion::*what) {
  std::vector<Message> all;
  for (const Conversion& c : made.sessions)
    for (const Message& sentence : c.*what) {
      const bool is_of_all = std::all_of(made.sessions.begin(), made.sessions.end(), [&](const Conversion& other) {
        return std::count((other.*what).begin(), (other.*what).end(), sentence) > 0;
      });
      const Message text = is_of_all ? sentence : message("{}: {}", c.session.title, sentence);
      if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
    }
  return all;
}

int make_collection(const std::vector<std::filesystem::path>& files, const CollectionOptions& options,
                    const Output& output) {
  const ConvertedCollection made = convert_collection(files, options);
  print_notes(said_of_each(made, &Conversion::notes));
  print_notes(made.notes);
  for (const Message& file : said_of_each(made, &Conversion::took)) output.line(file);
  const std::string out = options.out.string();
  bool unlabelled = false;
  Json sessions = Json::array();
  for (std::size_t i = 0; i < made.sessions.size(); ++i) {
    const Conversion& c = made.sessions[i];
    const CollectionEntry& entry = made.collection.entries[i];
    output.line(summary((options.out / entry.folder).string(), c.session));
    unlabelled |= needs_label(c.session);
    sessions.push_back({{"title", entry.title},
                        {"folder", entry.folder},
                        {"rig", entry.rig},
                        {"body", entry.body},
                        {"observations", c.session.observations.size()},
                        {"joints", c.session.joints},
                        {"took", c.took},
                        {"notes", c.notes}});
  }
  output.line(fmt::format("Next: handsight-cli check {0}, then {1} {0}", out,
                          unlabelled ? "label the first observation of each session with handsight-cli label, then "
                                       "handsight-cli fit"
                                     : "handsight-cli fit"));
  output.json({{"out", out}, {"sessions", sessions}, {"notes", made.notes}});
  return done;
}

int run(const ConvertArguments& o) {
  if (!o.fixes.empty()) return run_fix(o);
  ConvertOptions common = o.convert;
  common.out = o.out;
  common.robot = o.robot;
  for (const std::string_view name : split_words(o.columns)) common.columns.emplace_back(name);
  note_input(o.robot);
  std::vector<std::filesystem::path> files;
  for (const std::string& file : o.files) {
    files.emplace_back(file);
    note_input(file);
  }
  o.output.require_places();
  std::vector<Message> parted;
  const std::vector<ConvertOptions> sessions = sessions_of_bag(files, options_of_sessions(o.sessions, common), parted);
  print_notes(parted);
  if (sessions.size() > 1)
    return make_collection(
        files,
        {o.out, o.sessions.titles.size() == 1 ? o.sessions.titles.front() : std::string(), o.one_sensor, sessions},
        o.output);
  if (o.one_sensor)
    throw InputError("--one-sensor is of a collection; give --tcp, --title or --target-frame once for each session.");
  return make_session(files, sessions.front(), o.output);
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
  add_session_lists(command, o->sessions);
  command.flag("--one-sensor", o->one_sensor,
               "Of a collection: one tracker at one place measured all sessions, where their files do not tell it");
  command.option("--markers", o->convert.markers, "How many markers the images show").from_to(1, 64);
  command.flag("--degrees", o->convert.degrees,
               "Tables of joints and angles of poses are in degrees where they do not say so");
  command
      .option("--angles", o->convert.angles,
              "What three or four numbers of a pose are: rotation_vector (UR), rpy, abc (KUKA), wpr (Fanuc), oat "
              "(Kawasaki), staubli, quaternion_xyzw, quaternion_wxyz (ABB) ...; otherwise it is found out")
      .one_of(angle_kind_names());
  command.flag("--eye-on-base", o->convert.eye_on_base,
               "Poses of the flange in place of a robot: the camera stands, the flange carries the target");
  command.option("--fixture", o->convert.fixtures,
                 "Of touches: what was touched, \"plane table\", \"point socket_1\", \"gauge dial xyz=0.6,0,0.5 "
                 "axis=0,1,0\", also sigma=, mount=, place_sigma=, value= (m)");
  command.option("--apart", o->convert.apart, "Of touches: \"socket_1 socket_2 by=0.05 sigma=1e-5\" (m)");
  command.option("--table-columns", o->columns,
                 "Of tables without a header: \"a1[deg] a2[deg] - x[mm] y[mm] z[mm]\", of touches \"a1 a2 - fixture "
                 "value[mm]\"; - is left out");
  command.option("--lag", o->convert.pairing.lag, "s: how much later the sensor's times are than the joints'")
      .within(-100, 100);
  command.flag("--estimate-lag", o->convert.estimate_lag, "Find the lag from movements that both show");
  command.option("--still", o->convert.pairing.still_for, "s for which the robot must stand; 0: it may move")
      .within(0, 60);
  add_json_option(command, o->output);
  return {command, [o] { return run(*o); }};
}

}  // namespace handsight::cli
