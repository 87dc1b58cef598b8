// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/ranking/outlier_rejection.h"

#include <algorithm>
#include <limits>

#include "diagnosis/ranking/refitting.h"

namespace handsight {
namespace {

constexpr std::size_t fewest_wrong = 4;          // beyond twice what chance makes
constexpr std::size_t most_observations = 4000;  // for which candidates are looked at all together
constexpr std::size_t most_tried = 3;
constexpr double clearly = 10;  // ln of a Bayes factor

/// Can it make points right that do not fit to the others of their observation? What moves whole poses cannot, where
/// the robot's joints reach every motion of the body: there no point is called wrong for a pose that is.
bool parts_points(const RankedEffect& r, const LinearModel& linear, const Chain& chain) {
  if (chain.joints.size() < 6) return true;
  const std::vector<CandidateUnit>& units = r.candidate->units;
  return std::any_of(units.begin(), units.end(), [&](const CandidateUnit& unit) {
    const auto first = linear.internal_of.begin() + unit.first;
    return std::any_of(first, first + unit.count, [](Eigen::Index internal) { return internal >= 0; });
  });
}

/// The same fit of nearly the same points from where one has ended that has looked at all starts: they need not be
/// looked at again. A model with effects, whose priors follow from where it starts, is fitted anew.
FitOptions going_on(const FitOptions& options, const Fit& from) {
  if (!options.estimated.empty() || options.start || options.least_gain > 0) return options;
  FitOptions again = options;
  again.start = estimate(from);
  again.least_gain = std::numeric_limits<double>::min();
  return again;
}

/// The points without which an effect that makes most of the wrong ones right leaves the session; nothing where none
/// does.
std::optional<CleanFit> with_an_explanation(const Session& session, const FitOptions& options, const CleanFit& clean) {
  const CleanFit whole{session, fit(session, going_on(options, clean.fit)), {}};
  if (whole.fit.solution.stopped) return std::nullopt;
  const NoiseModel by = noise_model(clean.fit);
  const Candidates candidates = all_candidates(whole.fit.problem);
  const LinearModel linear = linear_model(candidates.problem, estimate(whole.fit), candidates.base_effects, by.noise);
  const Ranking ranking = rank(linear, by.knowledge, candidates, {});
  std::size_t tried = 0;
  for (const RankedEffect& r : ranking.effects) {
    if (r.ln_bayes_factor < clearly || tried == most_tried) return std::nullopt;
    if (!parts_points(r, linear, candidates.problem.source->chain)) continue;
    ++tried;
    FitOptions with = options;
    const std::vector<EffectTerm> terms = with_settled_orders(whole, terms_with_values(r), by);
    with.estimated.insert(with.estimated.end(), terms.begin(), terms.end());
    CleanFit alternative = clean_fit(session, with);
    if (2 * alternative.wrong.size() <= clean.wrong.size()) return alternative;
  }
  return std::nullopt;
}

CleanFit clean_of_images(const Session& session, const FitOptions& options) {
  CleanFit clean = clean_fit(session, options);
  const auto by_chance = static_cast<std::size_t>(2 * wrong_by_chance * static_cast<double>(point_count(session)));
  if (clean.wrong.size() < fewest_wrong + by_chance || clean.fit.solution.stopped) return clean;
  if (clean.fit.problem.observations.size() > most_observations) return clean;
  auto explained = with_an_explanation(session, options, clean);
  if (!explained) return clean;
  clean.session = std::move(explained->session);
  clean.wrong = std::move(explained->wrong);
  clean.fit = fit(clean.session, going_on(options, clean.fit));
  return clean;
}

/// What an observation that is wrong as a whole has pulled about is looked at again without it.
void leave_out_lone(const Session& session, const FitOptions& options, CleanFit& clean) {
  const std::vector<LoneObservation> lone = lone_observations(clean.session, clean.fit, options);
  if (lone.empty()) return;
  clean = clean_of_images(without(session, lone), options);
  clean.lone = lone;
}

}  // namespace

CleanFit fit_without_outliers(const Session& session, const FitOptions& options) {
  FitOptions of_images = options;
  of_images.objective = Objective::image;
  of_images.fix_markers = false;
  of_images.loss = Loss::none;
  CleanFit clean = clean_of_images(session, of_images);
  if (!clean.fit.solution.stopped) leave_out_lone(session, of_images, clean);
  const bool is_other = options.objective != Objective::image || options.fix_markers || options.loss != Loss::none;
  if (is_other && !clean.fit.solution.stopped) clean.fit = fit(clean.session, options);
  if (!clean.lone.empty()) clean.fit.notes.push_back(lone_text(clean.lone, session.is_tracker()));
  return clean;
}

}  // namespace handsight
