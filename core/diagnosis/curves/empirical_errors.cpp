// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/curves/empirical_errors.h"

#include <optional>

#include "base/threads.h"

namespace handsight {
namespace {

void consider(const WhitenedModel& w, const NoiseKnowledge& noise, const CurveSite& site, const CurveShape& shape,
              const Score& s, EmpiricalError& empirical_error, std::vector<double>& factors) {
  const double factor = ln_bayes_factor(s, w, noise);
  factors.push_back(factor);
  if (factors.size() > 1 && factor <= empirical_error.best.ln_bayes_factor) return;
  const LinearEstimate estimate = linear_estimate(s, w, noise);
  EmpiricalErrorTerm term{site.kind, site.joint, shape, factor, estimate.value};
  for (Eigen::Index i = 0; i < term.estimate.size(); ++i) term.estimate[i] *= site.sizes[i % site.sizes.size()];
  empirical_error.best = std::move(term);
}

/// Angles and torques act at their own joint, products at either's; time at every one. A line is a coupling: another
/// joint's deviation in proportion to this one's angle.
bool acts_there(const Variable& v, const CurveShape& shape, const CurveSite& site) {
  const bool at_joint = site.kind == EmpiricalErrorSite::joint;
  if (shape.family == ShapeFamily::line && v.kind == VariableKind::angle) return at_joint && site.joint != v.joint;
  if (!at_joint) return shape.at_rigid;
  if (!shape.at_joint) return false;
  return v.joint < 0 || site.joint == v.joint || shape.family == ShapeFamily::product;
}

/// Of every shape at every site, in their order; nothing where a shape does not act.
std::vector<std::vector<std::optional<Score>>> all_scores(const Variable& v, const WhitenedModel& w,
                                                          const std::vector<CurveSite>& sites,
                                                          const std::vector<CurveShape>& shapes) {
  std::vector<std::vector<std::optional<Score>>> all(shapes.size(), std::vector<std::optional<Score>>(sites.size()));
  for (std::size_t place = 0; place < sites.size(); ++place) {
    std::vector<const Eigen::MatrixXd*> values;
    std::vector<std::size_t> acting;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (!acts_there(v, shapes[i], sites[place])) continue;
      values.push_back(&shapes[i].values);
      acting.push_back(i);
    }
    std::vector<Score> scores = scores_at(w, sites[place], values);
    for (std::size_t k = 0; k < acting.size(); ++k) all[acting[k]][place] = std::move(scores[k]);
  }
  return all;
}

/// Nothing where the variable acts nowhere.
std::optional<EmpiricalError> localise_by(const Variable& v, const WhitenedModel& w, const NoiseKnowledge& noise,
                                          const std::vector<CurveSite>& sites, const std::vector<Variable>& variables) {
  EmpiricalError empirical_error{std::make_shared<Variable>(v), 0, {}};
  std::vector<CurveShape> shapes = list_shapes(v, variables);
  if (v.kind == VariableKind::angle) shapes.push_back(make_shape({&v}, ShapeFamily::line, 0));
  const auto scores = all_scores(v, w, sites, shapes);
  std::vector<double> factors;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t place = 0; place < sites.size(); ++place)
      if (scores[i][place]) consider(w, noise, sites[place], shapes[i], *scores[i][place], empirical_error, factors);
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
