// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/regrowing.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/ranking/refitting.h"
#include "diagnosis/selection/cost_of_names.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/verdict/explanation.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

/// How many more models a walk may try. Unless it is to be thorough, rows times models in all are seconds.
int models_left(const ImprovementOptions& options, const Improvement& m) {
  constexpr int most_rows = 10000;
  const int most = options.is_thorough ? options.most_models : most_rows / std::max(m.last.model.fit.rows, 1);
  return std::min(most, options.most_models) - m.models;
}

/// The ids of a model's terms from `first` on.
std::vector<std::string> least_certain_first(const Diagnosis& model, std::size_t first,
                                             const InclusionProbabilities& certain) {
  std::map<std::string, double> probability;
  for (const InclusionProbability& n : certain.names) probability[n.id] = n.probability;
  std::vector<std::string> ids;
  const std::vector<EffectTerm>& all = model.model_options.estimated;
  for (std::size_t t = first; t < all.size(); ++t)
    if (std::find(ids.begin(), ids.end(), all[t].id) == ids.end()) ids.push_back(all[t].id);
  const auto sure = [&](const std::string& id) {
    const auto told = probability.find(id);
    return told == probability.end() ? 1 : told->second;
  };
  std::stable_sort(ids.begin(), ids.end(),
                   [&](const std::string& a, const std::string& b) { return sure(a) < sure(b); });
  return ids;
}

/// ln of the odds of models of the same points against the one at which the search has ended.
class Odds {
 public:
  Odds(const Diagnosis& end, std::size_t first) : end_(end), first_(first), by_(noise_model(end.model.fit)) {
    FitOptions plain = end.model_options;
    plain.estimated.resize(first);
    plain.start.reset();
    set_quick(by_, plain);
    const Fit without = fit(end.model.session, plain);
    base_ = without.problem.effect_count();
    places_ = places_of_effects(all_candidates(without.problem));
    of_end_ = worth(end);
  }

  /// None where their points differ: something else was taken for an outlier.
  std::optional<double> of(const Diagnosis& other) const {
    if (has_no_answer(other.model.fit) || other.model.fit.rows != end_.model.fit.rows) return std::nullopt;
    return worth(other) - of_end_;
  }

 private:
  double worth(const Diagnosis& d) const {
    const std::vector<EffectTerm>& all = d.model_options.estimated;
    const std::vector<EffectTerm> names(all.begin() + static_cast<std::ptrdiff_t>(first_), all.end());
    return fit_evidence(d.model.fit, base_, by_).ln_evidence -
           cost_of_names(names, places_, InclusionProbabilities::cost_of_a_name);
  }

  const Diagnosis& end_;
  std::size_t first_;
  NoiseModel by_;
  Eigen::Index base_ = 0;
  std::map<std::string, int> places_;
  double of_end_ = 0;
};

/// Has it names of which one could stand in for another, and is something left that they do not explain?
bool is_worth_seeking(const Diagnosis& end, std::size_t first) {
  const bool is_explained = end.verdict == Verdict::adequate || end.verdict == Verdict::too_few_observations;
  return !is_explained && end.model_options.estimated.size() > first && !has_no_answer(end.model.fit);
}

/// `gained`: ln of the odds of the other end.
bool stands_in_its_place(const std::optional<double>& gained, const Diagnosis& end, Diagnosis& other) {
  if (!gained || *gained < -clear_gain) return false;
  const double most = (*gained > clear_gain ? as_good_as_reported : clearly_less) * held_out_error(end);
  return held_out_error(other) <= most && worse_elsewhere(end, other).empty();
}

/// One round: true where the walk goes on from another end.
bool found_another_end(const Session& session, const ImprovementOptions& options, ModelWalk& walk) {
  Improvement& m = walk.so_far();
  const std::size_t first = options.estimated.size();
  const std::vector<std::string> ids = least_certain_first(m.last, first, walk.certain());
  if (ids.size() < 2) return false;
  std::optional<Odds> odds;
  for (const std::string& id : ids) {
    ImprovementOptions own = options;
    own.most_models = models_left(options, m);
    if (own.most_models < 1) {
      m.is_budget_spent = options.is_thorough;
      return false;
    }
    ModelWalk other(session, own);
    other.begin_without(id, m.last);
    other.run();
    Improvement& end = other.so_far();
    m.models += end.models;
    m.stopped = end.stopped;
    if (m.stopped) return false;
    if (!odds) odds.emplace(m.last, first);
    if (!stands_in_its_place(odds->of(end.last), m.last, end.last)) continue;
    walk.take(std::move(other));
    m.stopped = options.on_step && !options.on_step(m.steps.back());
    return !m.stopped;
  }
  return false;
}

}  // namespace

void regrow(const Session& session, const ImprovementOptions& options, ModelWalk& walk) {
  while (is_worth_seeking(walk.so_far().last, options.estimated.size()) && found_another_end(session, options, walk)) {
  }
}

}  // namespace handsight
