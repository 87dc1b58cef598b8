// SPDX-License-Identifier: Apache-2.0
#include "experiment/loop/knowledge.h"

#include <algorithm>
#include <cmath>

#include "certify/limits.h"
#include "diagnosis/verdict/diagnosis.h"
#include "diagnosis/verdict/finding.h"
#include "estimation/report/hand_end.h"
#include "estimation/report/prediction.h"

namespace handsight {
namespace {

constexpr double least_visible = 30;  // DiagnosisCandidate::visibility
constexpr double ln_20 = 2.995732273553991;
constexpr double probability = 0.95;
constexpr double worth_showing = 1;  // ln Bayes factor from which on a candidate is measured for

bool are_distinguished(const DiagnosisCandidate& a, const DiagnosisCandidate& b) {
  return a.id != b.id && std::find(a.indistinguishable_from.begin(), a.indistinguishable_from.end(), b.id) ==
                             a.indistinguishable_from.end();
}

std::vector<const DiagnosisCandidate*> named(const Diagnosis& diagnosis) {
  std::vector<const DiagnosisCandidate*> all;
  for (const DiagnosisCandidate& c : diagnosis.candidates)
    if (!c.id.empty() && !c.unnamed && !c.terms.empty()) all.push_back(&c);
  return all;
}

/// What the next poses should show: the two likeliest, and those that may be there.
void set_open_questions(Knowledge& known) {
  const std::vector<const DiagnosisCandidate*> all = named(*known.diagnosis);
  if (all.empty() || all[0]->ln_bayes_factor < worth_showing) return;
  known.likely = all[0]->terms;
  for (const DiagnosisCandidate* other : all)
    if (are_distinguished(*all[0], *other) && other->ln_bayes_factor > 0 &&
        all[0]->ln_bayes_factor - other->ln_bayes_factor < ln_20) {
      known.competing = CompetingEffects{all[0]->id, other->id, all[0]->terms, other->terms};
      return;
    }
}

/// The likeliest of what has no name; null: there is none.
const DiagnosisCandidate* likeliest_unnamed(const Diagnosis& diagnosis) {
  const auto unnamed = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                    [](const DiagnosisCandidate& c) { return c.unnamed.has_value(); });
  return unnamed == diagnosis.candidates.end() ? nullptr : &*unnamed;
}

/// Nothing and all named causes, in evidence of this candidate's.
double named_rivals_of(const DiagnosisCandidate& c, const Diagnosis& diagnosis) {
  double sum = std::exp(-c.ln_bayes_factor);
  for (const DiagnosisCandidate* other : named(diagnosis))
    if (are_distinguished(c, *other)) sum += std::exp(other->ln_bayes_factor - c.ln_bayes_factor);
  return sum;
}

double odds_against(double rivals) { return 1 / std::max(rivals, 1e-43); }

/// All that a named cause may be instead: of what has no name the likeliest counts, unless this is the name for it.
SettledCause settled_name(const DiagnosisCandidate& best, const Diagnosis& diagnosis) {
  double rivals = named_rivals_of(best, diagnosis);
  const DiagnosisCandidate* const unnamed = likeliest_unnamed(diagnosis);
  if (unnamed && !comes_before(best, *unnamed)) rivals += std::exp(unnamed->ln_bayes_factor - best.ln_bayes_factor);
  return {best.id, best.where, best.terms, odds_against(rivals)};
}

/// Where what has no name leads, and the likeliest name is none for it.
std::optional<SettledCause> settled_without_name(const std::vector<const DiagnosisCandidate*>& names,
                                                 const Diagnosis& diagnosis) {
  const DiagnosisCandidate* const unnamed = likeliest_unnamed(diagnosis);
  if (!unnamed || unnamed->ln_bayes_factor < diagnosis.threshold) return std::nullopt;
  if (!names.empty() && (names[0]->ln_bayes_factor >= unnamed->ln_bayes_factor || comes_before(*names[0], *unnamed)))
    return std::nullopt;
  return SettledCause{"", unnamed->where, unnamed->terms, odds_against(named_rivals_of(*unnamed, diagnosis)),
                      unnamed->unnamed->empirical_error.variable->name};
}

}  // namespace

SettledCause settled_cause(const Diagnosis& diagnosis) {
  const std::vector<const DiagnosisCandidate*> all = named(diagnosis);
  std::vector<double> of_visible;
  for (const DiagnosisCandidate* c : all)
    if (c->visibility >= least_visible) of_visible.push_back(c->ln_bayes_factor);
  if (diagnosis.verdict == Verdict::adequate) {
    // One of the causes that these poses can show, each as likely beforehand, against none.
    if (of_visible.empty()) return {};
    double mean = 0;
    for (const double f : of_visible) mean += std::exp(std::min(f, 700.0)) / static_cast<double>(of_visible.size());
    return {.odds = 1 / std::max(mean, 1e-9)};
  }
  if (const auto cause = settled_without_name(all, diagnosis)) return *cause;
  if (all.empty() || all[0]->ln_bayes_factor < diagnosis.threshold) return {};
  return settled_name(*all[0], diagnosis);
}

std::optional<double> hand_limit(const Fit& fit, const std::vector<Eigen::VectorXd>& poses) {
  if (poses.empty() || fit.solution.unobservable > 0) return std::nullopt;
  const Chain& own = fit.problem.source->chain;
  const bool exchanged = hand_carries_sensor(own);
  const std::optional<PredictionModel> model =
      exchanged ? model_of_hand(fit, {}) : std::optional(prediction_model(fit));
  if (!model) return std::nullopt;
  const Chain chain = exchanged ? chain_of_hand(own) : own;
  std::vector<double> limits;
  for (const Eigen::VectorXd& q : poses) {
    const Matrix6 covariance = predict_tcp(chain, q, *model).covariance;
    limits.push_back(length_limit(covariance.topLeftCorner<3, 3>(), probability));
  }
  const auto place = limits.begin() + static_cast<std::ptrdiff_t>(probability * static_cast<double>(limits.size() - 1));
  std::nth_element(limits.begin(), place, limits.end());
  return *place;
}

Knowledge assess_knowledge(const Session& session, const ExperimentModel& model, bool with_diagnosis,
                           const std::vector<Eigen::VectorXd>& poses) {
  Knowledge known;
  known.used =
      static_cast<std::size_t>(std::count_if(session.observations.begin(), session.observations.end(), is_used));
  try {
    known.fit = fit(session, {.effects = model.held, .estimated = model.estimated});
  } catch (const InputError&) {
    return known;  // an unknown mount that nothing determines yet, or nothing seen
  }
  known.hand_limit = hand_limit(*known.fit, poses);
  if (!with_diagnosis || known.used < least_to_diagnose) return known;
  DiagnosisOptions options;
  options.effects = model.held;
  options.estimated = model.estimated;
  options.with_held_out = false;
  options.with_regions = false;
  options.fewest = least_to_diagnose;
  known.diagnosis = diagnose(session, options);
  known.settled = settled_cause(*known.diagnosis);
  set_open_questions(known);
  return known;
}

}  // namespace handsight
