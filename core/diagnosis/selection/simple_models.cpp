// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/simple_models.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <set>

#include "base/threads.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/cost_of_names.h"
#include "diagnosis/selection/diagnosed_model.h"
#include "diagnosis/selection/exchange.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/space/model_space.h"
#include "diagnosis/verdict/candidate_report.h"

namespace handsight {
namespace {

/// One effect alone in the place of a model's names.
struct SimpleModel {
  std::string id;
  FitOptions options;    // the model with it, at its answer
  double ln_gained = 0;  // evidence against the model that stands, with what either costs to choose
};

std::vector<EffectTerm> everywhere(const CandidateEffect& effect) {
  std::vector<EffectTerm> terms;
  for (const CandidateUnit& u : effect.units) terms.push_back(u.term);
  return terms;
}

/// A fit that is still far from what it must reach when it has nearly come to rest.
class HopelessFit {
 public:
  /// `least`: the squares to be reached.
  explicit HopelessFit(double least) : least_(least) {}

  bool is_so_at(double cost) {
    constexpr double far = 4, nearly_at_rest = 0.9;
    const bool is_so = before_ && cost > nearly_at_rest * *before_ && cost > far * least_;
    before_ = cost;
    return is_so;
  }

 private:
  double least_;
  std::optional<double> before_;
};

/// In the place of all estimated terms from `first` on, the likeliest first; fitted in full on the model's points.
/// Those are left out that fit the measurements worse than the model predicts them.
std::vector<SimpleModel> simple_models(const Diagnosis& model, std::size_t first,
                                       const std::function<bool()>& goes_on) {
  const Fit& present = model.model.fit;
  const NoiseModel by = noise_model(present);
  FitOptions o = model.model_options;
  const std::vector<EffectTerm> names(o.estimated.begin() + static_cast<std::ptrdiff_t>(first), o.estimated.end());
  o.estimated.resize(first);
  o.start.reset();
  set_quick(by, o);
  const CleanFit plain{model.model.session, fit(model.model.session, o), {}};
  for (std::size_t t = 0; t < o.estimated.size(); ++t) o.estimated[t] = plain.fit.effects[o.effects.size() + t].term;
  const Candidates candidates = all_candidates(plain.fit.problem);
  const auto places = places_of_effects(candidates);
  const Eigen::Index base = plain.fit.problem.effect_count();
  const double ln_before = compute_ln_evidence(plain, by);
  const double stands = fit_evidence(present, base, by).ln_evidence - cost_of_names(names, places, model.threshold);
  // Held out, an error of points is reported by length, and what a fit leaves by coordinate.
  const double predicted = held_out_error(model) / (model.report.held_out.rms_pixel ? 1 : std::sqrt(3.0));

  std::vector<const CandidateEffect*> simple;
  for (const CandidateEffect& effect : candidates.effects)
    if (!is_judged_elsewhere(effect.units.front().term, plain.fit.problem) && has_one_form(effect))
      simple.push_back(&effect);
  std::vector<std::optional<SimpleModel>> made(simple.size());
  std::mutex one_at_a_time;
  each_part(static_cast<int>(simple.size()), true, [&](int i) {
    const std::vector<EffectTerm> terms = everywhere(*simple[static_cast<std::size_t>(i)]);
    HopelessFit hopeless(std::pow(predicted, 2) * plain.fit.rows);
    FitOptions own = o;
    own.on_iteration = [&](int, double cost, const Unknowns&) {
      const std::scoped_lock lock(one_at_a_time);
      return goes_on() && !hopeless.is_so_at(cost);
    };
    Refit r = refit_with(plain, own, terms, by, ln_before);
    if (!r.fit.converged() || r.fit.residual_rms > predicted) return;
    r.options.on_iteration = nullptr;
    made[static_cast<std::size_t>(i)] = {
        simple[static_cast<std::size_t>(i)]->effect->id, std::move(r.options),
        ln_before + r.ln_bayes_factor - cost_of_names(terms, places, model.threshold) - stands};
  });
  if (!goes_on()) return {};
  std::vector<SimpleModel> found;
  for (std::optional<SimpleModel>& one : made)
    if (one) found.push_back(std::move(*one));
  std::stable_sort(found.begin(), found.end(),
                   [](const SimpleModel& a, const SimpleModel& b) { return a.ln_gained > b.ln_gained; });
  return found;
}

std::string list_ids(const std::vector<EffectTerm>& terms) {
  std::vector<std::string> ids;
  for (const EffectTerm& t : terms)
    if (std::find(ids.begin(), ids.end(), t.id) == ids.end()) ids.push_back(t.id);
  return fmt::format("{}", fmt::join(ids, ", "));
}

}  // namespace

ModelChange seek_simpler_model(const Session& session, const ImprovementOptions& options, const Diagnosis& model) {
  ModelChange change;
  const auto goes_on = [&] {
    if (options.on_progress && !options.on_progress(0.97)) change.stopped = true;
    return !change.stopped;
  };
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  const std::size_t first = begin_of_names(all, options.estimated.size());
  const std::vector<EffectTerm> gone(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
  if (list_ids(gone).find(',') == std::string::npos) return change;  // one alone stands already
  for (const SimpleModel& simple : simple_models(model, first, goes_on)) {
    const double most = (simple.ln_gained > clear_gain ? as_good_as_reported : clearly_less) * held_out_error(model);
    ++change.models;
    auto next = in_the_place_of(model, session, options, simple.options.estimated, simple.options.start, most);
    change.stopped = change.stopped || (next && next->stopped);
    if (change.stopped) return change;
    if (!next) continue;
    ImprovementStep step = find_step(*next);
    step.added = simple.id;
    step.terms = {next->model_options.estimated.begin() + static_cast<std::ptrdiff_t>(first),
                  next->model_options.estimated.end()};
    step.where = list_places(step.terms, session);
    step.removed = list_ids(gone);
    change.steps.push_back(std::move(step));
    change.model = std::move(*next);
    return change;
  }
  return change;
}

}  // namespace handsight
