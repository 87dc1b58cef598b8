// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/selection/improvement.h"

#include <algorithm>
#include <set>

#include "diagnosis/selection/choosing.h"
#include "diagnosis/selection/conclusion.h"
#include "diagnosis/selection/elsewhere.h"
#include "diagnosis/selection/fuller_models.h"
#include "diagnosis/selection/model_changes.h"
#include "diagnosis/selection/simple_models.h"
#include "diagnosis/verdict/sampled.h"
#include "estimation/fit/sure_fit.h"
#include "estimation/report/fit_report.h"

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

/// One model after another, until nothing is left to add.
class Improving {
 public:
  Improving(const Session& session, const ImprovementOptions& asked) : session_(session), options_(asked) {
    options_.with_held_out = false;
  }

  Improvement run() {
    m_.last = diagnosed(session_, options_);
    m_.models = 1;
    m_.most_models = options_.most_models;
    if (!m_.last.stopped) set_errors_elsewhere(m_.last);
    m_.steps = {find_step(m_.last)};
    m_.stopped = m_.last.stopped;
    const std::optional<double> excess = m_.last.excess;
    settled_ = m_;
    while (!m_.stopped && static_cast<int>(m_.steps.size()) <= options_.most_steps && one_more()) {
    }
    if (!options_.with_curves && is_outdone(m_.last) && !m_.stopped) {
      take_back(settled_, m_);
      certain_.reset();
    }
    if (m_.stopped) return std::move(m_);
    m_.inclusion_probabilities = certain();
    conclude(excess, refused_, m_);
    weigh_the_robots_error();
    return std::move(m_);
  }

 private:
  /// What is missing was asked of fits in which every pixel counts alike, so that it does not pass for the robot's
  /// error from pose to pose. Where such an error is what is left, the answer is that of a fit that weighs it, as fit()
  /// does.
  void weigh_the_robots_error() {
    Diagnosis& d = m_.last;
    if (!session_.rig || has_no_answer(d.model.fit)) return;
    FitOptions o = d.model_options;
    o.smallest_step = FitOptions{}.smallest_step;
    Fit weighed = fit(d.model.session, o);
    if (!weighed.converged() || !weighed.problem.flange_error.is_any()) return;
    d.model.fit = std::move(weighed);
    d.report = report(d.model.session, d.model.fit, o);
    set_errors_elsewhere(d);
    const ImprovementStep now = find_step(d);
    ImprovementStep& last = m_.steps.back();
    m_.unweighed = last;
    last.fitted = now.fitted;
    last.held_out = now.held_out;
    last.held_out_region = now.held_out_region;
    last.held_out_session = now.held_out_session;
  }

  /// False where nothing is left, or it was stopped.
  bool one_more() {
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
    note_refusals(change);
    if (!change.model && !m_.stopped && m_.steps.size() > 1 && sought_++ < most_times_sought) {
      change = search_models(session_, options_, m_.last);
      for (const ImprovementStep& s : change.steps) forget_refusals_of(s.exchanged, m_.refused);
      note_refusals(change);
    }
    if (!change.model && !m_.stopped && m_.steps.size() > 1) change = one_that_is_likely();
    if (!change.model && !m_.stopped && m_.steps.size() > 1 && !sought_fuller_) {
      sought_fuller_ = true;
      change = seek_fuller_model(session_, options_, m_.last, certain());
      note_refusals(change);
    }
    if (!change.model && !m_.stopped && m_.steps.size() > 1 && !sought_simpler_) {
      sought_simpler_ = true;
      change = seek_simpler_model(session_, options_, m_.last);
      note_refusals(change);
    }
    if (!change.model && !m_.stopped && m_.steps.size() > 1 && !sought_likeliest_) {
      sought_likeliest_ = true;
      change = take_likeliest(session_, options_, m_.last, certain());
      for (const ImprovementStep& s : change.steps) forget_refusals_of(s.exchanged, m_.refused);
      note_refusals(change);
    }
    if (!change.model) return false;
    m_.steps.insert(m_.steps.end(), change.steps.begin(), change.steps.end());
    m_.last = std::move(*change.model);
    certain_.reset();
    if (!options_.with_curves && !is_outdone(m_.last)) settled_ = m_;
    return true;
  }

  /// Each is tried once. From the first that is taken on other names are not sought: they would ask for the evidence
  /// of a name again.
  ModelChange one_that_is_likely() {
    InclusionProbabilities now = certain();
    std::erase_if(now.likely, [&](const LikelyName& l) { return !tried_.insert(l.name.id).second; });
    ModelChange change = add_likely(session_, options_, m_.last, now);
    note_refusals(change);
    if (!change.model) return change;
    options_.likely.insert(change.steps.back().added);
    sought_ = most_times_sought;
    return change;
  }

  /// Of the last model; asked once.
  const InclusionProbabilities& certain() {
    if (certain_) return *certain_;
    certain_.emplace();
    if (m_.last.verdict == Verdict::too_few_observations || has_no_answer(m_.last.model.fit)) return *certain_;
    certain_ = inclusion_probabilities(m_.last, options_.estimated.size(),
                                       [&] { return !options_.on_progress || options_.on_progress(0.98); });
    return *certain_;
  }

  void note_refusals(const ModelChange& change) {
    // What is refused again is reported once, with the last reason.
    for (const RefusedStep& r : change.refused) {
      std::erase_if(m_.refused, [&](const RefusedStep& o) { return o.id == r.id && o.where == r.where; });
      m_.refused.push_back(r);
    }
    m_.models += change.models;
    m_.stopped = change.stopped;
  }

  const Session& session_;
  ImprovementOptions options_;
  Improvement m_;
  Improvement settled_;                            // names alone: the last model that no unnamed curve outdoes
  std::vector<RefusedStep> refused_;               // of the last model
  std::optional<InclusionProbabilities> certain_;  // of the last model; absent: not asked yet
  int sought_ = 0;                                 // times
  bool sought_simpler_ = false, sought_fuller_ = false, sought_likeliest_ = false;
  std::set<std::string> tried_;  // likely names
};

void try_choosing(const Session& session, const ImprovementOptions& options, Improvement& m) {
  const bool has_chosen =
      options.with_choosing && m.steps.size() > 1 && !m.stopped && m.last.verdict != Verdict::too_few_observations;
  const Fit& chosen = m.last.model.fit;
  if (!has_chosen || !session.parts.empty() || has_no_answer(chosen) || !are_few_to_choose_by(chosen) ||
      !is_cheap_to_choose(chosen, m.models))
    return;
  ImprovementOptions quiet = options;
  quiet.on_step = {};
  quiet.on_iteration = {};
  quiet.on_progress = [&options](double) { return !options.on_progress || options.on_progress(0.99); };
  m.held_out_choosing = error_with_choosing(session, chosen, [&](const Session& part) -> std::optional<Fit> {
    Improvement without = Improving(part, quiet).run();
    if (without.stopped) return std::nullopt;
    return std::move(without.last.model.fit);
  });
}

}  // namespace

Improvement improve(const Session& session, const ImprovementOptions& options) {
  if (const auto sample = sample_to_judge(session)) {
    Improvement m = improve(sample->session, options);
    check_on_the_others(session, *sample, m.last);
    return m;
  }
  Improvement m = Improving(session, options).run();
  try_choosing(session, options, m);
  return m;
}

}  // namespace handsight
