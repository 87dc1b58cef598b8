// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/judging.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/lack_of_fit.h"
#include "diagnosis/verdict/explanation.h"
#include "diagnosis/verdict/finding.h"
#include "estimation/solvers/inverse_parts.h"

namespace handsight {
namespace {

constexpr double surely = 1e-3;      // p-value of a lack of fit
constexpr double half = 0.5;         // of what the model misses
constexpr double clearly = 1.1;      // times: more than usual scatter leaves
constexpr double quite_sure = 1.65;  // sigmas, of one in twenty

void put_variable_first(const Variable& variable, Diagnosis& d) {
  std::stable_partition(d.patterns.begin(), d.patterns.end(), [&](const DiagnosisPattern& p) {
    return p.against.kind == variable.kind && p.against.joint == variable.joint;
  });
}

/// After the best named effect the model still fails, by more than half, and no further named effect would help.
bool explains_too_little(const DiagnosisCandidate& best, const std::map<std::string, Refit>& refits, double threshold) {
  const auto refit = refits.find(best.id);
  if (refit == refits.end() || !best.explained || *best.explained >= half) return false;
  const auto left = lack_of_fit(refit->second.fit);
  return left && left->p < surely && !further_effect_passes(refit->second, threshold);
}

}  // namespace

/// What the body's own shape and the cameras leave, whatever the robot does: with the shape that suits it best, for the
/// fit's has been bent to what the robot leaves.
static double squares_of_noise(const LinearModel& model) {
  const Eigen::Index error = model.internal.cols() - 1;
  const Eigen::MatrixXd information = model.internal.topLeftCorner(model.base, model.base);
  const Eigen::VectorXd gradient = model.internal.col(error).head(model.base);
  return model.internal(error, error) - gradient.dot(pseudo_inverse(information) * gradient);
}

static Repeatability usual_of(const Session& session) {
  return {session.repeatability.value_or(usual_repeatability.joints), usual_repeatability.place};
}

/// What the fit leaves, over what poses that were measured again leave; nothing where none were.
static std::optional<double> beyond_repeats(const Fit& fit) {
  const auto repeated = noise_from_repeats(fit.problem, estimate(fit));
  return repeated && repeated->sigma > 0 ? std::optional(fit.residual_rms / repeated->sigma) : std::nullopt;
}

double beyond_usual_repeatability(const Session& session, const Fit& fit, const LinearModel& model,
                                  const NoiseKnowledge& noise) {
  const Repeatability usual = usual_of(session);
  // The rows that the body's motions reach: of a board the others are many, and noise alone.
  const double outer =
      std::max(BaseEvidence(model, usual, noise).squares_with(model.prior) - squares_of_noise(model), 0.0);
  const auto degrees =
      static_cast<double>(std::max(model.external_error.size() - unknowns_of_motions(fit), Eigen::Index{1}));
  const double chance = 1 + quite_sure / std::sqrt(2 * degrees);
  const double beyond = std::sqrt(outer / degrees) / chance;
  return std::min(beyond, beyond_repeats(fit).value_or(beyond));
}

/// The joints that are worse, and the place, as bad as `most` and no worse.
static Repeatability at_most(Repeatability r, const Repeatability& most) {
  for (double& times : r.of_joint) times = std::min(times, most.joints / r.joints);
  if (r.of_joint.empty()) r.joints = std::min(r.joints, most.joints);
  r.place = std::min(r.place, most.place);
  return r;
}

double find_ln_against_usual_repeatability(const Session& session, const Fit& fit, const LinearModel& model,
                                           const NoiseKnowledge& noise, const Repeatability& best) {
  Repeatability usual = usual_of(session);
  usual.joints *= clearly;
  usual.place *= clearly;
  const Repeatability no_worse = at_most(best, usual);
  if (no_worse == best) return 0;
  if (beyond_repeats(fit).value_or(2 * clearly) <= clearly) return 0;
  const auto ln_evidence = [&](const Repeatability& r) { return ln_evidence_of_base(model, r, noise); };
  const double likeliest = std::max(
      {ln_evidence(usual), ln_evidence({usual.joints, 0}), ln_evidence({0, usual.place}), ln_evidence(no_worse)});
  return ln_evidence(best) - likeliest;
}

bool follows_a_pattern(const Diagnosis& d) {
  return !d.patterns.empty() && d.patterns.front().p_value < 1e-4 && d.patterns.front().strength > 0.2;
}

bool repeats_too_badly(const Diagnosis& d) {
  return (d.beyond_repeatability && *d.beyond_repeatability > clearly) || d.ln_against_usual_repeatability > ln_20;
}

void judge_what_is_left(bool knows_noise, Diagnosis& d) {
  if (!knows_noise) {
    d.verdict = Verdict::unexplained;
    d.reason = unknown_noise_text(d);
    return;
  }
  const bool fails = d.lack_of_fit_p && *d.lack_of_fit_p < surely;
  if (fails && follows_a_pattern(d)) {
    d.verdict = Verdict::unexplained;
    d.reason = follows_pattern_text(d.patterns.front());
    return;
  }
  if (fails && repeats_too_badly(d)) {
    d.verdict = Verdict::unexplained;
    d.reason = poor_repeatability_text(d);
    return;
  }
  d.verdict = Verdict::adequate;
  d.reason = adequate_text(d, fails);
}

void judge(const Session& session, bool knows_noise, const std::map<std::string, Refit>& refits, Diagnosis& d) {
  const auto first = [&](bool is_unnamed) {
    const auto found = std::find_if(d.candidates.begin(), d.candidates.end(),
                                    [&](const DiagnosisCandidate& c) { return c.unnamed.has_value() == is_unnamed; });
    return found == d.candidates.end() ? nullptr : &*found;
  };
  const DiagnosisCandidate *best = first(false), *unnamed = first(true);
  const bool unnamed_passes = unnamed && unnamed->ln_bayes_factor >= d.threshold;
  const bool has_a_name = unnamed && std::any_of(d.candidates.begin(), d.candidates.end(), [&](const auto& c) {
                            return c.ln_bayes_factor >= d.threshold && comes_before(c, *unnamed);
                          });
  if (unnamed_passes && !has_a_name && (!best || unnamed->ln_bayes_factor > best->ln_bayes_factor)) {
    d.verdict = Verdict::unexplained;
    d.reason = follows_unnamed_text(*unnamed, session);
    put_variable_first(*unnamed->unnamed->empirical_error.variable, d);
    return;
  }
  if (!best || best->ln_bayes_factor < d.threshold) return judge_what_is_left(knows_noise, d);
  if (explains_too_little(*best, refits, d.threshold)) {
    d.verdict = Verdict::unexplained;
    d.reason = too_little_text(*best, d);
    return;
  }
  const bool rival = std::any_of(d.candidates.begin(), d.candidates.end(), [&](const DiagnosisCandidate& c) {
    return !c.unnamed && &c != best && c.ln_bayes_factor > best->ln_bayes_factor - ln_20;
  });
  d.verdict = rival ? Verdict::ambiguous : Verdict::missing_effect;
  // The words name what every other place puts first: what a robot may have before what none is built like.
  const DiagnosisCandidate* reported = finding_of(d);
  if (!reported || reported->unnamed) reported = best;
  d.reason = missing_text(*reported, rival && reported == best, d);
}

}  // namespace handsight
