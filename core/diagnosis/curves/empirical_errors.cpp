// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/curves/empirical_errors.h"

#include <optional>

#include "base/threads.h"

namespace handsight {
namespace {

void consider(const WhitenedModel& w, const NoiseKnowledge& noise, const CurveSite& site, const CurveShape& shape,
              EmpiricalError& empirical_error, std::vector<double>& factors) {
  const Score s = score_at(w, site, shape.values);
  const double factor = ln_bayes_factor(s, w, noise);
  factors.push_back(factor);
  if (factors.size() > 1 && factor <= empirical_error.best.ln_bayes_factor) return;
  const LinearEstimate estimate = linear_estimate(s, w, noise);
  EmpiricalErrorTerm term{site.kind, site.joint, shape, factor, estimate.value};
  for (Eigen::Index i = 0; i < term.estimate.size(); ++i) term.estimate[i] *= site.sizes[i % site.sizes.size()];
  empirical_error.best = std::move(term);
}

/// Angles and torques act at their own joint, products at either's; time at every one.
bool acts_there(const Variable& v, const CurveShape& shape, const CurveSite& site) {
  if (site.kind != EmpiricalErrorSite::joint) return shape.at_rigid;
  if (!shape.at_joint) return false;
  return v.joint < 0 || site.joint == v.joint || shape.family == ShapeFamily::product;
}

/// Nothing where the variable acts nowhere.
std::optional<EmpiricalError> localise_by(const Variable& v, const WhitenedModel& w, const NoiseKnowledge& noise,
                                          const std::vector<CurveSite>& sites, const std::vector<Variable>& variables) {
  EmpiricalError empirical_error{std::make_shared<Variable>(v), 0, {}};
  std::vector<double> factors;
  for (const CurveShape& shape : list_shapes(v, variables))
    for (const CurveSite& site : sites)
      if (acts_there(v, shape, site)) consider(w, noise, site, shape, empirical_error, factors);
  if (v.kind == VariableKind::angle) {  // a coupling: another joint's deviation in proportion to this one's angle
    const CurveShape line = make_shape({&v}, ShapeFamily::line, 0);
    for (const CurveSite& site : sites)
      if (site.kind == EmpiricalErrorSite::joint && site.joint != v.joint)
        consider(w, noise, site, line, empirical_error, factors);
  }
  if (factors.empty()) return std::nullopt;
  empirical_error.ln_bayes_factor = ln_mean_exp(factors);
  return empirical_error;
}

}  // namespace

std::vector<EmpiricalError> localise(const WhitenedModel& w, const NoiseKnowledge& noise, const Problem& problem,
                                     const std::vector<Variable>& variables) {
  const std::vector<CurveSite> sites = curve_sites(w, problem);
  std::vector<std::optional<EmpiricalError>> found(variables.size());
  each_part(static_cast<int>(variables.size()), true, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    found[at] = localise_by(variables[at], w, noise, sites, variables);
  });
  std::vector<EmpiricalError> empirical_errors;
  for (std::optional<EmpiricalError>& one : found)
    if (one) empirical_errors.push_back(std::move(*one));
  return empirical_errors;
}

}  // namespace handsight
