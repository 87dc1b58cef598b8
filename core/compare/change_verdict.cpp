// SPDX-License-Identifier: Apache-2.0
#include "compare/change_verdict.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "compare/change_candidates.h"
#include "compare/change_fit.h"
#include "compare/change_limits.h"

namespace handsight {
namespace {

const char* rest_text(const std::string& id, bool are_touches) {
  if (are_touches) {
    if (id == "camera_mount") return "arm and probe are as they were";
    if (id == "body_slip" || id == "marker_slip") return "arm and fixtures are as they were";
    return "fixtures and probe are as they were";
  }
  if (id == "camera_mount" || id == "stereo_rig" || id == "lens") return "arm and hand are as they were";
  if (id == "body_slip" || id == "marker_slip") return "arm and cameras are as they were";
  return "cameras and markers are as they were";
}

/// What the change's own size is: the first of a unit with the same name.
ChangeUnit find_unit(const Change& c) { return {c.id, c.terms, c.where.empty() ? "" : c.where.front()}; }

/// Against nothing having changed, what is rare counted as such.
double ln_odds(const Change& c) { return c.ln_bayes_factor + ln_prior_odds(c.id); }

/// The ranking by the narrowest model that leaves no more than noise, else by the widest.
RankedChanges ranked(const ComparedSides& sides, Comparison& c) {
  RankedChanges found = ranked_changes(sides, {});
  c.model_fits = sides.known ? sides.repeatability.isZero(0) : found.left.p > model_misses;
  if (sides.known) return found;
  for (const Width width : {Width::catalogue, Width::catalogue_and_curves}) {
    if (found.left.p > in_model_uncertainty) break;
    keep_going(sides.progress, width == Width::catalogue ? 0.78 : 0.86);
    found = ranked_changes(widened(sides, width), {});
  }
  return found;
}

}  // namespace

void judge(const ComparedSides& sides, Comparison& c) {
  const RankedChanges first = ranked(sides, c);
  c.changes = first.changes;
  c.threshold = first.threshold;
  if (c.changes.empty() || ln_odds(c.changes.front()) < c.threshold) {
    c.verdict = ComparisonVerdict::unchanged;
    c.sentence = sides.after.problem.source->chain.is_touch
                     ? Message("Nothing has changed that these touches show: fixtures, probe and arm are as they were.")
                     : Message("Nothing has changed that these poses show: cameras, hand and arm are as they were.");
    return;
  }
  const Change& best = c.changes.front();
  for (std::size_t i = 1; i < c.changes.size(); ++i)
    if (c.changes[i].ln_bayes_factor > best.ln_bayes_factor - ln_20)
      c.indistinguishable_from.push_back(c.changes[i].id);
  keep_going(sides.progress, 0.94);
  const RankedChanges second = ranked_changes(first.sides, best.terms);
  const bool several = !second.changes.empty() && ln_odds(second.changes.front()) >= c.threshold + ln_20;
  c.verdict = several ? ComparisonVerdict::several : ComparisonVerdict::changed;
  c.sentence = change_text(find_unit(best), best.terms, best.sigma, sides.after.problem.source->chain);
  if (several)
    c.sentence += message("; and more than one thing has changed: {} too, or something that is not in the list.",
                          second.changes.front().id);
  else if (!c.indistinguishable_from.empty())
    c.sentence +=
        message("; or it is {}, which these poses do not tell apart.", fmt::join(c.indistinguishable_from, " or "));
  else
    c.sentence += message("; {}.", rest_text(best.id, sides.after.problem.source->chain.is_touch));
}

std::vector<Eigen::VectorXd> used_positions(const Session& s) {
  std::vector<Eigen::VectorXd> all;
  for (const Observation& o : s.observations)
    if (is_used(o)) all.push_back(o.position);
  return all;
}

HandWay hand_way(const Chain& chain, const std::vector<Eigen::VectorXd>& poses, const std::vector<EffectTerm>& effects,
                 const std::vector<EffectTerm>& changes, const Rigid& tcp_from_body) {
  std::vector<EffectTerm> changed = effects;
  changed.insert(changed.end(), changes.begin(), changes.end());
  HandWay all;
  double sum = 0;
  for (const Eigen::VectorXd& pose : poses) {
    const ObservationState here = states_at(chain, pose);
    const auto body = [&](const std::vector<EffectTerm>& terms) -> Vector3 {
      const Sites sites = moved_sites(here, terms);
      return (observed_ends(here, sites).ends.root_from_tcp * tcp_from_body * small_motion<double>(sites.body))
          .translation;
    };
    const double way = (body(changed) - body(effects)).norm();
    sum += way;
    all.largest = std::max(all.largest, way);
  }
  if (!poses.empty()) all.mean = sum / static_cast<double>(poses.size());
  return all;
}

void measure_hand(const Chain& chain, const std::vector<Eigen::VectorXd>& poses, const std::vector<EffectTerm>& effects,
                  const Rigid& tcp_from_body, Comparison& c) {
  if (poses.empty()) return;
  const bool is_changed = c.verdict != ComparisonVerdict::unchanged;
  const HandWay way =
      hand_way(chain, poses, effects, is_changed ? c.changes.front().terms : std::vector<EffectTerm>(), tcp_from_body);
  c.hand_mean_m = way.mean;
  c.hand_max_m = way.largest;
}

}  // namespace handsight
