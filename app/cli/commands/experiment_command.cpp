// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <iostream>

#include "base/degrees.h"
#include "base/text.h"
#include "command.h"
#include "experiment/driver/child_driver.h"
#include "experiment/loop/experiment.h"
#include "options/competing_effects.h"
#include "options/named_effects.h"
#include "printing/json_values.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct ExperimentArguments {
  std::string session, driver, between, cell;
  std::vector<std::string> until, effects;
  std::vector<double> box;
  double speed = 0.2, patience = 30;
  std::uint64_t seed = 1;
  int batch = 5;
  bool dry_run = false, yes = false;
  Output output;
};

std::atomic<bool> is_stopped = false;

constexpr int usual_count = 60;
constexpr double usual_odds = 20;

Goals goals_of(const ExperimentArguments& o) {
  Goals goals;
  for (const std::string& text : o.until) add_goals(text, goals);
  if (!goals.wants_something() && !goals.count && !goals.seconds) goals.odds = usual_odds;
  if (!goals.count && !goals.seconds) goals.count = usual_count;  // nothing goes on for ever
  return goals;
}

std::string degrees_text(const Eigen::VectorXd& position) {
  std::string text;
  for (const double q : position) text += fmt::format(" {:>7.1f}", q * degrees);
  return text;
}

const std::string& fixture_of(const Session& session, const ChosenPose& pose) {
  return session.fixtures[static_cast<std::size_t>(pose.fixture)].id;
}

void print_plan(const ExperimentArguments& o, const Session& session, const std::vector<PlannedMove>& moves) {
  o.output.line(fmt::format("next {} poses (joints in degrees, mm where they slide count as radians):", moves.size()));
  for (const PlannedMove& move : moves)
    o.output.line(fmt::format("  {}   {:>5.2f} rad{}  {}{}", degrees_text(move.pose.position), move.length,
                              move.way.size() > 1 ? fmt::format(", round by {} points", move.way.size() - 1) : "",
                              move.pose.fixture < 0 ? "" : "to touch " + fixture_of(session, move.pose) + ", ",
                              reason_text(move.pose.reason)));
}

void print_step(const ExperimentArguments& o, const ExperimentStep& step) {
  if (step.id < 0) return o.output.line("     -  " + step.reason);
  o.output.line(fmt::format("{:>6}  {}{}{}", step.id, step.accepted ? "taken" : "rejected",
                            step.reason.empty() ? "" : ": ", step.reason));
}

std::string cause_words(const SettledCause& cause) {
  if (cause.follows) return fmt::format("a form without a name along the {}", *cause.follows);
  return cause.id.empty() ? "nothing missing" : cause.id;
}

void print_knowledge(const ExperimentArguments& o, const Knowledge& known) {
  std::string text = fmt::format("        {} observations", known.used);
  if (known.hand_limit) text += fmt::format(", hand within {:.3g} mm (95 %)", 1e3 * *known.hand_limit);
  if (known.diagnosis) text += std::string(", ") + verdict_text(known.diagnosis->verdict);
  if (known.settled) text += fmt::format(", {} by odds of {:.2g}", cause_words(*known.settled), known.settled->odds);
  o.output.line(text);
}

/// Asks on the terminal; where there is none --yes is needed.
bool is_confirmed(const ExperimentArguments& o, const std::vector<PlannedMove>& moves) {
  if (o.yes) return true;
  if (isatty(STDIN_FILENO) == 0)
    throw InputError("The robot would move now, and nobody can be asked: give --yes, or look first with --dry-run.");
  std::cerr << fmt::format(
                   "The robot moves now, {} poses at first, the first one at a tenth of {} rad/s. Go on? [y/N] ",
                   moves.size(), o.speed)
            << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "y" || answer == "yes";
}

Json move_json(const Session& session, const PlannedMove& move) {
  Json path = Json::array();
  for (const Eigen::VectorXd& point : move.way) path.push_back(numbers(point));
  Json json{{"position", numbers(move.pose.position)}, {"why", reason_name(move.pose.reason)}, {"path", path}};
  if (move.pose.fixture < 0) return json;
  json["fixture"] = fixture_of(session, move.pose);
  json["touching"] = numbers(move.pose.touching);
  return json;
}

Json cause_json(const SettledCause& cause) {
  return {{"id", cause.id.empty() ? Json(nullptr) : Json(cause.id)},
          {"follows", cause.follows ? Json(*cause.follows) : Json(nullptr)},
          {"where", cause.where},
          {"odds", number(cause.odds)}};
}

Json result_json(const ExperimentResult& r) {
  Json steps = Json::array(), planned = Json::array();
  for (const ExperimentStep& step : r.steps) {
    Json line = move_json(r.session, step.move);
    line["id"] = step.id < 0 ? Json(nullptr) : Json(step.id);
    line["state"] = step.id < 0 ? "none" : step.accepted ? "accepted" : "rejected";
    line["reason"] = step.reason;
    line["hand_limit_m"] = number(step.hand_limit);
    steps.push_back(line);
  }
  for (const PlannedMove& move : r.planned) planned.push_back(move_json(r.session, move));
  const Knowledge& known = r.known;
  return {{"stopped", end_name(r.end)},
          {"reason", r.reason},
          {"more", r.more},
          {"moves", r.moves},
          {"observations", r.observations},
          {"accepted", r.accepted},
          {"used", known.used},
          {"hand_limit_m", number(known.hand_limit)},
          {"verdict", known.diagnosis ? Json(verdict_text(known.diagnosis->verdict)) : Json(nullptr)},
          {"cause", r.settled       ? cause_json(*r.settled)
                    : known.settled ? cause_json(*known.settled)
                                    : Json(nullptr)},
          {"settled", r.settled.has_value()},
          {"tcp_from_body", known.fit ? six(known.fit->tcp_from_body) : Json(nullptr)},
          {"sigma", known.fit ? numbers(known.fit->covariance.diagonal().cwiseSqrt()) : Json(nullptr)},
          {"planned", planned},
          {"steps", steps}};
}

ExperimentOptions options_of(const ExperimentArguments& o, const Session& session) {
  ExperimentOptions options;
  options.until = goals_of(o);
  add_effects(o.effects, session, options.model.held, options.model.estimated);
  if (!o.between.empty()) options.between = competing(o.between, session);
  if (!o.cell.empty()) options.cell = read_cell(o.cell);
  if (!o.box.empty()) {
    const Vector3 a(o.box[0], o.box[1], o.box[2]), b(o.box[3], o.box[4], o.box[5]);
    options.box = WorkBox{a.cwiseMin(b), a.cwiseMax(b)};
  }
  options.speed = o.speed;
  options.seed = o.seed;
  options.batch = o.batch;
  options.dry_run = o.dry_run;
  options.confirm = [&o](const std::vector<PlannedMove>& moves) { return is_confirmed(o, moves); };
  options.on_plan = [&](const std::vector<PlannedMove>& moves) { print_plan(o, session, moves); };
  options.on_step = [&o](const ExperimentStep& step) { print_step(o, step); };
  options.on_knowledge = [&o](const Knowledge& known) { print_knowledge(o, known); };
  options.on_note = [](const Message& text) { Output::note(text); };
  options.is_interrupted = [] { return is_stopped.load(); };
  return options;
}

int run(const ExperimentArguments& o) {
  for (const std::string& input : {o.cell}) note_input(input);
  const Session session = open_session(o.session, o.output);
  if (const auto need = what_paths_need()) throw InputError(*need);
  const ExperimentOptions options = options_of(o, session);
  std::signal(SIGINT, [](int) { is_stopped = true; });
  std::signal(SIGTERM, [](int) { is_stopped = true; });
  DriverPatience patience;
  patience.look = patience.move = o.patience;
  patience.hello = std::max(patience.hello, o.patience);  // programs take their time to begin
  ChildDriver driver(o.driver, session, patience, [] { return is_stopped.load(); });
  const ExperimentResult result = run_experiment(session, driver, options);
  o.output.json(result_json(result));
  if (result.end == ExperimentEnd::fault) {
    std::cerr << printable(shortened(result.reason.english(), 600)) << '\n';
    return wrong_input;
  }
  o.output.line();
  o.output.line(result.reason);
  if (!result.more.empty()) o.output.line(result.more);
  const bool is_done =
      result.end == ExperimentEnd::reached || result.end == ExperimentEnd::dry_run ||
      (!options.until.wants_something() && (result.end == ExperimentEnd::count || result.end == ExperimentEnd::time));
  return is_done ? done : answer_is_no;
}

}  // namespace

Command add_experiment(const CommandLine& program) {
  auto o = std::make_shared<ExperimentArguments>();
  const CommandLine command =
      program.command("experiment", "Chooses poses, drives the robot there, looks, and stops when enough is known");
  add_session_option(command, o->session);
  command.option("--driver", o->driver, "The command of the driver, which moves the robot (docs/experiment.md)")
      .required();
  command.option("--until", o->until,
                 "When it is enough: hand=0.3mm, odds=20, count=60, time=30min; several with | between");
  command.option("--between", o->between, "Choose poses that tell these two effects apart: a,b");
  command.option("--effects", o->effects, "Effects in the model: id, id:joint+joint, id:joint.number=value");
  command.option("--cell", o->cell, "What stands about the robot: cell.xml");
  command.option("--box", o->box, "m, x y z x y z in the root's frame: where the hand is to be known")
      .takes(6)
      .within(-1000, 1000);
  command.option("--speed", o->speed, "rad/s (m/s) of the fastest joint; the first move takes a tenth of it")
      .within(1e-3, 10)
      .shows_default();
  command.option("--wait", o->patience, "s: how long answers are waited for, beside three times a move's own time")
      .within(0.05, 1e5)
      .shows_default();
  command.option("--batch", o->batch, "Poses that are chosen at once").from_to(1, 50).shows_default();
  command.option("--seed", o->seed, "Of the poses to choose from");
  command.flag("--dry-run", o->dry_run, "Show the first poses and paths; nothing moves");
  command.flag("--yes", o->yes, "Do not ask before the robot moves");
  add_json_option(command, o->output);
  return {command, [o] { return run(*o); }};
}

}  // namespace handsight::cli
