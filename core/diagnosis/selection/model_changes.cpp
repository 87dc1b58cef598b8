// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/model_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/evidence/prior_odds.h"
#include "diagnosis/ranking/curves.h"
#include "diagnosis/ranking/slips.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/diagnosed_model.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/model_search.h"
#include "diagnosis/selection/pruning.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/finding.h"
#include "diagnosis/verdict/stand_in.h"
#include "effects/units.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/report/fit_report.h"

namespace handsight {
namespace {

constexpr double surely_there = 0.95;  // from here on the held-out error need not fall: it knows less than the evidence

/// "mass -6 kg" and the like: numbers that no robot has.
std::vector<std::string> implausible_numbers(const std::vector<EffectTerm>& terms, const Chain& chain) {
  std::vector<std::string> list;
  for (const EffectTerm& term : terms) {
    const Effect& effect = term_effect(term);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const EffectParameter& parameter = effect.parameters[p];
      if (parameter.is_choice || std::abs(term.values[p]) <= find_largest_built(term, p, chain)) continue;
      const std::string place = place_name(effect, term.place, chain.robot);
      list.push_back(fmt::format("{}{} {:.3g} {}", parameter.name, place.empty() ? "" : " of " + place, term.values[p],
                                 unit_at(effect, p, term.place, chain.robot)));
    }
  }
  return list;
}

std::vector<EffectTerm> last_group(const Diagnosis& d, std::size_t count) {
  const std::vector<EffectTerm>& all = d.model_options.estimated;
  return {all.end() - static_cast<std::ptrdiff_t>(std::min(count, all.size())), all.end()};
}

/// The sum of the variances of where the sensor's mount is, m^2; 0 where it is not estimated.
double variance_of_mount(const Fit& fit) {
  if (!fit.problem.mount_is_estimated) return 0;
  const Eigen::Index at = fit.problem.mount_column();
  return fit.parameter_covariance.block<3, 3>(at, at).trace();
}

/// A curve that hardly curves over the poses is a shift, and a shift of the hand is the hand's own place; a link that
/// is longer along the first joint's axis is another place of the sensor. Then both grow without bound, held by a
/// trace of something else that is missing, and TCP->Body or the mount is lost.
bool plays_against_what_rests(const Fit& before, const Diagnosis& after, std::size_t terms) {
  constexpr double far_less_sure = 100;  // times the variance
  const Fit& fit = after.model.fit;
  const std::vector<EffectTerm> added = last_group(after, terms);
  const bool is_of_the_robot = std::all_of(added.begin(), added.end(), [](const EffectTerm& t) {
    return term_effect(t).is_unnamed() || term_effect(t).scope == EffectScope::joint;
  });
  if (!is_of_the_robot || implausible_numbers(added, fit.problem.source->chain).empty()) return false;
  const auto variance_of_hand = [](const Fit& f) { return f.covariance.topLeftCorner<3, 3>().trace(); };
  return variance_of_hand(fit) > far_less_sure * variance_of_hand(before) ||
         variance_of_mount(fit) > far_less_sure * variance_of_mount(before);
}

/// A length of the target that no printer makes of the one described.
bool is_misprint_too_large(const std::vector<EffectTerm>& added, const Chain& chain) {
  return std::any_of(added.begin(), added.end(),
                     [&](const EffectTerm& t) { return t.id == "target_scale" && is_too_large(t, chain); });
}

void note_addition(const DiagnosisCandidate& candidate, const Diagnosis& next, ModelChange& change) {
  ImprovementStep step = find_step(next);
  step.added = candidate.unnamed ? candidate.terms.front().id : candidate.id;
  step.where = candidate.where;
  step.terms = last_group(next, candidate.terms.size());
  step.stands = implausible_numbers(step.terms, next.model.fit.problem.source->chain);
  if (candidate.unnamed) {
    step.formula = formula_text(*candidate.terms.front().own->definition);
    step.variable = candidate.unnamed->empirical_error.variable->name;
  }
  change.steps.push_back(std::move(step));
}

}  // namespace

bool is_outdone(const Diagnosis& d) {
  return !d.candidates.empty() && d.candidates.front().unnamed && d.candidates.front().ln_bayes_factor >= d.threshold;
}

Diagnosis diagnosed(const Session& session, const ImprovementOptions& options) {
  return diagnosed_from(session, options, options.estimated, {});
}

ModelChange add_candidate(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                          const DiagnosisCandidate& candidate) {
  ModelChange change;
  const std::string id = candidate.unnamed ? candidate.terms.front().id : candidate.id;
  if (!candidate.held_back.empty()) {
    change.refused.push_back({id, candidate.where, candidate.held_back});
    return change;
  }
  FitOptions from = candidate.full_fit.value_or(model.model_options);
  if (!candidate.full_fit) from.estimated.insert(from.estimated.end(), candidate.terms.begin(), candidate.terms.end());
  const double before = as_good * held_out_error(model);
  Diagnosis next = model_from(session, options, from.estimated, from.start, before);
  change.models = 1;
  change.stopped = next.stopped;
  if (next.stopped) return change;
  if (has_no_answer(next.model.fit)) {
    change.refused.push_back({id, candidate.where, "the fit finds no answer with it: check mount, cameras and labels"});
    return change;
  }
  if (is_misprint_too_large(last_group(next, candidate.terms.size()), next.model.fit.problem.source->chain)) {
    change.refused.push_back({id, candidate.where,
                              "the target would be more than four times as large as it is described: that is a mistake "
                              "in its description, which is put right before anything else"});
    return change;
  }
  if (plays_against_what_rests(model.model.fit, next, candidate.terms.size())) {
    change.refused.push_back(
        {id, candidate.where,
         "it is larger than robots are built, and the hand's or the sensor's place would be known ten times worse: "
         "it plays against what never moves"});
    return change;
  }
  if (held_out_error(next) >= before) {
    change.refused.push_back({id, candidate.where, "the held-out error does not fall"});
    return change;
  }
  if (const Message why = worse_elsewhere(model, next); !why.empty()) {
    change.refused.push_back({id, candidate.where, why});
    return change;
  }
  if (const auto order = slip_order(candidate.terms);
      order && !slip_is_confirmed(model.model.session, model.model.fit, model.model_options, next.model.fit,
                                  next.model_options, *order)) {
    change.refused.push_back(
        {id, candidate.where, "held out in blocks of time, the observations on both sides of the moment do not agree"});
    return change;
  }
  note_addition(candidate, next, change);
  change.model = std::move(next);
  prune(session, options, before, change);
  if (!change.stopped) {
    change.model = diagnosed_on(session, options, std::move(*change.model));
    change.stopped = change.model->stopped;
  }
  if (change.stopped) {
    change.model.reset();
    return change;
  }
  set_errors_elsewhere(*change.model);
  change.steps.back().held_out_region = change.model->report.held_out_region;
  change.steps.back().held_out_session = change.model->report.held_out_session;
  return change;
}

std::vector<const DiagnosisCandidate*> candidates_to_try(const Diagnosis& model, bool with_curves) {
  std::vector<const DiagnosisCandidate*> order;
  if (model.verdict == Verdict::too_few_observations || model.verdict == Verdict::adequate) return order;
  for (const DiagnosisCandidate& c : model.candidates) {
    const bool can_be_taken = !c.unnamed || (with_curves && c.refitted);
    const bool passes = c.ln_bayes_factor >= model.threshold || !c.held_back.empty();  // that is refused, with its why
    if (!passes || !can_be_taken) continue;
    if (has_no_answer(model.model.fit) && !c.refitted)
      continue;  // nor has the fit with it, or it was not among the likeliest
    order.push_back(&c);
  }
  std::stable_partition(order.begin(), order.end(),
                        [&](const DiagnosisCandidate* c) { return comes_before(*c, model.candidates.front()); });
  return order;
}

ModelChange add_best(const Session& session, const ImprovementOptions& options, const Diagnosis& model) {
  ModelChange all;
  for (const DiagnosisCandidate* candidate : candidates_to_try(model, options.with_curves)) {
    ModelChange one = add_candidate(session, options, model, *candidate);
    all.refused.insert(all.refused.end(), one.refused.begin(), one.refused.end());
    all.model = std::move(one.model);
    all.steps = std::move(one.steps);
    all.stopped = one.stopped;
    all.models += one.models;
    if (all.stopped || all.model) break;
  }
  return all;
}

void put_in_place(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                  const ModelAlternative& other, ModelChange& change) {
  const double most = as_good_as_reported * held_out_error(model);
  ++change.models;
  auto next = in_the_place_of(model, session, options, other.options.estimated, other.options.start, most);
  change.stopped = next && next->stopped;
  if (!next || change.stopped) return;
  ImprovementStep step = find_step(*next);
  step.removed = fmt::format("{}", fmt::join(other.gone, ", "));
  step.exchanged = other.come;
  change.steps.push_back(std::move(step));
  change.model = std::move(*next);
}

ModelChange search_models(const Session& session, const ImprovementOptions& options, const Diagnosis& model) {
  ModelChange change;
  const auto goes_on = [&] {
    if (options.on_progress && !options.on_progress(0.97)) change.stopped = true;
    return !change.stopped;
  };
  const auto other =
      search_models(model, begin_of_names(model.model_options.estimated, options.estimated.size()), goes_on);
  if (other && !change.stopped) put_in_place(session, options, model, *other, change);
  return change;
}

ModelChange add_likely(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                       const InclusionProbabilities& inclusion_probabilities) {
  ModelChange change;
  const bool has_names =
      std::any_of(inclusion_probabilities.names.begin(), inclusion_probabilities.names.end(),
                  [](const InclusionProbability& n) { return n.is_in_model && n.id.find("curve_") != 0; });
  if (!has_names) return change;
  const double before = held_out_error(model);
  for (const LikelyName& likely : inclusion_probabilities.likely) {
    const bool is_sure = likely.name.probability >= surely_there;
    const double most = is_sure ? as_good_as_reported * before : before;
    const std::vector<EffectTerm>& all = model.model_options.estimated;
    const std::size_t first = begin_of_names(all, options.estimated.size());
    std::vector<EffectTerm> estimated(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first));
    estimated.insert(estimated.end(), likely.estimated.begin(), likely.estimated.end());
    ++change.models;
    Diagnosis next = diagnosed_from(session, options, estimated, estimate(model.model.fit), most);
    change.stopped = next.stopped;
    if (next.stopped) return change;
    if (has_no_answer(next.model.fit) || held_out_error(next) >= most) {
      change.refused.push_back({likely.name.id, likely.name.where, "the held-out error does not fall"});
      continue;
    }
    if (const Message why = worse_elsewhere(model, next); !why.empty()) {
      change.refused.push_back({likely.name.id, likely.name.where, why});
      continue;
    }
    ImprovementStep step = find_step(next);
    step.added = likely.name.id;
    step.where = likely.name.where;
    step.terms = last_group(next, estimated.size() - model.model_options.estimated.size());
    step.stands = implausible_numbers(step.terms, next.model.fit.problem.source->chain);
    step.likely = likely.name.probability;
    change.steps.push_back(std::move(step));
    change.model = std::move(next);
    return change;
  }
  return change;
}

ModelChange take_likeliest(const Session& session, const ImprovementOptions& options, const Diagnosis& model,
                           const InclusionProbabilities& inclusion_probabilities) {
  ModelChange change;
  const auto goes_on = [&] {
    if (options.on_progress && !options.on_progress(0.97)) change.stopped = true;
    return !change.stopped;
  };
  const auto other = fit_likeliest(model, begin_of_names(model.model_options.estimated, options.estimated.size()),
                                   inclusion_probabilities, goes_on);
  if (other && !change.stopped) put_in_place(session, options, model, *other, change);
  return change;
}

}  // namespace handsight
