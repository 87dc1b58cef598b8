// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/story/story.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/noise_model.h"
#include "diagnosis/verdict/finding.h"

namespace handsight {
namespace {

constexpr std::size_t most_causes = 4;
constexpr double as_much = 0.5;  // of the best evidence: less only stands in for a part of what has no name

std::optional<double> measure_size(const ErrorSummary& e, bool in_pixels) { return in_pixels ? e.rms_pixel : e.rms_m; }

StoryCause cause_of(const Diagnosis& d, std::size_t i, bool in_pixels, const std::set<std::string>& refused) {
  const DiagnosisCandidate& c = d.candidates[i];
  StoryCause cause{.candidate = i, .id = find_id(c), .where = c.where};
  if (c.held_out) cause.left = measure_size(*c.held_out, in_pixels);
  cause.is_predicted = !cause.left;
  if (!cause.left) cause.left = c.predicted_held_out;
  cause.unnamed = c.unnamed.has_value();
  cause.believable = is_believable(c);
  cause.refused = refused.contains(cause.id);
  cause.indistinguishable_from = c.indistinguishable_from;
  return cause;
}

bool has_curves(const Fit& fit) {
  return std::any_of(fit.effects.begin(), fit.effects.end(),
                     [](const FittedEffect& f) { return term_effect(f.term).is_unnamed(); });
}

bool agrees(const StoryError& e, const Diagnosis& d) {
  return e.ratio() && *e.ratio() < (d.repeatability.is_any() ? most_beside_repeatability : most_that_agrees);
}

StoryState read_state(const Story& s, const Diagnosis& d, const Fit& fit) {
  switch (d.verdict) {
    case Verdict::too_few_observations:
      return StoryState::too_few_observations;
    case Verdict::adequate:
      if (!s.error.noise) return StoryState::noise_unknown;
      if (!agrees(s.error, d)) return StoryState::repeatability;
      return has_curves(fit) ? StoryState::unnamed_at_the_noise : StoryState::at_the_noise;
    case Verdict::missing_effect:
    case Verdict::ambiguous:
      if (s.causes.empty() || s.causes.front().refused) return StoryState::refused;
      if (!s.causes.front().believable) return StoryState::implausible;
      if (s.causes.front().unnamed) return StoryState::unexplained;
      return d.verdict == Verdict::ambiguous && !s.causes.front().indistinguishable_from.empty() ? StoryState::ambiguous
                                                                                                 : StoryState::missing;
    case Verdict::unexplained:
      return noise_model(fit).knowledge.known ? StoryState::unexplained : StoryState::noise_unknown;
  }
  return StoryState::not_looked;
}

/// Where nothing has a name for it, a cause is the first word only if it says nearly as much as what has none.
bool leads(const Story& s, const Diagnosis& d) {
  if (s.causes.empty() || s.causes.front().refused) return false;
  switch (s.state) {
    case StoryState::missing:
    case StoryState::ambiguous:
    case StoryState::implausible:
      return true;
    case StoryState::noise_unknown:
    case StoryState::unexplained:
      return s.causes.front().believable &&
             d.candidates[s.causes.front().candidate].ln_bayes_factor >= as_much * d.candidates.front().ln_bayes_factor;
    default:
      return false;
  }
}

StoryNext next_of(const Story& s) {
  switch (s.state) {
    case StoryState::not_looked:
      return StoryNext::wait;
    case StoryState::too_few_observations:
      return StoryNext::measure_more;
    case StoryState::noise_unknown:
      return s.cause_leads ? StoryNext::add : StoryNext::tell_the_noise;
    case StoryState::at_the_noise:
    case StoryState::unnamed_at_the_noise:
    case StoryState::repeatability:
      return StoryNext::use_it;
    case StoryState::missing:
      return StoryNext::add;
    case StoryState::ambiguous:
      return StoryNext::tell_apart;
    case StoryState::implausible:
      return StoryNext::add_or_stop;
    case StoryState::unexplained:
    case StoryState::refused:
      if (s.cause_leads) return StoryNext::add;
      return s.cannot_bend ? StoryNext::give_masses : StoryNext::look;
  }
  return StoryNext::look;
}

/// Springs of joints and links bend by the links' weight: of a robot without masses they are never seen.
bool nothing_bends(const Session& session) {
  return !session.robot.is_of_poses && !session.gravity.isZero() &&
         std::none_of(session.robot.links.begin(), session.robot.links.end(), [](const Link& l) { return l.mass > 0; });
}

void count_beyond(const FitReport& report, Story& s) {
  s.used = report.used;
  if (!s.error.noise || !(*s.error.noise > 0)) return;
  for (const ObservationReport& o : report.per_observation) {
    const auto size = s.error.in_pixels ? o.rms_pixel : o.rms_m;
    if (size && *size > beyond_noise * *s.error.noise) ++s.beyond;
  }
}

}  // namespace

const char* story_state_text(StoryState state) {
  switch (state) {
    case StoryState::not_looked:
      return "not_looked";
    case StoryState::too_few_observations:
      return "too_few_observations";
    case StoryState::noise_unknown:
      return "noise_unknown";
    case StoryState::at_the_noise:
      return "at_the_noise";
    case StoryState::unnamed_at_the_noise:
      return "unnamed_at_the_noise";
    case StoryState::repeatability:
      return "scatter";
    case StoryState::missing:
      return "missing";
    case StoryState::ambiguous:
      return "ambiguous";
    case StoryState::implausible:
      return "implausible";
    case StoryState::unexplained:
      return "unexplained";
    case StoryState::refused:
      return "refused";
  }
  return "";
}

StoryError story_error(const Fit& fit, const FitReport& report) {
  StoryError e;
  e.in_pixels = fit.problem.rig.has_value();
  if (report.used >= fewest_that_tell) {
    e.error = measure_size(report.held_out, e.in_pixels);
    e.held_out = e.error.has_value();
    if (!e.error) e.error = measure_size(report.fitted, e.in_pixels);
    e.elsewhere = measure_size(report.held_out_region, e.in_pixels);
  }
  e.noise = reported_noise(fit.noise, report.rms_of_noise_m, e.in_pixels);
  return e;
}

Story find_story(const StoryBasis& b) {
  Story s;
  s.error = story_error(b.fit, b.report);
  if (!s.error.elsewhere) s.error.elsewhere = b.elsewhere;
  s.attribution = b.attribution;
  count_beyond(b.report, s);
  s.stands_in = stand_ins(b.fit);
  if (!b.diagnosis) return s;
  const Diagnosis& d = *b.diagnosis;
  if (!s.error.elsewhere) s.error.elsewhere = measure_size(d.report.held_out_region, s.error.in_pixels);
  const bool can_add = d.verdict != Verdict::adequate && d.verdict != Verdict::too_few_observations;
  if (can_add)
    for (const std::size_t i : offered(d, b.refused)) {
      if (s.causes.size() >= most_causes) break;
      s.causes.push_back(cause_of(d, i, s.error.in_pixels, b.refused));
    }
  s.state = read_state(s, d, b.fit);
  s.cause_leads = leads(s, d);
  const bool is_left = s.state == StoryState::unexplained || s.state == StoryState::refused;
  s.cannot_bend = is_left && nothing_bends(d.model.session);
  s.next = next_of(s);
  if (can_add) s.attribution = attribution_by_finding(b.attribution, d, b.refused);
  return s;
}

Story find_story(const Diagnosis& d, const std::set<std::string>& refused) {
  Story s = find_story(
      StoryBasis{.fit = d.model.fit, .report = d.report, .attribution = {}, .diagnosis = &d, .refused = refused});
  s.attribution = d.attribution;
  return s;
}

}  // namespace handsight
