// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/files.h"
#include "command.h"
#include "compare/comparison.h"
#include "options/named_effects.h"
#include "options/predict_source.h"
#include "printing/json_values.h"
#include "printing/outputs.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"

namespace handsight::cli {
namespace {

struct CompareArguments {
  std::string before, after, robot;
  std::vector<std::string> effects;
  Output output;
};

const char* verdict_name(ComparisonVerdict v) {
  return v == ComparisonVerdict::unchanged ? "unchanged" : v == ComparisonVerdict::changed ? "changed" : "several";
}

Json change_json(const Change& c) {
  Json parameters = Json::array();
  Eigen::Index s = 0;
  for (const EffectTerm& t : c.terms) {
    const Effect& effect = effect_of(t);
    for (std::size_t p = 0; p < t.values.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      parameters.push_back({{"id", t.id},
                            {"name", effect.parameters[p].name},
                            {"value", number(t.values[p])},
                            {"sigma", s < c.sigma.size() ? number(c.sigma[s]) : Json(nullptr)},
                            {"unit", c.units[static_cast<std::size_t>(s)]}});
      ++s;
    }
  }
  return {{"id", c.id},
          {"where", c.where},
          {"ln_bayes_factor", number(c.ln_bayes_factor)},
          {"explained", number(c.explained)},
          {"parameters", parameters}};
}

void tell(const CompareArguments& o, const Comparison& c) {
  for (const Message& note : c.notes) Output::note(note);
  o.output.line(c.sentence);
  if (!c.changes.empty()) {
    o.output.line();
    o.output.line("what may have changed   ln Bayes factor   where");
    for (const Change& change : c.changes)
      o.output.line(fmt::format("{:<22} {:>16.1f}   {}", change.id, change.ln_bayes_factor,
                                change.where.empty() ? "" : change.where.front()));
    o.output.line(fmt::format("(what counts: above {:.1f})", c.threshold));
  }
  if (!c.numbers.empty()) {
    o.output.line();
    o.output.line("number                                  change        sigma   in sigmas");
    for (const NumberChange& n : c.numbers)
      o.output.line(fmt::format("{:<34} {:>11.4g} {:>12.3g} {:>11.1f}  {}", n.name, n.after - n.before, n.sigma,
                                n.in_sigmas(), n.unit));
  }
  if (c.hand_mean_m)
    o.output.line(
        fmt::format("\nThe hand is {:.3f} mm from where it was in the mean over these poses, at most {:.3f} mm.",
                    1e3 * *c.hand_mean_m, 1e3 * c.hand_max_m.value_or(0)));
}

Json comparison_json(const Comparison& c) {
  Json changes = Json::array(), numbers = Json::array();
  for (const Change& change : c.changes) changes.push_back(change_json(change));
  for (const NumberChange& n : c.numbers)
    numbers.push_back({{"name", n.name},
                       {"unit", n.unit},
                       {"before", number(n.before)},
                       {"after", number(n.after)},
                       {"sigma", number(n.sigma)},
                       {"in_sigmas", number(n.in_sigmas())}});
  return {{"verdict", verdict_name(c.verdict)},
          {"reason", c.sentence},
          {"changes", changes},
          {"cannot_be_told_from", c.cannot_be_told_from},
          {"threshold", number(c.threshold)},
          {"numbers", numbers},
          {"hand_mean_m", number(c.hand_mean_m)},
          {"hand_max_m", number(c.hand_max_m)},
          {"model_fits", c.model_fits}};
}

CalibratedRobot calibration_of(const std::string& path, const std::string& robot) {
  if (robot.empty())
    throw InputError(message("{}: a calibration alone has no robot; name its URDF with --robot.", path));
  return calibrated_robot(read_calibration(path), read_urdf(robot), robot, path);
}

Comparison compared(const CompareArguments& o) {
  const bool first = is_calibration_file(o.before), second = is_calibration_file(o.after);
  if (first && second) return compare(calibration_of(o.before, o.robot), calibration_of(o.after, o.robot));
  if (second)
    throw InputError(
        "The second is a calibration and the first a session: name the calibration first, it is the older one.");
  if (!first) {
    const Session before = open_searched_session(o.before), after = open_searched_session(o.after);
    std::vector<EffectTerm> held, estimated;
    add_effects(o.effects, before, held, estimated);
    if (!held.empty()) throw InputError("--effects of compare are estimated; name them without values.");
    return compare(before, after, estimated);
  }
  const Session after = open_searched_session(o.after);
  CalibratedRobot robot = calibrated_robot(read_calibration(o.before), after.robot, after.robot_file, o.before);
  return compare(o.robot.empty() ? robot : calibration_of(o.before, o.robot), after);
}

int run(const CompareArguments& o) {
  for (const std::string& input : {o.before, o.after, o.robot}) note_input(input);
  o.output.require_places();
  const Comparison c = compared(o);
  tell(o, c);
  o.output.json(comparison_json(c));
  return done;
}

}  // namespace

Command add_compare(const CommandLine& program) {
  auto options = std::make_shared<CompareArguments>();
  const CommandLine command = program.command(
      "compare", "What has changed between two sessions of one robot, or since a calibration, by evidence");
  command.option("BEFORE", options->before, "A session or a calibration XML").required();
  command.option("AFTER", options->after, "A later session (a few poses will do for a calibration), or calibration")
      .required();
  command.option("--robot", options->robot, "URDF; needed with two calibrations");
  command.option("--effects", options->effects, "Effects in the model of both sessions, estimated");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
