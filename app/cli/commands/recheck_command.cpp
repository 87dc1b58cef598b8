// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

#include "base/text.h"
#include "base/utc_now.h"
#include "command.h"
#include "compare/change_watch.h"
#include "detection/target_finding.h"
#include "experiment/driver/child_driver.h"
#include "experiment/loop/experiment.h"
#include "experiment/recheck/recheck_log.h"
#include "experiment/recheck/recheck_poses.h"
#include "live/arrivals.h"
#include "printing/json_values.h"
#include "printing/outputs.h"
#include "robot/urdf.h"
#include "session/calibration_xml.h"

namespace handsight::cli {
namespace {

struct RecheckArguments {
  std::string calibration, session, robot, driver, cell, watch, csv;
  double watch_for = 0, speed = 0.2, patience = 30;
  int poses = 5;
  bool yes = false;
  Output output;
};

std::atomic<bool> is_recheck_stopped = false;

Json size_json(const WatchStep& step) {
  Json sizes = Json::array();
  Eigen::Index next = 0;
  for (const EffectTerm& term : step.terms) {
    const Effect& effect = term_effect(term);
    for (std::size_t p = 0; p < term.values.size(); ++p) {
      if (effect.parameters[p].is_choice) continue;
      sizes.push_back({{"id", term.id},
                       {"name", effect.parameters[p].name},
                       {"value", number(term.values[p])},
                       {"sigma", number(step.sigma[next++])},
                       {"unit", effect.parameters[p].unit}});
    }
  }
  return sizes;
}

Json step_json(const Observation& o, const WatchStep& step) {
  return {{"id", o.id},
          {"e_value", number(compute_e_value(step))},
          {"ln_e_value", number(step.ln_e_value)},
          {"changed", step.changed},
          {"what", step.what},
          {"where", step.where},
          {"cannot_be_told_from", step.indistinguishable_from},
          {"text", step.text},
          {"size", size_json(step)}};
}

/// Hears of every observation: says a line, keeps the log.
class Rechecking {
 public:
  Rechecking(const RecheckArguments& options, const CalibratedRobot& before) : options_(options), watch_(before) {}

  /// `is_new` false: it was looked at in an earlier run and is only counted again.
  void take(const Session& session, const Observation& o, bool is_new = true) {
    const auto step = watch_.add(session, o);
    if (!step) return;
    last_ = step;
    ++count_;
    if (!is_new) return;
    if (options_.output.json_file == "-")
      std::cout << json_text(step_json(o, *step), -1) << '\n' << std::flush;
    else
      lines_ += json_text(step_json(o, *step), -1) + '\n';
    options_.output.line(fmt::format("{:>6}  e-value {:>9.3g}  {}{}", o.id, compute_e_value(*step),
                                     step->changed ? "CHANGED  " : "", step->changed ? step->text : ""));
    std::cout.flush();
    if (!options_.csv.empty()) add_to_log(options_.csv, recheck_entry(utc_now(), o.id, *step));
  }

  int finish() {
    if (!options_.output.json_file.empty() && options_.output.json_file != "-")
      write_output(options_.output.json_file, lines_, "--json");
    if (!last_) throw InputError("No observation shows anything that can be compared with the calibration.");
    options_.output.line();
    options_.output.line(
        last_->changed
            ? fmt::format("Something has changed (the chance of such a word without a change is 1 in 1000 over all "
                          "time). {}.",
                          last_->text)
            : fmt::format("Nothing speaks for a change after {} observations (e-value {:.3g}; 1000 would).", count_,
                          compute_e_value(*last_)));
    return last_->changed ? answer_is_no : done;
  }

 private:
  const RecheckArguments& options_;
  ChangeWatch watch_;
  std::optional<WatchStep> last_;
  std::string lines_;
  int count_ = 0;
};

/// A session of a tracker that the calibration alone describes.
Session find_session(const CalibratedRobot& before) {
  if (!before.calibration.fit.noise_m || before.calibration.fit.noise_pixel)
    throw InputError(
        "recheck --driver: a calibration does not say what the cameras are; name a session of the same robot and "
        "cameras "
        "too, into which the observations go: recheck CALIBRATION SESSION --driver ...");
  Session s;
  s.file = "recheck";
  s.robot = before.chain.robot;
  s.tcp = before.tcp;
  s.mount.link = before.mount;
  s.mount.estimate = before.calibration.mount_from_sensor.has_value();
  if (before.model.mount_from_sensor) s.mount.mount_from_sensor = *before.model.mount_from_sensor;
  s.gravity = before.chain.gravity;
  s.joints = before.joint_names;
  s.marker_count = static_cast<int>(before.calibration.markers.size());
  s.sigma_point = before.calibration.fit.noise_m;
  Observation& o = s.observations.emplace_back();
  o.position = before.positions.empty() ? Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s.joints.size()))
                                        : before.positions.back();
  return s;
}

bool is_confirmed(const RecheckArguments& o, std::size_t poses) {
  if (o.yes) return true;
  if (isatty(STDIN_FILENO) == 0) throw InputError("The robot would move now, and nobody can be asked: give --yes.");
  std::cerr << fmt::format("The robot moves now, to {} poses, at first at a tenth of {} rad/s. Go on? [y/N] ", poses,
                           o.speed)
            << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "y" || answer == "yes";
}

void drive(const RecheckArguments& o, const CalibratedRobot& before, const Session& session, bool keeps,
           Rechecking& rechecking) {
  if (const auto need = what_paths_need()) throw InputError(*need);
  ExperimentOptions options;
  options.save = keeps;
  options.speed = o.speed;
  if (!o.cell.empty()) options.cell = read_cell(o.cell);
  options.given = recheck_poses(before, session, options.cell, o.poses);
  options.confirm = [&](const std::vector<PlannedMove>& moves) { return is_confirmed(o, moves.size()); };
  options.on_observation = [&](const Session& now, const Observation& one) { rechecking.take(now, one); };
  options.on_note = [](const Message& text) { Output::note(text); };
  options.is_interrupted = [] { return is_recheck_stopped.load(); };
  DriverPatience patience;
  patience.look = patience.move = o.patience;
  patience.hello = std::max(patience.hello, o.patience);  // programs take their time to begin
  ChildDriver driver(o.driver, session, patience, options.is_interrupted);
  const ExperimentResult result = run_experiment(session, driver, options);
  if (result.end == ExperimentEnd::fault) throw InputError(result.reason);
  if (result.end != ExperimentEnd::reached) Output::note(result.reason);
  if (result.observations < static_cast<int>(options.given.size()))
    Output::note(
        fmt::format("Only {} of {} poses were taken: to the others no way leads without a collision, or they "
                    "were refused.",
                    result.observations, options.given.size()));
}

void watch(const RecheckArguments& o, Session session, Rechecking& rechecking) {
  Arrivals arrivals(session);
  std::optional<TargetFinder> finder;
  if (session.target && session.rig) finder.emplace(session);
  std::int64_t next_id = 0;
  for (const Observation& one : session.observations) next_id = std::max(next_id, one.id + 1);
  const auto start = std::chrono::steady_clock::now();
  while (!is_recheck_stopped &&
         (o.watch_for <= 0 || std::chrono::steady_clock::now() - start < std::chrono::duration<double>(o.watch_for))) {
    Arrivals::Look look = arrivals.look();
    for (const Message& remark : look.remarks) Output::note(remark);
    for (Observation& one : look.arrived) {
      one.id = next_id++;
      if (finder && has_images(one)) one.sightings = finder->find(one).sightings;
      rechecking.take(session, one);
    }
    if (look.arrived.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

int run(const RecheckArguments& o) {
  for (const std::string& input : {o.calibration, o.robot, o.cell}) note_input(input);
  o.output.require_places();
  require_output(o.csv, "--csv");
  if (o.session.empty() && o.watch.empty() && o.driver.empty())
    throw InputError("recheck: say what is to be checked: a new session, --watch FOLDER, or --driver COMMAND.");
  const Calibration calibration = read_calibration(o.calibration);
  const std::string place = o.watch.empty() ? o.session : o.watch;
  if (place.empty() && o.robot.empty())
    throw InputError(message("{}: a calibration alone has no robot; name its URDF with --robot.", o.calibration));
  std::optional<Session> session;
  if (!place.empty()) session = open_searched_session(place);
  const CalibratedRobot before = o.robot.empty()
                                     ? calibrated_robot(calibration, session->robot, session->robot_file, o.calibration)
                                     : calibrated_robot(calibration, read_urdf(o.robot), o.robot, o.calibration);
  Rechecking rechecking(o, before);
  std::signal(SIGINT, [](int) { is_recheck_stopped = true; });
  std::signal(SIGTERM, [](int) { is_recheck_stopped = true; });
  if (session)
    for (const Observation& one : session->observations) rechecking.take(*session, one, o.driver.empty());
  if (!o.watch.empty()) watch(o, *session, rechecking);
  if (!o.driver.empty()) drive(o, before, session ? *session : find_session(before), session.has_value(), rechecking);
  return rechecking.finish();
}

}  // namespace

Command add_recheck(const CommandLine& program) {
  auto o = std::make_shared<RecheckArguments>();
  const CommandLine command = program.command(
      "recheck",
      "Has anything changed since a calibration? May be asked after every observation, every hour, for ever");
  command.option("CALIBRATION", o->calibration, "A calibration XML").required();
  command.option("SESSION", o->session, "New observations; with --driver those that it makes are added");
  command.option("--robot", o->robot, "URDF; the session's where it is left out");
  const Option driver = command.option("--driver", o->driver, "The command of a driver: it takes a few telling poses");
  command.option("--watch", o->watch, "A session's folder into which observations arrive").excludes(driver);
  command.option("--for", o->watch_for, "s: how long to watch; 0 until interrupted").within(0, 1e9);
  command.option("--poses", o->poses, "How many are driven to").from_to(1, 100).shows_default();
  command.option("--cell", o->cell, "What stands about the robot: cell.xml");
  command.option("--speed", o->speed, "rad/s (m/s) of the fastest joint; the first move takes a tenth of it")
      .within(1e-3, 10)
      .shows_default();
  command.option("--wait", o->patience, "s: how long answers of the driver are waited for")
      .within(0.05, 1e5)
      .shows_default();
  command.option("--csv", o->csv, "A log: a line is added for every observation");
  command.flag("--yes", o->yes, "Do not ask before the robot moves");
  add_json_option(command, o->output);
  return {command, [o] { return run(*o); }};
}

}  // namespace handsight::cli
