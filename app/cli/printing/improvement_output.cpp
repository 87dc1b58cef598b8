// SPDX-License-Identifier: Apache-2.0
#include "improvement_output.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/percent.h"
#include "bill_output.h"
#include "diagnosis/story/story.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis_output.h"
#include "fit_output.h"
#include "json_values.h"

namespace handsight::cli {
namespace {

/// The noise as it is reported beside an error.
std::string noise_or_unknown(const ImprovementStep& s, bool tracker) {
  const std::optional<double> noise = reported_noise(s.noise, s.rms_of_noise_m, !tracker);
  if (!noise) return "unknown";
  return tracker ? fmt::format("{:.3f} mm", 1e3 * *noise) : fmt::format("{:.3f} px", *noise);
}

std::string step_title(const ImprovementStep& s, bool is_first) {
  if (is_first) return "(as it was)";
  if (!s.background.empty()) return "small deviations";
  return s.added.empty() ? "names sought again" : "+ " + s.added;
}

/// What else went and came with a step that is not the first.
std::string changes_text(const ImprovementStep& s) {
  if (!s.background.empty()) return "a little at each joint, no causes that are told: " + listed(s.background);
  if (s.added.empty() && s.removed.empty() && s.exchanged.empty()) return "the same names at other places";
  if (s.removed.empty()) return s.exchanged.empty() ? "" : "beside what stands: " + listed(s.exchanged);
  return "no longer needed: " + s.removed +
         (s.exchanged.empty() ? "" : "; in its place " + listed(s.exchanged).english());
}

/// "What may be there too: backlash (axis_4) 23 % and payload 8 %". How sure the model's own names are stands in the
/// bill.
void print_other_names(const Output& out, const InclusionProbabilities& inclusion_probabilities) {
  std::vector<std::string> texts;
  for (const InclusionProbability& n : inclusion_probabilities.names) {
    if (n.is_in_model) continue;
    const std::string where = n.where.empty() ? "" : " (" + listed(n.where) + ")";
    // Never quite sure, nor quite sure that not.
    const std::string percent = n.probability > 0.999 ? "over 99.9" : two_digit_percent(std::max(n.probability, 0.001));
    texts.push_back(fmt::format("{}{} {} %", n.id, where, percent));
  }
  if (texts.empty()) return;
  out.line("What may be there too: " + listed(texts) + ". Predictions allow for it.");
  out.line();
}

Json inclusion_probabilities_json(const InclusionProbabilities& inclusion_probabilities) {
  Json list = Json::array();
  for (const InclusionProbability& n : inclusion_probabilities.names)
    list.push_back({{"id", n.id}, {"where", n.where}, {"probability", n.probability}, {"in_model", n.is_in_model}});
  return list;
}

Json step_json(const ImprovementStep& s, bool tracker) {
  const Json null = nullptr;
  return {{"added", s.added.empty() ? null : Json(s.added)},
          {"removed", s.removed.empty() ? null : Json(s.removed)},
          {"exchanged", s.exchanged},
          {"a_little_at_each_joint", s.background},
          {"where", s.where},
          {"formula", s.formula.empty() ? null : Json(s.formula)},
          {"variable", s.variable.empty() ? null : Json(s.variable)},
          {"stands_in", s.stands},
          {"rms_pixel", number(s.fitted.rms_pixel)},
          {"held_out_rms_pixel", number(s.held_out.rms_pixel)},
          {"noise_pixel", tracker ? null : number(s.noise)},
          {"rms_m", number(s.fitted.rms_m)},
          {"mean_m", number(s.fitted.mean_m)},
          {"held_out_rms_m", number(s.held_out.rms_m)},
          {"held_out_mean_m", number(s.held_out.mean_m)},
          {"held_out_region_pixel", number(s.held_out_region.rms_pixel)},
          {"held_out_region_rms_m", number(s.held_out_region.rms_m)},
          {"held_out_region_mean_m", number(s.held_out_region.mean_m)},
          {"noise_m", tracker ? number(s.noise) : null},
          {"noise_rms_m", tracker ? number(reported_noise(s.noise, s.rms_of_noise_m, false)) : null}};
}

}  // namespace

static std::set<std::string> list_refused(const Improvement& m) {
  std::set<std::string> ids;
  for (const RefusedStep& r : m.refused) ids.insert(r.id);
  return ids;
}

void print_improvement(const Output& out, const Session& session, const Improvement& m) {
  const bool tracker = session.is_tracker();
  out.line(fmt::format("{:<4} {:<24} {:>12} {:>12} {:>12} {:>12}  where", "step", "added", "fitted", "held out",
                       "by region", "noise"));
  for (std::size_t i = 0; i < m.steps.size(); ++i) {
    const ImprovementStep& s = m.steps[i];
    const std::string what = step_title(s, i == 0);
    out.line(fmt::format("{:<4} {:<24} {:>12} {:>12} {:>12} {:>12}  {}", i, what, error_text(s.fitted),
                         error_text(s.held_out), error_text(s.held_out_region), noise_or_unknown(s, tracker),
                         listed(s.where)));
    if (!s.formula.empty()) out.line("     " + s.formula);
    if (!s.stands.empty()) out.line("     stands in for something else: no robot has " + listed(s.stands));
    if (const std::string changes = i > 0 ? changes_text(s) : ""; !changes.empty()) out.line("     " + changes);
  }
  if (m.unweighed)
    out.line(fmt::format(
        "     the last weighs the robot's own error from pose to pose beside the noise; without it {} fitted, "
        "{} held out",
        error_text(m.unweighed->fitted), error_text(m.unweighed->held_out)));
  for (const RefusedStep& r : m.refused)
    out.line(
        fmt::format("     not taken: {}{}: {}", r.id, r.where.empty() ? "" : " (" + listed(r.where) + ")", r.reason));
  out.line(fmt::format("     models tried: {} of at most {}{}", m.models, m.most_models,
                       m.is_budget_spent ? ", which are spent: what else may be missing was not looked for" : ""));
  out.line();
  out.line(
      fmt::format("{}: {}", verdict_text(m.last.verdict), story_text(find_story(m.last, list_refused(m)), m.last)));
  if (m.named_share && m.unnamed_share)
    out.line(fmt::format("Of what exceeded the noise at the start {} % has names, {} % follows something without one.",
                         whole_percent(*m.named_share), whole_percent(*m.unnamed_share)));
  if (m.bill.empty()) out.line();
  print_bill(out, m.bill);
  print_other_names(out, m.inclusion_probabilities);
  print_fit(out, m.last.model.session, m.last.model.fit, m.last.report, m.last.model_options);
  if (const auto& e = m.held_out_choosing)
    out.line(fmt::format(
        "\nExpect {} on new poses: so much is left of poses that took no part in choosing the causes, "
        "which few poses do by chance, too.",
        e->rms_pixel ? text_or_unknown(e->rms_pixel, 1, "px") : text_or_unknown(e->mean_m, 1e3, "mm") + " mean"));
}

Json improvement_json(const Session& session, const Improvement& m) {
  const bool tracker = session.is_tracker();
  const Json null = nullptr;
  const Session& fitted = m.last.sample ? m.last.model.session : session;
  Json j = fit_json(fitted, m.last.model.fit, m.last.report, m.last.model_options);
  Json steps = Json::array(), refused = Json::array();
  for (const ImprovementStep& s : m.steps) steps.push_back(step_json(s, tracker));
  for (std::size_t i = 0; !session.parts.empty() && i < steps.size(); ++i) {
    const ErrorSummary& e = m.steps[i].held_out_session;
    steps[i]["held_out_session_pixel"] = number(e.rms_pixel);
    steps[i]["held_out_session_rms_m"] = number(e.rms_m);
    steps[i]["held_out_session_mean_m"] = number(e.mean_m);
  }
  for (const RefusedStep& r : m.refused) refused.push_back({{"id", r.id}, {"where", r.where}, {"reason", r.reason}});
  if (m.held_out_choosing) {
    j["held_out_choosing_pixel"] = number(m.held_out_choosing->rms_pixel);
    j["held_out_choosing_rms_m"] = number(m.held_out_choosing->rms_m);
    j["held_out_choosing_mean_m"] = number(m.held_out_choosing->mean_m);
  }
  j["steps"] = steps;
  if (m.unweighed) j["unweighed"] = step_json(*m.unweighed, tracker);
  j["refused"] = refused;
  j["models"] = {{"tried", m.models}, {"most", m.most_models}, {"spent", m.is_budget_spent}};
  j["verdict"] = verdict_text(m.last.verdict);
  j["reason"] = m.last.reason;
  j["left"] = diagnosis_json(session, m.last, list_refused(m));
  j["left"]["named_share"] = number(m.named_share);
  j["left"]["unnamed_share"] = number(m.unnamed_share);
  // As it was called before the bill came; for one version more.
  Json worth = Json::array();
  for (const BillRow& row : m.bill)
    worth.push_back({{"id", row.id},
                     {"where", row.where},
                     {"unnamed", row.unnamed},
                     {"follows", row.follows.empty() ? null : Json(row.follows)},
                     {"hand_m", number(row.hand_m)}});
  j["worth"] = worth;
  j["bill"] = bill_json(m.bill);
  j["inclusion_probabilities"] = inclusion_probabilities_json(m.inclusion_probabilities);
  j["certainty"] = j["inclusion_probabilities"];  // its older name
  return j;
}

}  // namespace handsight::cli
