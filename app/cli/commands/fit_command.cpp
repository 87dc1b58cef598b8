// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command.h"
#include "diagnosis/outliers/flipped_targets.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/fit/undetermined.h"
#include "estimation/report/export.h"
#include "estimation/report/fit_report.h"
#include "estimation/report/part_report.h"
#include "options/camera_images_option.h"
#include "options/named_effects.h"
#include "printing/blunder_output.h"
#include "printing/diagnosis_output.h"
#include "printing/fit_output.h"

namespace handsight::cli {
namespace {

struct FitArguments {
  std::string objective = "image", loss = "none";
  std::vector<std::string> sessions, effects;
  SharedBySessions shared;
  bool fix_markers = false, without_wrong_points = false;
  CameraImagesOptions camera_images;
  Output output;
};

/// What to type next, where the fit has an answer and nothing above says otherwise.
void print_next(const FitArguments& o, const Session& session, const Fit& result) {
  if (o.sessions.size() > 1 || !o.output.export_file.empty() || has_no_answer(result)) return;
  const std::string& path = o.sessions.front();
  const bool is_at_noise = result.noise && result.chi2_per_dof && *result.chi2_per_dof < 1.5;
  if (!is_at_noise)
    o.output.line(
        fmt::format("Next: handsight-cli diagnose {0} (what the model lacks), then improve {0} adds it.", path));
  else if (session.robot.is_of_poses)
    o.output.line(
        fmt::format("Next: handsight-cli export {} --as static_tf --out camera.py (or yaml, opencv, csv).", path));
  else
    o.output.line(
        fmt::format("Next: handsight-cli fit {} --export calibration.xml, for predict, correct and export.", path));
}

/// Those that are not said already: observations whose target's tilt flipped go with no others.
std::vector<Blunder> without_said(std::vector<Blunder> blunders, const std::vector<FlippedTarget>& flipped) {
  std::vector<std::int64_t> ids;
  for (const FlippedTarget& one : flipped) ids.push_back(one.id);
  std::sort(ids.begin(), ids.end());
  const std::string said = fmt::format("{}", fmt::join(ids, ","));
  std::erase_if(blunders, [&](const Blunder& b) { return b.id == "stray_poses" && b.where == said; });
  return blunders;
}

int run(const FitArguments& o) {
  const Session session = open_joined_session(o.sessions, o.shared, o.output);
  FitOptions options;
  options.objective = o.objective == "camera"       ? Objective::camera
                      : o.objective == "angle-axis" ? Objective::angle_axis
                                                    : Objective::image;
  options.loss = o.loss == "huber" ? Loss::huber : o.loss == "cauchy" ? Loss::cauchy : Loss::none;
  if (o.without_wrong_points && !session.robot.is_of_poses) options.smallest_step = 1e-9;  // as a diagnosis fits
  options.fix_markers = o.fix_markers;
  add_effects(o.effects, session, options.effects, options.estimated);
  std::vector<Message> notes;
  options.camera_images = find_camera_images(o.camera_images, session, notes);
  CleanFit clean{session, fit(session, options), {}};
  const auto flipped = flipped_targets(session, clean.fit);
  if (o.without_wrong_points) clean = fit_without_outliers(without_flipped(session, flipped), options);
  const Fit& result = clean.fit;
  for (const Message& note : notes) Output::note(note);
  FitReport reported = report(clean.session, result, options);
  reported.held_out_region = held_out_by_region(clean.session, result, options);
  hold_out_sessions(clean.session, result, options, reported);
  print_fit(o.output, session, result, reported, options);
  if (options.camera_images) print_camera_images(o.output, *options.camera_images, *result.problem.rig);
  if (!clean.wrong.empty())
    o.output.line(fmt::format("Left out: {} wrong points (wrong_points of --json)", clean.wrong.size()));
  if (!flipped.empty())
    o.output.line(flipped_text(flipped) +
                  (o.without_wrong_points ? " That is done here." : " --without-wrong-points fits without."));
  const bool is_plain = options.objective == Objective::image && options.loss == Loss::none && !options.fix_markers;
  const auto lone = o.without_wrong_points || !is_plain ? clean.lone : lone_observations(session, result, options);
  if (!o.without_wrong_points && !lone.empty())
    o.output.line(lone_text(lone, session.is_tracker(), false) + " --without-wrong-points fits without.");
  const auto size = is_plain ? other_target_size(clean.session, result, options) : std::nullopt;
  print_target_size(o.output, size);
  const auto distance = is_plain ? doubtful_distance(clean.session, result, options) : std::nullopt;
  if (distance) o.output.line(distance->text);
  const std::vector<Blunder> blunders =
      settles_it(size) || distance ? std::vector<Blunder>() : list_blunders(clean.session, result);
  print_blunders(o.output, o.sessions.front(), without_said(blunders, flipped));
  if (blunders.empty() && !size && !distance && flipped.empty()) print_next(o, session, result);
  Json json = fit_json(session, result, reported, options);
  json["target_size"] = target_size_json(size);
  json["doubtful_distance"] = doubtful_distance_json(distance, clean.session);
  json["blunders"] = blunders_json(blunders);
  json["lone_observations"] = lone_json(lone);
  json["flipped_targets"] = flipped_json(flipped);
  if (o.without_wrong_points) json["wrong_points"] = wrong_points_json(clean.wrong, clean.session);
  if (options.camera_images) json["camera_images"] = camera_images_json(*options.camera_images, *result.problem.rig);
  o.output.json(json);
  if (!o.output.export_file.empty())
    o.output.calibration(make_calibration(session, result, reported, options, "handsight " HANDSIGHT_VERSION));
  return result.converged() && !never_moved(result) ? done : answer_is_no;
}

}  // namespace

Command add_fit(const CommandLine& program) {
  auto options = std::make_shared<FitArguments>();
  const CommandLine command = program.command("fit", "Estimates tcp_from_body from the labelled markers");
  command
      .option("SESSION", options->sessions,
              "A session's folder or its session.xml, or a collection (collection.xml); of several sessions the "
              "collection in which they share the robot alone")
      .required();
  command.option("--same-rig", options->shared.same_rig,
                 "Sessions (A,B) with the same cameras or tracker in one place");
  command.option("--same-body", options->shared.same_body, "Sessions (A,C) with the same body on the same TCP");
  command.option("--objective", options->objective, "image (px), camera (3D points) or angle-axis (body poses)")
      .one_of({"image", "camera", "angle-axis"});
  command.option("--loss", options->loss, "Robust loss: none, huber or cauchy").one_of({"none", "huber", "cauchy"});
  command.flag("--fix-markers", options->fix_markers, "Hold the body's shape at the average of the observations");
  command.flag("--without-wrong-points", options->without_wrong_points,
               "Leave out single points that are wrong whatever the robot does, as diagnose and the window do");
  command.option("--effects", options->effects,
                 "Effects in the model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
  add_camera_images_options(command, options->camera_images);
  add_export_option(command, options->output);
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
