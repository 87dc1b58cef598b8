// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/verdict/candidate_report.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/evidence/lack_of_fit.h"
#include "diagnosis/verdict/stand_in.h"
#include "estimation/fit/noise.h"

namespace handsight {
namespace {

constexpr double least_excess = 60;  // chi-squared beyond the noise below which a share of it says nothing

std::vector<std::vector<double>> sigmas_of(const RankedEffect& r) {
  std::vector<std::vector<double>> sigmas;
  Eigen::Index i = 0;
  const Effect& effect = *r.candidate->effect;
  for (std::size_t unit = 0; unit < r.units.size(); ++unit) {
    sigmas.emplace_back(effect.parameters.size(), 0.0);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p)
      if (!effect.parameters[p].is_choice) {
        sigmas.back()[p] = std::sqrt(std::max(r.estimate.covariance(i, i), 0.0)) * r.candidate->sizes[p];
        ++i;
      }
  }
  return sigmas;
}

/// Of the candidate's numbers in their own units.
Eigen::MatrixXd make_covariance(const RankedEffect& r) {
  Eigen::VectorXd sizes(r.estimate.value.size());
  Eigen::Index i = 0;
  for (std::size_t unit = 0; unit < r.units.size(); ++unit)
    for (std::size_t p = 0; p < r.candidate->sizes.size(); ++p)
      if (!r.candidate->effect->parameters[p].is_choice) sizes[i++] = r.candidate->sizes[p];
  return sizes.asDiagonal() * r.estimate.covariance * sizes.asDiagonal();
}

bool are_too_large(const std::vector<EffectTerm>& terms, const Chain& chain) {
  return std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& t) { return is_too_large(t, chain); });
}

double p_of(double squares, int parameters) {
  if (!(squares > 0) || parameters <= 0) return 1;
  return chi_squared_tail(squares, parameters);
}

/// rms that is left once chi-squared falls by `gained`, at poses not fitted.
std::optional<double> predicted_held_out(const Fit& f, double noise, double gained, int parameters) {
  if (f.rows <= f.unknowns + parameters) return std::nullopt;
  const double squares =
      std::max(f.solution.normal.data_cost() - gained * noise * noise, 0.0) / (f.rows - f.unknowns - parameters);
  const double left = std::sqrt(squares * (1 + static_cast<double>(f.unknowns + parameters) / f.rows));
  return as_reported(left, f.problem.rig.has_value());
}

bool fails_by_much(const Diagnosis& d) {
  return d.excess && *d.excess > least_excess && d.lack_of_fit_p && *d.lack_of_fit_p < 1e-3;
}

}  // namespace

DiagnosisCandidate make_candidate(const RankedEffect& r, const Diagnosis& d, const NoiseModel& noise_model,
                                  const Session& session) {
  DiagnosisCandidate c;
  c.id = r.candidate->effect->id;
  c.terms = terms_with_values(r);
  c.sigmas = sigmas_of(r);
  c.covariance = make_covariance(r);
  c.where = list_places(c.terms, session);
  c.ln_bayes_factor = r.ln_bayes_factor;
  c.p_value = p_of(r.gained_squares, r.parameters);
  c.repeatability = r.repeatability;
  c.visibility = r.visibility;
  c.plausible = is_plausible(c.terms, d.model.fit.problem.source->chain);
  c.too_large = are_too_large(c.terms, d.model.fit.problem.source->chain);
  c.predicted_held_out = predicted_held_out(d.model.fit, noise_model.noise, r.gained_squares, r.parameters);
  if (fails_by_much(d)) c.explained = std::clamp((r.gained_squares - r.parameters) / *d.excess, 0.0, 1.0);
  return c;
}

DiagnosisCandidate make_candidate(const RankedEmpiricalError& l, const Session& session) {
  DiagnosisCandidate c;
  c.unnamed = l;
  c.ln_bayes_factor = l.ln_bayes_factor;
  c.repeatability = l.repeatability;
  if (l.empirical_error.variable->joint >= 0)
    c.where = {session.robot.joints[static_cast<std::size_t>(l.empirical_error.variable->joint)].name};
  return c;
}

void take_refit(const Refit& r, double ln_ways, const Diagnosis& d, const NoiseModel& noise_model,
                const Session& session, DiagnosisCandidate& c) {
  c.refitted = true;
  c.full_fit = r.options;
  c.terms.clear();
  c.sigmas.clear();
  const std::size_t first = r.fit.effects.size() - r.added;
  for (std::size_t t = first; t < r.fit.effects.size(); ++t) {
    c.terms.push_back(r.fit.effects[t].term);
    c.sigmas.push_back(r.fit.effects[t].sigmas);
  }
  const std::vector<EffectColumn>& columns = r.fit.problem.columns_of_effects;
  const auto added =
      std::count_if(columns.begin(), columns.end(), [&](const EffectColumn& e) { return e.term >= first; });
  c.covariance = r.fit.parameter_covariance.bottomRightCorner(added, added);
  c.where = list_places(c.terms, session);
  const Fit& before = d.model.fit;
  const double gained = (before.solution.normal.data_cost() - r.fit.solution.normal.data_cost()) /
                        (noise_model.noise * noise_model.noise);
  c.predicted_held_out = predicted_held_out(before, noise_model.noise, gained, r.fit.unknowns - before.unknowns);
  c.plausible = is_plausible(c.terms, d.model.fit.problem.source->chain);
  c.too_large = are_too_large(c.terms, d.model.fit.problem.source->chain);
  c.ln_bayes_factor = r.ln_bayes_factor - ln_ways;
  if (const auto left = lack_of_fit(r.fit); left && fails_by_much(d))
    c.explained = std::clamp(1 - left->excess() / *d.excess, 0.0, 1.0);
}

}  // namespace handsight
