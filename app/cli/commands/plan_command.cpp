// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "base/degrees.h"
#include "base/numbers.h"
#include "command.h"
#include "diagnosis/planning/planning.h"
#include "estimation/fit/fit.h"
#include "estimation/fit/part_fit.h"
#include "options/competing_effects.h"
#include "options/named_effects.h"
#include "printing/json_values.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct PlanArguments {
  std::string session, part, between, csv_file;
  std::vector<std::string> effects;
  int count = 10;
  Output output;
};

void print(const PlanArguments& o, const Session& session, const Plan& p) {
  const bool between = p.ln_bayes_factor_before.has_value();
  const auto sigma = [&](const Vector6& s) {
    const auto text = [](bool is_known, double value) {
      return is_known && std::isfinite(value) ? fmt::format("{:.4f}", value) : std::string("-");
    };
    return fmt::format("{:>9} {:>9}", text(true, 1e3 * s.head<3>().norm()),
                       text(p.rotation_is_observed, degrees * s.tail<3>().norm()));
  };
  if (between)
    o.output.line(
        fmt::format("ln Bayes factor of the first against the second so far: {:.2f}", *p.ln_bayes_factor_before));
  o.output.line(fmt::format("pose {:>9}  sigma of TCP->Body  {}{}joints: {}", "gain",
                            between ? "ln BF if first / second true  " : "",
                            session.is_touch() ? fmt::format("{:<14}", "touch") : "", fmt::join(session.joints, " ")));
  o.output.line(fmt::format("{:>14}  {:>9} {:>9}", "nats", "mm", "deg"));
  o.output.line(fmt::format("now  {:>9}  {}", "", sigma(p.sigma_before)));
  for (std::size_t i = 0; i < p.poses.size(); ++i) {
    const PlannedPose& pose = p.poses[i];
    std::string line = fmt::format("{:>4} {:>9.3f}  {}", i + 1, pose.gain, sigma(pose.sigma));
    if (pose.ln_bayes_factor)
      line += fmt::format("  {:>12.2f} {:>12.2f}   ", (*pose.ln_bayes_factor)[0], (*pose.ln_bayes_factor)[1]);
    line += "  ";
    if (pose.fixture >= 0) line += fmt::format("{:<13}", session.fixtures[static_cast<std::size_t>(pose.fixture)].id);
    for (const double q : pose.position) line += fmt::format("{:>7.4f} ", q);
    o.output.line(line);
  }
  for (const Message& note : p.notes) o.output.line(note);
  o.output.line(
      session.is_touch()
          ? "Come to each touch from where it was touched before, slowly: only joint limits are known, and how "
            "far from there the fixture goes on is not."
          : "Check every pose for collisions before driving there: only joint limits and the cameras' view "
            "are known.");
}

/// Translation, and the rotation where markers show all of it.
Json sigma_json(const Vector6& sigma, bool rotation_is_observed) {
  Json list = numbers(sigma);
  for (std::size_t i = 0; i < 6; ++i)
    if (!std::isfinite(sigma[static_cast<Eigen::Index>(i)]) || (i > 2 && !rotation_is_observed)) list[i] = nullptr;
  return list;
}

Json plan_json(const Session& session, const Plan& p) {
  Json result;
  result["count"] = p.poses.size();
  result["pool"] = p.pool;
  result[session.is_tracker() ? "noise_m" : "noise_pixel"] = number(p.noise);
  result["sigma_before"] = sigma_json(p.sigma_before, p.rotation_is_observed);
  result["ln_bayes_factor_before"] = number(p.ln_bayes_factor_before);
  result["tells_apart"] = p.ln_bayes_factor_before ? Json(p.tells_apart) : Json(nullptr);
  Json poses = Json::array();
  for (const PlannedPose& pose : p.poses) {
    Json one{{"position", numbers(pose.position)},
             {"joints", session.joints},
             {"expected_gain", number(pose.gain)},
             {"sigma", sigma_json(pose.sigma, p.rotation_is_observed)}};
    if (pose.fixture >= 0) one["fixture"] = session.fixtures[static_cast<std::size_t>(pose.fixture)].id;
    if (pose.ln_bayes_factor) one["expected_ln_bayes_factor"] = numbers(*pose.ln_bayes_factor);
    poses.push_back(one);
  }
  result["poses"] = poses;
  result["notes"] = p.notes;
  return result;
}

/// As read_poses reads it: a header of joint names, one pose a line; of touches what is touched, as `convert` reads it
/// once the readings are written beside.
void write_csv(const std::string& file, const Session& session, const Plan& p) {
  std::string text = fmt::format("{}{}\n", session.is_touch() ? "fixture," : "", fmt::join(session.joints, ","));
  for (const PlannedPose& pose : p.poses) {
    if (pose.fixture >= 0) text += session.fixtures[static_cast<std::size_t>(pose.fixture)].id + ",";
    for (Eigen::Index j = 0; j < pose.position.size(); ++j)
      text += (j > 0 ? "," : "") + format_number(pose.position[j]);
    text += '\n';
  }
  write_output(file, text, "--csv");
}

/// What the poses of one session of a collection would tell, with the robot that all sessions tell: in nats, or as the
/// ln Bayes factor for the true one of two effects.
struct PartPlan {
  Session session;
  Plan plan;
  double worth() const {
    if (plan.poses.empty()) return 0;
    const auto& of_two = plan.poses.back().ln_bayes_factor;
    if (of_two) return 0.5 * of_two->sum();
    double nats = 0;
    for (const PlannedPose& pose : plan.poses) nats += pose.gain;
    return nats;
  }
};

PartPlan plan_of_part(const PlanArguments& o, const Session& joined, const Fit& together, int part) {
  PartFit own = fit_of_part(joined, together, part);
  PlanOptions options;
  options.count = o.count;
  for (const FittedEffect& e : own.fit.effects) {
    const bool is_free = std::any_of(e.sigmas.begin(), e.sigmas.end(), [](double s) { return s > 0; });
    (is_free ? options.estimated : options.effects).push_back(e.term);
  }
  if (!o.between.empty()) options.between = competing(o.between, own.session);
  PartPlan result{std::move(own.session), {}};
  result.plan = plan(result.session, options);
  return result;
}

/// Of a collection each session's, and which is worth most.
int run_of_collection(const PlanArguments& o, const Session& joined) {
  FitOptions fit_options;
  add_effects(o.effects, joined, fit_options.effects, fit_options.estimated);
  const Fit together = fit(joined, fit_options);
  std::optional<PartPlan> best;
  Json sessions = Json::array();
  for (std::size_t p = 0; p < joined.parts.size(); ++p) {
    if (!o.part.empty() && joined.parts[p].title != o.part) continue;
    if (joined.parts[p].fixture >= 0) {
      o.output.line(
          fmt::format("{:<20} is touched; plan its session by itself, with the effects found here (--effects)",
                      joined.parts[p].title));
      continue;
    }
    PartPlan one = plan_of_part(o, joined, together, static_cast<int>(p));
    o.output.line(fmt::format("{:<20} {} poses more there are worth {:.2f} {}", joined.parts[p].title,
                              one.plan.poses.size(), one.worth(),
                              o.between.empty() ? "nats" : "of ln Bayes factor for the true one"));
    Json json = plan_json(one.session, one.plan);
    json["session"] = joined.parts[p].title;
    json["worth"] = number(one.worth());
    sessions.push_back(std::move(json));
    if (!best || one.worth() > best->worth()) best = std::move(one);
  }
  if (!best)
    throw InputError("Here is nothing but touches; plan the session of touches by itself, with --effects that hold.");
  o.output.line("Best measured next: " + best->session.title);
  print(o, best->session, best->plan);
  Json json = plan_json(best->session, best->plan);
  json["session"] = best->session.title;
  json["sessions"] = sessions;
  o.output.json(json);
  if (!o.csv_file.empty()) {
    write_csv(o.csv_file, best->session, best->plan);
    o.output.line("Written: " + o.csv_file);
  }
  return done;
}

int run(const PlanArguments& o) {
  const Session session = open_searched_session(o.session, o.output);
  require_output(o.csv_file, "--csv");
  if (!o.part.empty()) part_named(session, o.part);
  if (!session.parts.empty() && !session.is_touch()) return run_of_collection(o, session);
  PlanOptions options;
  options.count = o.count;
  add_effects(o.effects, session, options.effects, options.estimated);
  if (!o.between.empty()) options.between = competing(o.between, session);
  const Plan p = plan(session, options);
  print(o, session, p);
  o.output.json(plan_json(session, p));
  if (!o.csv_file.empty()) {
    write_csv(o.csv_file, session, p);
    o.output.line("Written: " + o.csv_file);
  }
  return p.never_moved ? answer_is_no : done;
}

}  // namespace

Command add_plan(const CommandLine& program) {
  auto options = std::make_shared<PlanArguments>();
  const CommandLine command = program.command("plan", "Next poses: for precision, or to tell two effects apart");
  add_session_option(command, options->session);
  command.option("--session", options->part, "Of a collection: the session that is planned for; absent: the best one");
  command.option("--count", options->count, "How many poses, 1 to 100").shows_default();
  command.option("--effects", options->effects,
                 "Effects in the model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
  command.option("--between", options->between, "Two effects to tell apart: a,b, each id or id:joint+joint");
  command.option("--csv", options->csv_file, "Write the poses as a table: a header of joint names, one pose a line");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
