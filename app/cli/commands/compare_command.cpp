// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/text.h"
#include "command.h"
#include "compare/comparison.h"
#include "compare/several_comparison.h"
#include "estimation/report/export.h"
#include "options/joined_source.h"
#include "options/named_effects.h"
#include "options/predict_source.h"
#include "printing/comparison_output.h"
#include "printing/outputs.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"

namespace handsight::cli {
namespace {

struct CompareArguments {
  std::vector<std::string> sources;
  std::string robot;
  std::vector<std::string> effects;
  Output output;
};

CalibratedRobot make_calibration(const std::string& path, const std::string& robot) {
  if (robot.empty())
    throw InputError(message("{}: a calibration alone has no robot; name its URDF with --robot.", path));
  return calibrated_robot(read_calibration(path), read_urdf(robot), robot, path);
}

Comparison compared(const CompareArguments& o) {
  const std::string &older = o.sources[0], &newer = o.sources[1];
  const bool first = is_calibration_file(older), second = is_calibration_file(newer);
  if (first && second) return compare(make_calibration(older, o.robot), make_calibration(newer, o.robot));
  if (second)
    throw InputError(
        "The second is a calibration and the first a session: name the calibration first, it is the older one.");
  if (!first) {
    const Session before = open_searched_session(older), after = open_searched_session(newer);
    std::vector<EffectTerm> held, estimated;
    add_effects(o.effects, before, held, estimated);
    if (!held.empty()) throw InputError("--effects of compare are estimated; name them without values.");
    return compare(before, after, estimated);
  }
  const Session after = open_searched_session(newer);
  CalibratedRobot robot = calibrated_robot(read_calibration(older), after.robot, after.robot_file, older);
  return compare(o.robot.empty() ? robot : make_calibration(older, o.robot), after);
}

/// A collection's sessions with what it says that they share; sessions by themselves with the same sensor and body.
std::vector<JoinedMember> list_members(const std::vector<std::string>& sources) {
  const auto open = [](const std::string& path) { return open_searched_session(path); };
  if (sources.size() == 1 && is_collection(sources.front()))
    return opened_members(read_collection(sources.front()), open);
  const auto is_session = [](const std::string& s) { return !is_collection(s) && !is_calibration_file(s); };
  if (sources.size() == 1 || !std::all_of(sources.begin(), sources.end(), is_session))
    throw InputError(
        "compare takes two sessions or calibrations, or three sessions and more, or one collection; name them so.");
  Collection all = gather_collection(sources, {}, {});
  for (CollectionEntry& e : all.entries) e.rig = e.body = "the same";
  return opened_members(all, open);
}

/// Sessions of touches, each with the one before.
int compare_in_turn(const std::vector<JoinedMember>& members, const CompareArguments& o) {
  Json steps = Json::array();
  for (std::size_t i = 1; i < members.size(); ++i) {
    const JoinedMember &before = members[i - 1], &after = members[i];
    std::vector<EffectTerm> held, estimated;
    add_effects(o.effects, before.session, held, estimated);
    if (!held.empty()) throw InputError("--effects of compare are estimated; name them without values.");
    const Comparison c = compare(before.session, after.session, estimated);
    if (i > 1) o.output.line();
    o.output.line(fmt::format("{} -> {}", printable(before.title), printable(after.title)));
    print_comparison(o.output, c);
    Json step = comparison_json(c);
    step["before"] = before.title;
    step["after"] = after.title;
    steps.push_back(std::move(step));
  }
  o.output.json({{"steps", steps}});
  return done;
}

int compare_several(const CompareArguments& o) {
  if (!o.robot.empty()) throw InputError("--robot is for two calibrations; sessions have their own robot.");
  const std::vector<JoinedMember> members = list_members(o.sources);
  const auto is_touch = [](const JoinedMember& m) { return m.session.is_touch(); };
  if (members.size() > 1 && std::all_of(members.begin(), members.end(), is_touch)) return compare_in_turn(members, o);
  const SeveralComparison c = compare(members, o.effects);
  print_comparison(o.output, c);
  o.output.json(comparison_json(c));
  return done;
}

int run(const CompareArguments& o) {
  for (const std::string& input : o.sources) note_input(input);
  note_input(o.robot);
  o.output.require_places();
  if (o.sources.size() != 2) return compare_several(o);
  const Comparison c = compared(o);
  print_comparison(o.output, c);
  o.output.json(comparison_json(c));
  return done;
}

}  // namespace

Command add_compare(const CommandLine& program) {
  auto options = std::make_shared<CompareArguments>();
  const CommandLine command =
      program.command("compare", "What has changed between sessions of one robot, or since a calibration, by evidence");
  command
      .option("SESSION", options->sources,
              "Two sessions, the older first (or a calibration and a later session of a few poses, or two "
              "calibrations); three sessions and more in order of time (of touches: each with the one before); or one "
              "collection")
      .required();
  command.option("--robot", options->robot, "URDF; needed with two calibrations");
  command.option("--effects", options->effects, "Effects in the model of both sessions, estimated");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
