// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/background.h"

#include <algorithm>

#include "diagnosis/ranking/curves.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/diagnosed_model.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/space/spreading.h"
#include "diagnosis/verdict/explanation.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

/// Is a name larger than usual, so that its prior is wider, or is the target another size than was said? Who describes
/// one thing so wrongly has not measured the others either.
bool is_described_badly(const Diagnosis& model, std::size_t own) {
  const Problem& p = model.model.fit.problem;
  const std::size_t first = term_of_fit(model, own);
  return std::any_of(p.columns_of_effects.begin(), p.columns_of_effects.end(), [&](const EffectColumn& c) {
    const EffectTerm& term = p.terms[c.term];
    return c.term >= first && !is_curve(term) && (c.width > 1 || term.id == "target_scale");
  });
}

bool may_have_background(const Diagnosis& model, std::size_t own) {
  if (model.verdict == Verdict::too_few_observations || has_no_answer(model.model.fit)) return false;
  const bool has_one = begin_of_names(model.model_options.estimated, own) > own;
  return !has_one && is_described_badly(model, own);
}

/// The likeliest, to first order; none where the model alone is likelier.
std::vector<EffectTerm> likeliest_background(const Diagnosis& model, std::size_t first) {
  const ModelSpace all(model.model.fit, term_of_fit(model, first), InclusionProbabilities::cost_of_a_name);
  const Chosen present = all.present();
  return list_terms(all, present,
                    Spreading(all, present).sum(present, std::nullopt, std::nullopt, largest_small).likeliest);
}

void note_background(const std::vector<EffectTerm>& background, const Diagnosis& next, ModelChange& change) {
  ImprovementStep step = find_step(next);
  for (const EffectTerm& t : background)
    if (step.background.empty() || step.background.back() != t.id) step.background.push_back(t.id);
  change.steps.push_back(std::move(step));
}

}  // namespace

ModelChange add_background(const Session& session, const ImprovementOptions& options, const Diagnosis& model) {
  ModelChange change;
  const std::size_t own = options.estimated.size();
  if (!may_have_background(model, own)) return change;
  const std::vector<EffectTerm> background = likeliest_background(model, own);
  if (background.empty()) return change;
  std::vector<EffectTerm> estimated = model.model_options.estimated;
  estimated.insert(estimated.begin() + static_cast<std::ptrdiff_t>(own), background.begin(), background.end());
  const double before = held_out_error(model);
  Diagnosis next = model_from(session, options, estimated, std::nullopt, before);
  change.models = 1;
  change.stopped = next.stopped;
  if (next.stopped || has_no_answer(next.model.fit) || held_out_error(next) >= before) return change;
  if (!worse_elsewhere(model, next, as_good_as_reported).empty()) return change;
  next = diagnosed_on(session, options, std::move(next));
  change.stopped = next.stopped;
  if (next.stopped) return change;
  set_errors_elsewhere(next);
  note_background(background, next, change);
  change.model = std::move(next);
  return change;
}

}  // namespace handsight
