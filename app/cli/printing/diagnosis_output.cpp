// SPDX-License-Identifier: Apache-2.0
#include "diagnosis_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/percent.h"
#include "diagnosis/evidence/repeatability_levels.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/residuals/trend.h"
#include "diagnosis/story/story.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/robot_check.h"
#include "effects/own_effect.h"
#include "effects/units.h"
#include "estimation/fit/touch_unknown.h"
#include "fit_output.h"
#include "json_values.h"
#include "reported_json.h"

namespace handsight::cli {
namespace {

Json parameters_json(const Session& session, const DiagnosisCandidate& c) {
  Json list = Json::array();
  for (std::size_t t = 0; t < c.terms.size(); ++t) {
    const Effect& effect = term_effect(c.terms[t]);
    const std::string of = place_name(effect, c.terms[t].place, session.robot);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      list.push_back({{"of", of.empty() ? Json(nullptr) : Json(of)},
                      {"name", effect.parameters[p].name},
                      {"value", number(c.terms[t].values[p])},
                      {"sigma", number(c.sigmas[t][p])},
                      {"unit", unit_at(effect, p, c.terms[t].place, session.robot)},
                      {"prior_sigma", effect.parameters[p].sigma},
                      {"plausible_size", effect.parameters[p].sigma}});  // its older name
  }
  return list;
}

std::string unnamed_id(const Variable& v) {
  switch (v.kind) {
    case VariableKind::angle:
      return "unnamed_function_of_angle";
    case VariableKind::torque:
      return "unnamed_function_of_torque";
    case VariableKind::time:
      return "unnamed_function_of_time";
    default:
      return "unnamed_function_of_place";
  }
}

Json check_json(const DiagnosisCandidate& c) {
  if (!c.check) return nullptr;
  return {{"text", term_effect(c.terms.front()).check},
          {"prediction", prediction_text(*c.check)},
          {"value", number(c.check->value)},
          {"sigma", number(c.check->sigma)},
          {"unit", c.check->unit},
          {"observation", c.check->observation ? Json(*c.check->observation) : Json(nullptr)}};
}

/// What is known of an unnamed function; as a curve that a model may take in where it could be written as one.
void add_curve_keys(const Session& session, const DiagnosisCandidate& c, Json& j) {
  const EmpiricalErrorTerm& best = c.unnamed->empirical_error.best;
  j["variable"] = c.unnamed->empirical_error.variable->name;
  j["site"] = best.site == EmpiricalErrorSite::joint ? session.robot.joints[static_cast<std::size_t>(best.joint)].name
              : best.site == EmpiricalErrorSite::tcp ? "hand"
                                                     : "mount";
  j["formula"] = j["definition"] = nullptr;
  if (c.terms.empty()) return;
  const EffectDefinition& definition = *c.terms.front().own->definition;
  j["site"] = sites_text(definition);
  j["formula"] = formula_text(definition);
  j["definition"] = effect_definition_text(definition);
}

Json candidate_json(const Session& session, const DiagnosisCandidate& c) {
  const bool tracker = session.is_tracker();
  const Json null = nullptr;
  Json j{{"id", c.unnamed ? unnamed_id(*c.unnamed->empirical_error.variable) : c.id},
         {"named", !c.unnamed},
         {"where", c.where},
         {"ln_bayes_factor", number(c.ln_bayes_factor)},
         {"p_value", c.unnamed ? null : number(c.p_value)},
         {"predicted_held_out_rms_pixel", tracker ? null : number(c.predicted_held_out)},
         {"predicted_held_out_rms_m", tracker ? number(c.predicted_held_out) : null},
         {"held_out_rms_pixel", c.held_out ? number(c.held_out->rms_pixel) : null},
         {"held_out_rms_m", c.held_out ? number(c.held_out->rms_m) : null},
         {"explained", number(c.explained)},
         {"parameters", parameters_json(session, c)},
         {"plausible", c.plausible},
         {"noncentrality_of_prior_sigma", number(c.visibility)},
         {"noncentrality_of_plausible_size", number(c.visibility)},  // its older name
         {"cannot_be_told_from", c.indistinguishable_from},
         {"held_back", c.held_back.empty() ? null : Json(c.held_back.english())},
         {"check", check_json(c)},
         {"explanation", c.explanation}};
  j["unnamed"] = c.unnamed.has_value();
  if (c.unnamed) add_curve_keys(session, c, j);
  return j;
}

Json observation_json(const ObservationAttribution& o, const Rig* rig) {
  const bool tracker = !rig;
  const Json null = nullptr;
  const std::string change = change_text(o.change, rig);
  const std::string_view cause = error_cause_name(o.attribution.cause);
  return {{"id", o.id},
          {"error_attribution", attribution_json(o.attribution)},
          {"blame", attribution_json(o.attribution)},  // its older name
          {"cause", cause.empty() ? null : Json(cause)},
          {"single_change", change.empty() ? null : Json(change)},
          {"smallest_visible_pixel", tracker ? null : number(o.smallest_visible)},
          {"smallest_visible_m", tracker ? number(o.smallest_visible) : null}};
}

/// Those whose own fault it is: not the robot's, which a missing effect makes everybody's.
void print_odd_observations(const Output& out, const Diagnosis& d, const Rig* rig) {
  const bool tracker = !rig;
  constexpr int most = 5;
  int odd = 0;
  for (const ObservationAttribution& o : d.observations) {
    if (o.attribution.cause != ErrorCause::cameras && o.attribution.cause != ErrorCause::body) continue;
    if (++odd > most) continue;
    const std::string visible = o.smallest_visible
                                    ? fmt::format(" (an error under {} here could not be seen)",
                                                  tracker ? fmt::format("{:.1f} mm", 1e3 * *o.smallest_visible)
                                                          : fmt::format("{:.1f} px", *o.smallest_visible))
                                    : "";
    out.line(fmt::format("Odd       observation {}: {}{}", o.id, change_text(o.change, rig), visible));
  }
  if (odd > most) out.line(fmt::format("          and {} more; see per_observation of --json", odd - most));
}

/// The curve through the residuals over what they follow, and its band.
Json trend_json(const DiagnosisPattern& p) {
  Json points = Json::array();
  for (const TrendPoint& t : compute_trend(p.against.values, p.residual.values))
    points.push_back({{"x", number(t.x)}, {"y", number(t.y)}, {"low", number(t.low)}, {"high", number(t.high)}});
  return points;
}

/// Is it one of those that the poses could not show? These have a line of their own.
bool is_invisible(const DiagnosisCandidate& c, const Diagnosis& d) {
  return !c.unnamed && std::find(d.invisible.begin(), d.invisible.end(), c.id) != d.invisible.end();
}

/// "3.4 px held out (rms), 4.1 px elsewhere; noise 0.20 px"
std::string error_line(const StoryError& e) {
  if (!e.error) return "unknown";
  std::string line = story_size_text(*e.error, e.in_pixels) + (e.held_out ? " held out (rms)" : " (rms)");
  if (e.elsewhere)
    line += fmt::format(", {} where whole regions are held out", story_size_text(*e.elsewhere, e.in_pixels));
  return e.noise ? line + "; noise " + story_size_text(*e.noise, e.in_pixels).english() : line;
}

const char* next_text(StoryNext next) {
  switch (next) {
    case StoryNext::wait:
      return "wait";
    case StoryNext::measure_more:
      return "measure_more";
    case StoryNext::tell_apart:
      return "tell_apart";
    case StoryNext::add:
      return "add";
    case StoryNext::add_or_stop:
      return "add_or_stop";
    case StoryNext::tell_the_noise:
      return "tell_the_noise";
    case StoryNext::give_masses:
      return "give_masses";
    case StoryNext::look:
      return "look";
    case StoryNext::use_it:
      return "use_it";
  }
  return "";
}

Json story_json(const Diagnosis& d, const std::set<std::string>& refused) {
  const Story s = find_story(d, refused);
  Json causes = Json::array(), stand_ins = Json::array();
  for (const StoryCause& c : s.causes)
    causes.push_back({{"id", c.id}, {"where", c.where}, {"left", number(c.left)}, {"believable", c.believable}});
  for (const StandIn& one : s.stands_in)
    stand_ins.push_back({{"id", one.id}, {"where", one.where}, {"pushes_back", one.pushes_back}});
  return {{"state", story_state_text(s.state)},
          {"text", story_text(s, d)},
          {"figure", "rms"},
          {"unit", s.error.in_pixels ? "px" : "m"},
          {"error", number(s.error.error)},
          {"noise", number(s.error.noise)},
          {"elsewhere", number(s.error.elsewhere)},
          {"cause_leads", s.cause_leads},
          {"causes", causes},
          {"stands_in", stand_ins},
          {"beyond_three_times_the_noise", s.beyond},
          {"next", next_text(s.next)}};
}

std::string sure(double ln_bayes_factor) {
  return ln_bayes_factor > 999 ? ">999" : fmt::format("{:.1f}", ln_bayes_factor);
}

/// Would both be read as one figure?
bool is_about(const ErrorSummary& a, const ErrorSummary& b) {
  constexpr double as_read = 0.03;  // two digits
  return a.rms_pixel && b.rms_pixel && std::abs(*a.rms_pixel - *b.rms_pixel) < as_read * *b.rms_pixel;
}

}  // namespace

void print_diagnosis(const Output& out, const Session& session, const Diagnosis& d,
                     const std::optional<ErrorSummary>& left_by_fit) {
  const bool tracker = session.is_tracker();
  const Story story = find_story(d);
  out.line(fmt::format("{}: {}", session.title.empty() ? "Session" : session.title, verdict_text(d.verdict)));
  out.line(story_text(story, d));
  if (d.verdict == Verdict::too_few_observations) return;
  out.line();
  const std::string repeatability =
      d.verdict == Verdict::adequate ? repeatability_text(d.repeatability, d.model.session.joints) : "";
  out.line(fmt::format("Error     {}{}{}", error_line(story.error), story.error.noise ? "" : "; noise unknown",
                       repeatability.empty() ? "" : "; scatter as of " + repeatability));
  if (left_by_fit && !is_about(*left_by_fit, d.report.held_out))
    out.line(fmt::format(
        "          each pixel counts alike here; fit weighs the robot's own error from pose to pose, and leaves "
        "{} held out",
        error_text(*left_by_fit)));
  if (d.attribution.cause != ErrorCause::none)
    out.line(fmt::format("Due to    robot {} %, marker body {} %, cameras {} % of what exceeds the noise",
                         whole_percent(d.attribution.robot), whole_percent(d.attribution.body),
                         whole_percent(d.attribution.cameras)));
  for (const Message& text : unknown_texts(d.model.session, d.model.fit)) out.line("Note      " + text);
  print_odd_observations(out, d, d.model.session.rig ? &*d.model.session.rig : nullptr);
  if (!d.model.lone.empty()) out.line("Left out  " + lone_text(d.model.lone, tracker));
  if (!d.model.wrong.empty()) out.line(fmt::format("Left out  {} wrong points", d.model.wrong.size()));
  out.line();
  out.line(fmt::format("{:<26} {:>8}  {:>9}  {:>10}  where", "Candidate", "ln BF", "held out", "explained"));
  int shown = 0;
  for (const DiagnosisCandidate& c : d.candidates) {
    if (is_invisible(c, d)) continue;  // told below
    if (++shown > 8) break;
    const std::string name = c.unnamed ? "(unnamed) " + c.unnamed->empirical_error.variable->name : c.id;
    std::string held = "-";
    if (c.held_out) held = error_text(*c.held_out);
    out.line(fmt::format("{:<26} {:>8}  {:>9}  {:>10}  {}", name, sure(c.ln_bayes_factor), held,
                         c.explained ? whole_percent(*c.explained) + " %" : "-", listed(c.where)));
  }
  out.line(fmt::format("An effect counts from ln BF {:.1f} on: with nothing missing one session in 200 would reach it.",
                       d.threshold));
  for (const DiagnosisCandidate& c : d.candidates)
    if (!c.held_back.empty()) out.line(fmt::format("{} is not named: {}.", c.id, c.held_back));
  if (!d.patterns.empty()) {
    out.line();
    out.line("Where it fails");
    for (std::size_t i = 0; i < std::min<std::size_t>(3, d.patterns.size()); ++i)
      out.line(fmt::format("  {} against {} (strength {:.2f}, p {:.1g})", d.patterns[i].residual.name,
                           d.patterns[i].against.name, d.patterns[i].strength, d.patterns[i].p_value));
  }
  if (const std::vector<std::string> unseen = unseen_effects(d); !unseen.empty()) {
    out.line();
    out.line("These poses could not show: " + listed(unseen));
  }
}

/// One a joint, rad; an empty object where all joints are taken to repeat alike.
static Json repeatabilities_json(const Diagnosis& d) {
  Json j = Json::object();
  const std::vector<std::string>& names = d.model.session.joints;
  const std::vector<double>& times = d.repeatability.of_joint;
  if (times.size() != names.size()) return j;
  for (std::size_t i = 0; i < names.size(); ++i) j[names[i]] = d.repeatability.joints * times[i];
  return j;
}

Json diagnosis_json(const Session& session, const Diagnosis& d, const std::set<std::string>& refused) {
  const bool tracker = session.is_tracker();
  const Json null = nullptr;
  Json j{{"verdict", verdict_text(d.verdict)},
         {"reason", d.reason},
         {"story", story_json(d, refused)},
         {"observations", d.report.observations},
         {"used", d.report.used},
         {"rms_pixel", number(d.report.fitted.rms_pixel)},
         {"rms_m", number(d.report.fitted.rms_m)},
         {"mean_m", number(d.report.fitted.mean_m)},
         {"held_out_rms_pixel", number(d.report.held_out.rms_pixel)},
         {"held_out_rms_m", number(d.report.held_out.rms_m)},
         {"held_out_mean_m", number(d.report.held_out.mean_m)},
         {"held_out_region_pixel", number(d.report.held_out_region.rms_pixel)},
         {"held_out_region_rms_m", number(d.report.held_out_region.rms_m)},
         {"held_out_region_mean_m", number(d.report.held_out_region.mean_m)},
         {"noise_pixel", tracker ? null : number(d.noise)},
         {"noise_m", tracker ? number(d.noise) : null},
         {"error_attribution", attribution_json(d.attribution)},
         {"blame", attribution_json(d.attribution)},  // its older name
         {"joint_repeatability_rad", d.repeatability.joints},
         {"joint_repeatabilities_rad", repeatabilities_json(d)},
         {"place_repeatability_m", d.repeatability.place},
         {"place_scatter_m", d.repeatability.place},  // its older name
         {"threshold_ln_bayes_factor", d.threshold},
         {"lack_of_fit_p", number(d.lack_of_fit_p)}};
  j["undetermined"] = unknown_texts(d.model.session, d.model.fit);
  Json candidates = Json::array(), patterns = Json::array();
  for (const DiagnosisCandidate& c : d.candidates) candidates.push_back(candidate_json(session, c));
  for (const DiagnosisPattern& p : d.patterns)
    patterns.push_back({{"residual", p.residual.name},
                        {"against", p.against.name},
                        {"unit", p.residual.unit + " against " + p.against.unit},
                        {"strength", number(p.strength)},
                        {"p_value", number(p.p_value)},
                        {"trend", trend_json(p)}});
  j["candidates"] = candidates;
  j["patterns"] = patterns;
  j["invisible"] = d.invisible;
  j["wrong_points"] = wrong_points_json(d.model.wrong, d.model.session);
  j["lone_observations"] = lone_json(d.model.lone);
  Json observations = Json::array();
  for (const ObservationAttribution& o : d.observations)
    observations.push_back(observation_json(o, d.model.session.rig ? &*d.model.session.rig : nullptr));
  j["per_observation"] = observations;
  if (d.sample)
    j["sample"] = {{"observations", d.sample->taken},
                   {"of", d.sample->all},
                   {"others_rms_pixel", number(d.sample->others.rms_pixel)},
                   {"others_rms_m", number(d.sample->others.rms_m)},
                   {"others_mean_m", number(d.sample->others.mean_m)}};
  return j;
}

Json lone_json(const std::vector<LoneObservation>& lone) {
  Json list = Json::array();
  for (const LoneObservation& l : lone)
    list.push_back({{"id", l.id}, {"rms", number(l.error)}, {"others_at_most", number(l.others)}});
  return list;
}

Json flipped_json(const std::vector<FlippedTarget>& flipped) {
  Json list = Json::array();
  for (const FlippedTarget& f : flipped)
    list.push_back({{"id", f.id}, {"turned_rad", number(f.turned)}, {"when_flipped_rad", number(f.when_flipped)}});
  return list;
}

Json wrong_points_json(const std::vector<WrongPoint>& wrong, const Session& session) {
  Json list = Json::array();
  for (const WrongPoint& w : wrong)
    list.push_back({{"id", w.id},
                    {"marker", w.marker},
                    {"seen_by", w.camera == by_tracker ? "tracker" : session.rig->at(w.camera).name},
                    {"off_by", w.distance}});
  return list;
}

}  // namespace handsight::cli
