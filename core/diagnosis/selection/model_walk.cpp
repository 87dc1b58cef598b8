// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/model_walk.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnosis/ranking/curves.h"
#include "diagnosis/selection/background.h"
#include "diagnosis/selection/begin_of_names.h"
#include "diagnosis/selection/diagnosed_model.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/fuller_models.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/selection/simple_models.h"
#include "diagnosis/verdict/finding.h"
#include "estimation/fit/sure_fit.h"

namespace handsight {
namespace {

/// Without curves beside them, names that leave an unnamed curve on top have explained nothing.
void take_back(Improvement& settled, Improvement& m) {
  for (std::size_t i = settled.steps.size(); i < m.steps.size(); ++i)
    m.refused.push_back({m.steps[i].added, m.steps[i].where,
                         "with it an unnamed curve, which is to be left out, still explains more than any name"});
  m.steps = std::move(settled.steps);
  m.last = std::move(settled.last);
}

/// What was not taken beside other names and is in the model now was not refused.
void forget_refusals_of(const std::vector<std::string>& come, std::vector<RefusedStep>& refused) {
  std::erase_if(refused, [&](const RefusedStep& r) { return std::find(come.begin(), come.end(), r.id) != come.end(); });
}

bool is_behind_small(const std::vector<DiagnosisCandidate>& candidates, const std::string& added) {
  const auto taken = std::find_if(candidates.begin(), candidates.end(),
                                  [&](const DiagnosisCandidate& c) { return !c.unnamed && c.id == added; });
  return taken != candidates.begin() && taken != candidates.end() &&
         is_likelier_beside_small(candidates.front(), *taken);
}

/// A name, or further places of one that the model has.
std::string told(const LikelyName& l) {
  return l.name.is_in_model ? fmt::format("{} {}", l.name.id, fmt::join(l.name.where, " ")) : l.name.id;
}

}  // namespace

ModelWalk::ModelWalk(const Session& session, const ImprovementOptions& options) : session_(session), options_(options) {
  options_.with_held_out = false;
}

void ModelWalk::begin() { begin_with(options_.estimated); }

void ModelWalk::begin_at(Diagnosis model) {
  has_begun_with_names_ = model.model_options.estimated.size() > options_.estimated.size();
  stand_at(std::move(model));
}

void ModelWalk::begin_with(const std::vector<EffectTerm>& estimated) {
  stand_at(diagnosed_from(session_, options_, estimated, {}));
  m_.models = 1;
}

void ModelWalk::stand_at(Diagnosis model) {
  m_.last = std::move(model);
  m_.most_models = options_.most_models;
  if (!m_.last.stopped) set_errors_elsewhere(m_.last);
  m_.steps = {find_step(m_.last)};
  m_.stopped = m_.last.stopped;
  settled_ = m_;
}

void ModelWalk::begin_without(const std::string& id, const Diagnosis& end) {
  std::vector<EffectTerm> rest = end.model_options.estimated;
  const bool was_curve =
      std::any_of(rest.begin(), rest.end(), [&](const EffectTerm& t) { return t.id == id && is_curve(t); });
  std::erase_if(rest, [&](const EffectTerm& t) { return t.id == id; });
  options_.on_step = {};
  begin_with(rest);
  std::erase_if(m_.last.candidates, [&](const DiagnosisCandidate& c) { return c.unnamed ? was_curve : c.id == id; });
}

void ModelWalk::run() {
  while (!m_.stopped && static_cast<int>(m_.steps.size()) <= options_.most_steps && one_more()) {
  }
  if (!options_.with_curves && is_outdone(m_.last) && !m_.stopped) {
    take_back(settled_, m_);
    certain_.reset();
  }
}

void ModelWalk::run_beside_background() {
  if (m_.stopped || m_.models >= options_.most_models) return;
  ModelChange change = add_background(session_, options_, m_.last);
  note_refusals(change);
  if (!change.model) return;
  step_to(std::move(change));
  run();
}

void ModelWalk::take(ModelWalk&& other) {
  ImprovementStep step = find_step(other.m_.last);
  const ChangedNames changed = changed_names(m_.last.model_options.estimated, other.m_.last.model_options.estimated);
  step.removed = fmt::format("{}", fmt::join(changed.gone, ", "));
  step.exchanged = changed.come;
  m_.steps.push_back(std::move(step));
  m_.last = std::move(other.m_.last);
  certain_.reset();
  if (other.options_.estimated.size() == options_.estimated.size()) certain_ = std::move(other.certain_);
  refused_ = std::move(other.refused_);
  m_.refused.insert(m_.refused.end(), other.m_.refused.begin(), other.m_.refused.end());
  forget_refusals_of(changed.come, m_.refused);
}

bool ModelWalk::one_more() {
  if (options_.on_step && !options_.on_step(m_.steps.back())) {
    m_.stopped = true;
    return false;
  }
  if (m_.models >= options_.most_models) {
    m_.is_budget_spent = true;
    return false;
  }
  ModelChange change = add_best(session_, options_, m_.last);
  refused_ = change.refused;
  if (m_.steps.size() == 1 && change.model)
    has_passed_over_ = is_behind_small(m_.last.candidates, change.steps.front().added);
  note_refusals(change);
  if (!change.model && may_seek() && sought_++ < most_times_sought) {
    change = search_models(session_, options_, m_.last);
    for (const ImprovementStep& s : change.steps) forget_refusals_of(s.exchanged, m_.refused);
    note_refusals(change);
  }
  if (!change.model && may_seek()) change = one_that_is_likely();
  if (!change.model && may_seek() && !sought_fuller_) {
    sought_fuller_ = true;
    change = seek_fuller_model(session_, options_, m_.last, certain());
    note_refusals(change);
  }
  if (!change.model && may_seek() && !sought_simpler_) {
    sought_simpler_ = true;
    change = seek_simpler_model(session_, options_, m_.last);
    note_refusals(change);
  }
  if (!change.model && may_seek() && !sought_likeliest_) {
    sought_likeliest_ = true;
    change = take_likeliest(session_, options_, m_.last, certain());
    for (const ImprovementStep& s : change.steps) forget_refusals_of(s.exchanged, m_.refused);
    note_refusals(change);
  }
  if (!change.model) return false;
  step_to(std::move(change));
  return true;
}

void ModelWalk::step_to(ModelChange&& change) {
  m_.steps.insert(m_.steps.end(), change.steps.begin(), change.steps.end());
  m_.last = std::move(*change.model);
  certain_.reset();
  if (!options_.with_curves && !is_outdone(m_.last)) settled_ = m_;
}

/// Each is tried once. From the first that is taken on other names are not sought: they would ask for the evidence
/// of a name again.
ModelChange ModelWalk::one_that_is_likely() {
  InclusionProbabilities now = certain();
  std::erase_if(now.likely, [&](const LikelyName& l) { return !tried_.insert(told(l)).second; });
  ModelChange change = add_likely(session_, options_, m_.last, now);
  note_refusals(change);
  if (!change.model) return change;
  if (std::none_of(now.names.begin(), now.names.end(),
                   [&](const InclusionProbability& n) { return n.is_in_model && n.id == change.steps.back().added; }))
    options_.likely.insert(change.steps.back().added);
  sought_ = most_times_sought;
  return change;
}

const InclusionProbabilities& ModelWalk::certain() {
  if (certain_) return *certain_;
  certain_.emplace();
  if (m_.last.verdict == Verdict::too_few_observations || has_no_answer(m_.last.model.fit)) return *certain_;
  certain_ =
      inclusion_probabilities(m_.last, begin_of_names(m_.last.model_options.estimated, options_.estimated.size()),
                              [&] { return !options_.on_progress || options_.on_progress(0.98); });
  return *certain_;
}

void ModelWalk::note_refusals(const ModelChange& change) {
  // What is refused again is reported once, with the last reason.
  for (const RefusedStep& r : change.refused) {
    std::erase_if(m_.refused, [&](const RefusedStep& o) { return o.id == r.id && o.where == r.where; });
    m_.refused.push_back(r);
  }
  m_.models += change.models;
  m_.stopped = change.stopped;
}

}  // namespace handsight
