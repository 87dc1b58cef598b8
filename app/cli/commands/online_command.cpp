// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <set>
#include <thread>

#include "base/degrees.h"
#include "command.h"
#include "detection/target_finding.h"
#include "estimation/online/online.h"
#include "live/arrivals.h"
#include "printing/json_values.h"
#include "printing/outputs.h"
#include "session/session_xml.h"
#include "vision/image/image_file.h"

namespace handsight::cli {
namespace {

struct OnlineArguments {
  std::string session;
  bool save = false, watch = false;
  double watch_for = 0;  // s; 0: until interrupted
  double body_gate_mm = 30;
  Output output;
};

Json step_json(const OnlineStep& step) {
  Json line{{"id", step.id},
            {"state", step.accepted ? "accepted" : "rejected"},
            {"reason", step.reason},
            {"milliseconds", step.milliseconds}};
  if (step.is_open) line["open"] = true;  // the same id comes again once it is decided
  line["tcp_from_body"] = step.has_estimate ? six(step.tcp_from_body) : Json(nullptr);
  line["sigma"] = step.has_estimate ? numbers(step.sigma) : Json(nullptr);
  line["tcp_from_tcp_est"] = step.tcp_from_tcp_est ? six(*step.tcp_from_tcp_est) : Json(nullptr);
  return line;
}

std::string step_line(const OnlineStep& step, const char* what) {
  std::string text = fmt::format("{:>5}  {}", step.id,
                                 step.accepted  ? "taken   "
                                 : step.is_open ? "open    "
                                                : "rejected");
  if (!step.accepted) return text + "  " + step.reason.english();
  text += fmt::format("  {} {} {}", step.sightings.size(), what, step.from_images ? "found   " : "labelled");
  if (step.has_estimate && step.tcp_from_tcp_est)
    text += fmt::format("  TCP off {:>6.2f} mm {:>5.2f} deg", 1e3 * step.tcp_from_tcp_est->translation.norm(),
                        degrees * vector_from_rotation(step.tcp_from_tcp_est->rotation).norm());
  return text;
}

std::optional<ImagePair> read_images(const Session& session, const Observation& o, Message& refusal) {
  if (o.images[0].empty() || o.images[1].empty() || !session.rig || !is_pair(*session.rig)) return std::nullopt;
  try {
    return ImagePair{read_image(folder(session) / o.images[0], session.rig->at(0).camera, o.images[0]),
                     read_image(folder(session) / o.images[1], session.rig->at(1).camera, o.images[1])};
  } catch (const InputError& error) {
    refusal = error.sentence();
    return std::nullopt;
  }
}

void print_estimate(const Output& output, const OnlineStep& last) {
  const Vector3 xyz = 1e3 * last.tcp_from_body.translation,
                rpy = degrees * rpy_from_rotation(last.tcp_from_body.rotation);
  output.line("tcp_from_body           x          y          z mm      roll      pitch        yaw deg");
  output.line(fmt::format("             {:>12.4f} {:>10.4f} {:>10.4f} {:>12.4f} {:>10.4f} {:>10.4f}", xyz.x(), xyz.y(),
                          xyz.z(), rpy.x() + 0.0, rpy.y() + 0.0, rpy.z() + 0.0));
  std::string sigmas;
  for (int i = 0; i < 6; ++i) {
    const double sigma = (i < 3 ? 1e3 : degrees) * last.sigma[i];
    sigmas += i >= 3 && sigma > 90 ? fmt::format(" {:>{}}", "unknown", i == 3 ? 12 : 10)
                                   : fmt::format(" {:>{}.4f}", sigma, i == 0 || i == 3 ? 12 : 10);
  }
  output.line("          +-" + sigmas);
  if (last.covariance_is_scatter)
    output.line("(sigmas from how the observations differ: the model does not agree with them to the noise)");
}

/// Images that cannot be read say nothing of their observations: those stay undecided.
void save(const Session& session, std::size_t unreadable, std::size_t with_images, const std::string& refusal) {
  if (unreadable > 0 && unreadable == with_images)
    throw InputError(
        message("None of the {} observations' images can be read, so that nothing is saved. {}", with_images, refusal));
  if (unreadable > 0)
    Output::note(
        fmt::format("The images of {} observations cannot be read; what the session says of these stays as it "
                    "is. {}",
                    unreadable, refusal));
  replace_session(session);
}

/// The steps as they come: shown, written and kept in the session. A step may come again, decided after all.
class Steps {
 public:
  Steps(Session& session, const OnlineArguments& options) : session_(session), options_(options) {}

  void take(const OnlineStep& step) {
    options_.output.line(step_line(step, session_.target || session_.pose_sensor ? "points" : "markers"));
    if (options_.output.json_file == "-") {
      std::cout << json_text(step_json(step), -1) << '\n' << std::flush;
    } else if (!options_.output.json_file.empty()) {
      json_lines_ += json_text(step_json(step), -1) + '\n';
    }
    for (Observation& o : session_.observations)
      if (o.id == step.id && o.decision != Decision::excluded && !unreadable_.count(o.id)) keep_step(step, o);
    const auto place = std::lower_bound(taken_.begin(), taken_.end(), step.id);
    const bool is_in = place != taken_.end() && *place == step.id;
    if (step.accepted && !is_in) taken_.insert(place, step.id);
    if (!step.accepted && is_in) taken_.erase(place);
    if (step.has_estimate) last_ = step;
  }
  std::size_t taken() const { return taken_.size(); }
  const OnlineStep& last() const { return last_; }
  const std::string& json_lines() const { return json_lines_; }

  /// An observation whose images cannot be read is not decided.
  void note_images(std::int64_t id, bool has_images, const std::string& refusal) {
    with_images_ += has_images || !refusal.empty() ? 1 : 0;
    if (refusal.empty()) return;
    unreadable_.insert(id);
    if (first_refusal_.empty()) first_refusal_ = refusal;
  }
  void note_target(const TargetFinding& found) {
    dropped_points_ += found.dropped_points;
    dropped_tags_ += found.dropped_tags;
  }
  std::string dropped() const {
    return dropped_points_ + dropped_tags_ == 0
               ? std::string()
               : fmt::format("{} points and {} tags did not agree with the rest of the target and were left out.",
                             dropped_points_, dropped_tags_);
  }
  void save() const { cli::save(session_, unreadable_.size(), with_images_, first_refusal_); }

 private:
  Session& session_;
  const OnlineArguments& options_;
  std::vector<std::int64_t> taken_;  // ids, ascending: a watch may last for days
  OnlineStep last_;
  std::string json_lines_, first_refusal_;
  std::set<std::int64_t> unreadable_;
  std::size_t with_images_ = 0;
  int dropped_points_ = 0, dropped_tags_ = 0;  // of a target
};

/// Of a target, its points are found in the images there are; else what the session says of it counts.
OnlineStep decided_by_target(OnlineCalibration& online, const TargetFinder& finder, const Observation& observation,
                             Steps& steps) {
  if (!has_images(observation) || observation.decision == Decision::excluded) return online.add(observation, nullptr);
  const auto began = std::chrono::steady_clock::now();
  TargetFinding found = finder.find(observation);
  const std::chrono::duration<double, std::milli> searched = std::chrono::steady_clock::now() - began;
  steps.note_target(found);
  steps.note_images(observation.id, found.images > 0,
                    found.images == 0 && !found.unreadable.empty() ? found.unreadable.front() : std::string());
  Observation seen = observation;
  seen.sightings = std::move(found.sightings);
  OnlineStep step = online.add(seen, nullptr, found.reason);
  step.milliseconds += searched.count();
  return step;
}

OnlineStep decided(OnlineCalibration& online, const Session& session, const Observation& observation, Steps& steps,
                   const std::optional<TargetFinder>& finder) {
  if (finder) return decided_by_target(online, *finder, observation, steps);
  Message refusal;
  const auto images =
      observation.decision == Decision::excluded ? std::nullopt : read_images(session, observation, refusal);
  steps.note_images(observation.id, images.has_value(), refusal);
  if (refusal.empty()) return online.add(observation, images ? &*images : nullptr);
  OnlineStep step;
  step.id = observation.id;
  step.reason = refusal;
  return step;
}

std::atomic<bool> is_interrupted = false;

/// Takes what arrives in the session's folder until it is interrupted, or the time is over; how many came.
std::size_t watch(Session& session, const OnlineArguments& options, OnlineCalibration& online, Steps& steps,
                  const std::optional<TargetFinder>& finder) {
  Arrivals arrivals(session);
  std::size_t arrived = 0;
  std::int64_t next_id = 0;
  for (const Observation& o : session.observations) next_id = std::max(next_id, o.id + 1);
  std::signal(SIGINT, [](int) { is_interrupted = true; });
  std::signal(SIGTERM, [](int) { is_interrupted = true; });
  const auto start = std::chrono::steady_clock::now();
  const auto is_over = [&] {
    return is_interrupted || (options.watch_for > 0 && std::chrono::steady_clock::now() - start >
                                                           std::chrono::duration<double>(options.watch_for));
  };
  while (!is_over()) {
    Arrivals::Look look = arrivals.look();
    for (const Message& remark : look.remarks) Output::note(remark);
    for (Observation& o : look.arrived) {
      o.id = next_id++;
      ++arrived;
      if (options.save) session.observations.push_back(o);  // else nothing is kept: a watch may last for days
      const OnlineStep step = decided(online, session, o, steps, finder);
      for (const OnlineStep& revised : online.take_revised()) steps.take(revised);
      steps.take(step);
    }
    if (!look.arrived.empty()) std::cout.flush();
    if (options.save && !look.arrived.empty()) {
      std::stable_sort(session.observations.begin(), session.observations.end(),
                       [](const Observation& a, const Observation& b) { return a.time < b.time; });
      steps.save();
      session.source = std::make_shared<const std::string>(session_text(session));
    }
    if (look.arrived.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return arrived;
}

int run(const OnlineArguments& options) {
  Session session = open_session(options.session, options.output);
  const bool is_labelled = std::any_of(session.observations.begin(), session.observations.end(),
                                       [](const Observation& o) { return !o.sightings.empty(); });
  // A single camera shows no points to begin with; more than two show them where somebody has labelled them.
  if (session.rig && !session.target && (session.rig->count() == 1 || !is_labelled)) require_pair(session, "online");
  OnlineOptions online_options;
  online_options.match.body_gate = 1e-3 * options.body_gate_mm;
  OnlineCalibration online(session, online_options);
  std::optional<TargetFinder> finder;
  if (session.target) finder.emplace(session);
  Progress progress("calibrating", session.observations.size());
  Steps steps(session, options);
  for (std::size_t k = 0; k < session.observations.size(); ++k) {
    const OnlineStep step = decided(online, session, session.observations[k], steps, finder);
    for (const OnlineStep& revised : online.take_revised()) steps.take(revised);
    steps.take(step);
    progress.at(k + 1);
  }
  std::size_t seen = session.observations.size();
  if (options.watch) seen += watch(session, options, online, steps, finder);
  if (!steps.json_lines().empty()) write_output(options.output.json_file, steps.json_lines(), "--json");
  if (options.save && !options.watch) steps.save();
  options.output.line();
  options.output.line(
      fmt::format("{} of {} observations taken{}", steps.taken(), seen, options.save ? "; saved in the session" : ""));
  if (const auto open = online.mount_progress())
    options.output.line(
        fmt::format("The cameras' mount is still unknown: {} labelled and {} open observations do not agree on one.{}",
                    open->labelled, open->open,
                    open->label_next ? fmt::format(" Label observation {} next.", *open->label_next) : std::string()));
  if (const std::string dropped = steps.dropped(); !dropped.empty()) options.output.line(dropped);
  if (!steps.last().has_estimate) return answer_is_no;
  print_estimate(options.output, steps.last());
  return done;
}

}  // namespace

Command add_online(const CommandLine& program) {
  auto options = std::make_shared<OnlineArguments>();
  const CommandLine command =
      program.command("online", "Online calibration: observation by observation, each taken or rejected");
  add_session_option(command, options->session);
  command.flag("--watch", options->watch,
               "Go on with what arrives in the session's folder: joints.csv, and images/, points.csv or poses.csv");
  command.option("--for", options->watch_for, "s: how long to watch; 0 until interrupted").within(0, 1e9);
  command.flag("--save", options->save, "Save decisions and found markers in the session");
  command
      .option("--body-gate", options->body_gate_mm, "mm: how far the markers as a whole may be from their prediction")
      .within(0.001, 10000);
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
