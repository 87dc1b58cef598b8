// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/percent.h"
#include "command.h"
#include "diagnosis/attribution/fresh_poses.h"
#include "diagnosis/attribution/inspection.h"
#include "diagnosis/outliers/flipped_targets.h"
#include "diagnosis/ranking/outlier_rejection.h"
#include "options/named_effects.h"
#include "printing/diagnosis_output.h"
#include "printing/json_values.h"
#include "printing/reported_json.h"
#include "vision/image/image_file.h"

namespace handsight::cli {
namespace {

struct InspectArguments {
  std::string session;
  std::vector<std::string> effects;
  int count = 10;
  bool second_look = false;
  Output output;
};

/// What the session says, held against its model.
struct Inspected {
  const Session& session;
  CleanFit clean;
  FitReport reported;
  Inspection all;
  std::vector<FreshPose> fresh;
  std::vector<FlippedTarget> flipped;

  bool is_flipped(std::int64_t id) const {
    return std::any_of(flipped.begin(), flipped.end(), [&](const FlippedTarget& f) { return f.id == id; });
  }
  const Rig* rig() const { return session.rig ? &*session.rig : nullptr; }
};

SecondLooks look_again(const Session& session, const Fit& fit) {
  std::vector<const Observation*> rejected;
  for (const Observation& o : session.observations)
    if (wants_second_look(session, o)) rejected.push_back(&o);
  SecondLooks looks;
  Progress progress("second look", rejected.size());
  for (std::size_t i = 0; i < rejected.size(); ++i) {
    const Observation& o = *rejected[i];
    const auto image = [&](int camera) {
      const std::string& name = o.images[static_cast<std::size_t>(camera)];
      return read_image(folder(session) / name, session.rig->at(camera).camera, name);
    };
    if (auto found = second_look(session, fit, o, {image(0), image(1)})) looks[o.id] = std::move(*found);
    progress.at(i + 1);
  }
  return looks;
}

Inspected inspected(const Session& session, const InspectArguments& o) {
  FitOptions options;
  // As a diagnosis fits: whose fault it is must not be weighed by the robot's own error before it is asked.
  if (!session.robot.is_of_poses) options.smallest_step = 1e-9;
  add_effects(o.effects, session, options.effects, options.estimated);
  std::vector<FlippedTarget> flipped;
  if (session.pose_sensor) flipped = flipped_targets(session, fit(session, options));
  Inspected result{.session = session, .clean = fit_without_outliers(without_flipped(session, flipped), options)};
  result.flipped = flipped;
  result.reported = report(result.clean.session, result.clean.fit, options);
  const SecondLooks looks = o.second_look ? look_again(session, result.clean.fit) : SecondLooks{};
  result.all = inspect(session, result.clean.fit, result.reported, looks);
  for (InspectionRow& row : result.all.rows)
    if (result.is_flipped(row.id))
      row.what_would_mend = "its flat target flipped to the mirror tilt: leave the observation out";
  mark_left_out(result.clean.wrong, result.clean.lone, result.all);
  result.fresh = fresh_poses(result.all);
  return result;
}

std::string read_state(const Observation& o) {
  switch (o.decision) {
    case Decision::rejected:
      return "rejected";
    case Decision::excluded:
      return "excluded";
    default:
      return o.sightings.empty() ? "unseen" : "used";
  }
}

std::string at_fault(const ErrorAttribution& attribution, bool tracker) {
  return tracker && attribution.cause == ErrorCause::cameras ? "tracker"
                                                             : std::string(error_cause_name(attribution.cause));
}

std::string size_text(double size, bool tracker) {
  return tracker ? fmt::format("{:.3f} mm", 1e3 * size) : fmt::format("{:.2f} px", size);
}

std::string or_dash(const std::optional<double>& value, double scale, const char* unit) {
  return value ? fmt::format("{:.2f} {}", scale * *value, unit) : "-";
}

std::string worst_text(const InspectionRow& row, const Rig* rig) {
  if (row.worst_marker < 0) return "-";
  const std::string by = row.worst_camera >= 0 ? ", " + rig->at(row.worst_camera).name : "";
  return fmt::format("marker {}{}", row.worst_marker, by);
}

/// By their error over the noise, the worst first; those of which nothing is known last.
std::vector<const InspectionRow*> worst_first(const Inspection& all) {
  std::vector<const InspectionRow*> rows;
  for (const InspectionRow& row : all.rows)
    if (row.rms) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return *a->rms > *b->rms; });
  return rows;
}

int hits(const std::vector<FreshPose>& poses) {
  return static_cast<int>(std::count_if(poses.begin(), poses.end(), [](const FreshPose& p) { return p.is_hit; }));
}

std::vector<FreshPose> that_test(const std::vector<FreshPose>& poses) {
  std::vector<FreshPose> good;
  for (const FreshPose& p : poses)
    if (!p.is_known_bad) good.push_back(p);
  return good;
}

void print(const Inspected& in, int count, const Output& out) {
  const bool tracker = in.session.is_tracker();
  out.line(fmt::format("{}: {} observations, {} used", in.session.title.empty() ? "Session" : in.session.title,
                       in.reported.observations, in.reported.used));
  if (!in.all.noise) out.line("The noise is not known: whose fault an error is cannot be said.");
  if (in.all.attribution.cause != ErrorCause::none)
    out.line(fmt::format("Due to    robot {} %, marker body {} %, {} {} % of what exceeds the noise",
                         whole_percent(in.all.attribution.robot), whole_percent(in.all.attribution.body),
                         tracker ? "tracker" : "cameras", whole_percent(in.all.attribution.cameras)));
  out.line();
  out.line(fmt::format("{:>8} {:<9} {:>11} {:>10} {:>9}  {:<18} {}", "id", "state", "error", "hand off", "turned",
                       "worst", "whose fault, and what would make it right"));
  const auto rows = worst_first(in.all);
  for (std::size_t i = 0; i < std::min(rows.size(), static_cast<std::size_t>(count)); ++i) {
    const InspectionRow& r = *rows[i];
    const Observation& o = in.session.observations[static_cast<std::size_t>(r.index)];
    const std::string cause = in.is_flipped(r.id) ? "target" : at_fault(r.attribution, tracker);
    std::optional<double> off;
    if (r.tcp_from_tcp_est) off = r.tcp_from_tcp_est->translation.norm();
    out.line(fmt::format("{:>8} {:<9} {:>11} {:>10} {:>9}  {:<18} {}{}", r.id, read_state(o),
                         size_text(*r.rms, tracker), or_dash(off, 1e3, "mm"),
                         or_dash(r.angle, 57.29577951308232, "deg"), worst_text(r, in.rig()),
                         cause.empty() ? "noise" : cause, r.what_would_mend.empty() ? "" : ": " + r.what_would_mend));
  }
  if (rows.size() > static_cast<std::size_t>(count))
    out.line(fmt::format("{:>8} better ones are not shown (--count, or per_observation of --json)",
                         rows.size() - static_cast<std::size_t>(count)));
  if (!in.flipped.empty()) out.line(flipped_text(in.flipped));
  if (const auto tests = that_test(in.fresh); !tests.empty()) {
    out.line();
    out.line(fmt::format(
        "Fresh poses: {} of {} that the fit has not seen lie within the ellipsoid of 95 % about their prediction.",
        hits(tests), tests.size()));
  }
}

Json row_json(const Inspected& in, const InspectionRow& r) {
  const bool tracker = in.session.is_tracker();
  const Json null = nullptr;
  const Observation& o = in.session.observations[static_cast<std::size_t>(r.index)];
  const std::string cause = in.is_flipped(r.id) ? "target" : at_fault(r.attribution, tracker);
  Json worst = nullptr;
  if (r.worst_marker >= 0)
    worst = {{"marker", r.worst_marker},
             {"seen_by", r.worst_camera < 0 ? "tracker" : in.rig()->at(r.worst_camera).name},
             {"off_by", r.worst_size}};
  return {{"id", r.id},
          {"state", read_state(o)},
          {"reason", o.reason},
          {"used", r.is_used},
          {"second_look", r.at_second_look},
          {"rms_pixel", tracker ? null : number(r.rms)},
          {"rms_m", number(r.rms_m)},
          {"over_noise", number(r.ratio)},
          {"angle_rad", number(r.angle)},
          {"tcp_from_tcp_est", r.tcp_from_tcp_est ? motion(*r.tcp_from_tcp_est) : null},
          {"worst", worst},
          {"cause", cause.empty() ? null : Json(cause)},
          {"error_attribution", attribution_json(r.attribution)},
          {"blame", attribution_json(r.attribution)},  // its older name
          {"what_would_mend", r.what_would_mend.empty() ? null : Json(r.what_would_mend)},
          {"smallest_visible_pixel", tracker ? null : number(r.smallest_visible)},
          {"smallest_visible_m", tracker ? number(r.smallest_visible) : null},
          {"outlier", r.outlier}};
}

Json inspection_json(const Inspected& in) {
  const bool tracker = in.session.is_tracker();
  const Json null = nullptr;
  Json rows = Json::array(), fresh = Json::array();
  for (const InspectionRow& r : in.all.rows) rows.push_back(row_json(in, r));
  for (const FreshPose& p : in.fresh)
    fresh.push_back({{"id", p.id},
                     {"distance_m", number(p.distance)},
                     {"allowed_m", number(p.allowed)},
                     {"hit", p.is_hit},
                     {"known_bad", p.is_known_bad}});
  return {{"observations", in.reported.observations},
          {"used", in.reported.used},
          {"noise_pixel", tracker ? null : number(in.all.noise)},
          {"noise_m", tracker ? number(in.all.noise) : null},
          {"error_attribution", attribution_json(in.all.attribution)},
          {"blame", attribution_json(in.all.attribution)},  // its older name
          {"wrong_points", wrong_points_json(in.clean.wrong, in.clean.session)},
          {"lone_observations", lone_json(in.clean.lone)},
          {"flipped_targets", flipped_json(in.flipped)},
          {"per_observation", rows},
          {"fresh_poses", fresh}};
}

int run(const InspectArguments& o) {
  const Session session = open_searched_session(o.session, o.output);
  if (o.second_look && (!session.rig || !is_pair(*session.rig)))
    throw InputError("--second-look looks at the images of two cameras; this session has none of that kind.");
  const Inspected result = inspected(session, o);
  print(result, o.count, o.output);
  o.output.json(inspection_json(result));
  return result.clean.fit.converged() ? done : answer_is_no;
}

}  // namespace

Command add_inspect(const CommandLine& program) {
  auto options = std::make_shared<InspectArguments>();
  const CommandLine command = program.command(
      "inspect", "Every observation against the model: how far off, whose fault, what would make it right");
  add_session_option(command, options->session);
  command.option("--effects", options->effects,
                 "Effects in the model: id or id:joint+joint to estimate, id:joint.parameter=value to hold");
  command.option("--count", options->count, "So many are shown, the worst first").from_to(1, 1000000).shows_default();
  command.flag("--second-look", options->second_look,
               "Look for the markers of rejected observations again, with wider gates, to say whose fault it was");
  add_json_option(command, options->output);
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
