// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/degrees.h"
#include "base/numbers.h"
#include "command.h"
#include "diagnosis/planning/planning.h"
#include "options/named_effects.h"
#include "options/rival_effects.h"
#include "printing/json_values.h"
#include "printing/outputs.h"

namespace handsight::cli {
namespace {

struct PlanArguments {
  std::string session, between, csv_file;
  std::vector<std::string> effects;
  int count = 10;
  Output output;
};

void print(const PlanArguments& o, const Session& session, const Plan& p) {
  const bool between = p.ln_bayes_factor_before.has_value();
  const auto sigma = [&](const Vector6& s) {
    const std::string rotation =
        p.rotation_is_observed ? fmt::format("{:.4f}", degrees * s.tail<3>().norm()) : std::string("-");
    return fmt::format("{:>9.4f} {:>9}", 1e3 * s.head<3>().norm(), rotation);
  };
  if (between)
    o.output.line(
        fmt::format("ln Bayes factor of the first against the second so far: {:.2f}", *p.ln_bayes_factor_before));
  o.output.line(fmt::format("pose {:>9}  sigma of TCP->Body  {}joints: {}", "gain",
                            between ? "ln BF if first / second true  " : "", fmt::join(session.joints, " ")));
  o.output.line(fmt::format("{:>14}  {:>9} {:>9}", "nats", "mm", "deg"));
  o.output.line(fmt::format("now  {:>9}  {}", "", sigma(p.sigma_before)));
  for (std::size_t i = 0; i < p.poses.size(); ++i) {
    const PlannedPose& pose = p.poses[i];
    std::string line = fmt::format("{:>4} {:>9.3f}  {}", i + 1, pose.gain, sigma(pose.sigma));
    if (pose.ln_bayes_factor)
      line += fmt::format("  {:>12.2f} {:>12.2f}   ", (*pose.ln_bayes_factor)[0], (*pose.ln_bayes_factor)[1]);
    line += " ";
    for (const double q : pose.position) line += fmt::format(" {:>7.4f}", q);
    o.output.line(line);
  }
  for (const std::string& note : p.notes) o.output.line(note);
  o.output.line(
      "Check every pose for collisions before driving there: only joint limits and the cameras' view are known.");
}

/// Translation, and the rotation where markers show all of it.
Json sigma_json(const Vector6& sigma, bool rotation_is_observed) {
  Json list = numbers(sigma);
  for (std::size_t i = 3; i < 6 && !rotation_is_observed; ++i) list[i] = nullptr;
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
    if (pose.ln_bayes_factor) one["expected_ln_bayes_factor"] = numbers(*pose.ln_bayes_factor);
    poses.push_back(one);
  }
  result["poses"] = poses;
  result["notes"] = p.notes;
  return result;
}

/// As read_poses reads it: a header of joint names, one pose a line.
void write_csv(const std::string& file, const Session& session, const Plan& p) {
  std::string text = fmt::format("{}\n", fmt::join(session.joints, ","));
  for (const PlannedPose& pose : p.poses) {
    for (Eigen::Index j = 0; j < pose.position.size(); ++j)
      text += (j > 0 ? "," : "") + format_number(pose.position[j]);
    text += '\n';
  }
  write_output(file, text, "--csv");
}

int run(const PlanArguments& o) {
  const Session session = open_searched_session(o.session, o.output);
  require_output(o.csv_file, "--csv");
  PlanOptions options;
  options.count = o.count;
  add_effects(o.effects, session, options.effects, options.estimated);
  if (!o.between.empty()) options.between = rivals(o.between, session);
  const Plan p = plan(session, options);
  print(o, session, p);
  o.output.json(plan_json(session, p));
  if (!o.csv_file.empty()) {
    write_csv(o.csv_file, session, p);
    o.output.line("Written: " + o.csv_file);
  }
  return done;
}

}  // namespace

Command add_plan(const CommandLine& program) {
  auto options = std::make_shared<PlanArguments>();
  const CommandLine command = program.command("plan", "Next poses: for precision, or to tell two effects apart");
  add_session_option(command, options->session);
  command.option("--count", options->count, "How many poses, 1 to 100").shows_default();
  command.option("--effects", options->effects,
                 "Effects in the model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
  command.option("--between", options->between, "Two effects to tell apart: a,b, each id or id:joint+joint");
  command.option("--csv", options->csv_file, "Write the poses as a table: a header of joint names, one pose a line");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
