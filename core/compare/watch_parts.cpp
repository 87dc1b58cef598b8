// SPDX-License-Identifier: Apache-2.0
#include "compare/watch_parts.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "compare/calibrated_sides.h"
#include "compare/change_evidence.h"
#include "compare/change_limits.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/evidence.h"
#include "session/without_observations.h"

namespace handsight {
namespace {

constexpr double same_pose = 5e-3;         // rad (m)
constexpr double least_coordinate = 0.25;  // half of the noise: what shape and lenses are off by, at least

double ln_weighed(const WatchParts::Start& s) { return s.ln_e_value + s.ln_weight; }

}  // namespace

PoseSums WatchParts::sums_of(const Session& session, const Observation& observation, Matrix6& repeatability) {
  Session one = without_observations(session);
  one.observations = {observation};
  one.observations[0].decision = Decision::none;
  one = as_calibrated(before, one);
  if (!chain) chain = make_chain(one);
  ComparedSides sides = make_sides(before, one, *chain);
  repeatability = sides.repeatability;
  const Eigen::Index effects = sides.after.problem.effect_count();
  if (units.empty()) {
    for (std::size_t m = 0; m < sides.after.problem.marker_is_seen.size(); ++m)
      sides.after.problem.marker_is_seen[m] = 1;
    units = change_units(sides.after.problem);
    for (const ChangeUnit& unit : units) groups.push_back(unit.group);
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    for (const ChangeUnit& unit : units)
      group_of_unit.push_back(
          static_cast<std::size_t>(std::lower_bound(groups.begin(), groups.end(), unit.group) - groups.begin()));
  }
  std::vector<EffectTerm> terms;
  for (const ChangeUnit& unit : units) terms.insert(terms.end(), unit.terms.begin(), unit.terms.end());
  sides.after.problem.tcp_from_slip = before.model.tcp_from_body;
  Candidates candidates = list_candidates(sides.after.problem, terms);
  Problem& problem = candidates.problem;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(problem.effect_count());
  values.head(effects) = sides.start.effects;
  set_effects(problem, values);
  const ChangeColumns columns{effects, nullptr, 0, problem.effect_count() - effects};
  SharedState state = make_start(sides);
  state.unknowns.effects = values;
  const ProblemObservation& o = problem.observations.front();
  const SingleRows single = single_rows(problem, o, state, columns, sides.after.weight);
  if (first_of_unit.empty()) {
    base = single.by_columns.cols() - columns.changes;
    known = *sides.known;
    sizes.resize(columns.changes);
    for (Eigen::Index c = 0; c < sizes.size(); ++c)
      sizes[c] = problem.columns_of_effects[static_cast<std::size_t>(effects + c)].sigma;
    Eigen::Index next = base;
    for (const ChangeUnit& unit : units) {
      first_of_unit.push_back(next);
      for (const EffectTerm& t : unit.terms)
        for (const EffectParameter& p : term_effect(t).parameters) next += p.is_choice ? 0 : 1;
    }
    first_of_unit.push_back(next);
    check(next == single.by_columns.cols(), "{} columns of changes, {} of their numbers", columns.changes, next - base);
    const double left = before.calibration.fit.chi2_per_dof.value_or(1) - 1;
    coordinate = std::max(least_coordinate, left);
  }
  return sums_of_rows(o, single, problem.rig ? 2 * problem.rig->count() : 3, problem.marker_count);
}

std::size_t WatchParts::locate(const Eigen::VectorXd& position, const Matrix6& repeatability) {
  for (std::size_t p = 0; p < poses.size(); ++p)
    if ((poses[p].position - position).cwiseAbs().maxCoeff() < same_pose) return p;
  poses.push_back({position, repeatability, {}, {}});
  return poses.size() - 1;
}

/// Of the poses only that of the new observation says anything else than before it.
void WatchParts::keep(Recent observation) {
  const std::size_t place = observation.pose;
  WatchedPose& pose = poses[place];
  pose.unchanged.add(observation.sums.unchanged(base));
  pose.changed.add(observation.sums);
  recent.push_back(std::move(observation));
  if (recent.size() > options.window) recent.pop_front();
  const auto settle = [&](const PoseSums& sums) { return without_pose(sums, coordinate, pose.repeatability); };
  const auto settle_in = [](Normal& total, Normal& kept, Normal now) {
    total.replace(kept, now);
    kept = std::move(now);
  };
  settle_in(without_change, pose.without_change, settle(pose.unchanged));
  settle_in(from_first, pose.with_change, settle(pose.changed));
  PoseSums sums = pose.unchanged;
  for (std::size_t i = recent.size(); i-- > 0;) {
    if (recent[i].pose != place) continue;
    sums.add_changes(recent[i].sums, base);
    recent[i].of_pose = settle(sums);
  }
}

/// By group, the mean over its places, with what it is likely beforehand.
std::vector<double> WatchParts::by_group(const std::vector<double>& evidence) const {
  std::vector<double> ln_of, own;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    own.clear();
    for (std::size_t u = 0; u < units.size(); ++u)
      if (group_of_unit[u] == g) own.push_back(evidence[u]);
    ln_of.push_back(ln_mean_exp(own) + ln_prior_odds(groups[g]));
  }
  return ln_of;
}

/// The mean over the groups.
double WatchParts::mixture(const std::vector<double>& evidence) const {
  double weights = 0;
  for (const std::string& group : groups) weights += std::exp(ln_prior_odds(group));
  return ln_mean_exp(by_group(evidence)) + std::log(static_cast<double>(groups.size()) / weights);
}

WatchParts::Start WatchParts::start_at(double ln_weight, const Normal& n, const Shared& shared) const {
  const Eigen::Index changes = n.gradient.size() - base;
  const Eigen::MatrixXd cross = shared.information.matrixL().solve(n.information.topRightCorner(base, changes));
  Start start;
  start.ln_weight = ln_weight;
  start.gradient = n.gradient.tail(changes) - cross.transpose() * shared.gradient;
  for (std::size_t u = 0; u < units.size(); ++u) {
    const Eigen::Index first = first_of_unit[u] - base, numbers = first_of_unit[u + 1] - first_of_unit[u];
    const auto own_cross = cross.middleCols(first, numbers);
    Eigen::MatrixXd own = n.information.block(base + first, base + first, numbers, numbers);
    own -= own_cross.transpose().lazyProduct(own_cross);
    start.evidence.push_back(change_evidence(own, start.gradient.segment(first, numbers)));
    start.information.push_back(std::move(own));
  }
  start.ln_e_value = mixture(start.evidence);
  return start;
}

std::vector<WatchParts::Start> WatchParts::starts() const {
  std::vector<const Normal*> of_poses;
  for (const WatchedPose& p : poses) of_poses.push_back(&p.without_change);
  Normal total = without_change;
  Shared shared{Eigen::LLT<Eigen::MatrixXd>(total.information.topLeftCorner(base, base) + known), {}};
  shared.gradient = shared.information.matrixL().solve(total.gradient.head(base));
  std::vector<Start> all;
  for (std::size_t i = recent.size(); i-- > 0;) {
    const Recent& r = recent[i];
    total.replace(*of_poses[r.pose], r.of_pose);
    of_poses[r.pose] = &r.of_pose;
    all.push_back(start_at(r.ln_weight, total, shared));
  }
  if (recent.front().number > 0) all.push_back(start_at(ln_first_weight, from_first, shared));
  return all;
}

double WatchParts::ln_e_value(const std::vector<Start>& all) {
  std::vector<double> weighed;
  for (const Start& s : all) weighed.push_back(ln_weighed(s));
  return ln_mean_exp(weighed) + std::log(static_cast<double>(weighed.size()));
}

/// Its numbers and their sigmas, each held at three prior sigmas.
WatchedChange WatchParts::measure_size(std::size_t unit, const Start& start) const {
  const Eigen::Index first = first_of_unit[unit] - base, numbers = first_of_unit[unit + 1] - first_of_unit[unit];
  Eigen::MatrixXd information = start.information[unit];
  information.diagonal().array() += 1 / (change_scale * change_scale);
  const Eigen::MatrixXd covariance = information.ldlt().solve(Eigen::MatrixXd::Identity(numbers, numbers));
  const Eigen::VectorXd size = sizes.segment(first, numbers);
  const Eigen::VectorXd values = size.cwiseProduct(covariance * start.gradient.segment(first, numbers));
  WatchedChange change{units[unit].group, units[unit].where, units[unit].terms,
                       size.cwiseProduct(covariance.diagonal().cwiseMax(0).cwiseSqrt())};
  Eigen::Index next = 0;
  for (EffectTerm& term : change.terms)
    for (std::size_t p = 0; p < term.values.size(); ++p)
      if (!term_effect(term).parameters[p].is_choice) term.values[p] = values[next++];
  return change;
}

WatchStep WatchParts::reported(const std::vector<Start>& all) const {
  WatchStep step;
  step.ln_e_value = ln_e_value(all);
  const Start& start = *std::max_element(all.begin(), all.end(),
                                         [](const Start& a, const Start& b) { return ln_weighed(a) < ln_weighed(b); });
  const std::vector<double> ln_of = by_group(start.evidence);
  const auto likeliest = static_cast<std::size_t>(std::max_element(ln_of.begin(), ln_of.end()) - ln_of.begin());
  step.what = groups[likeliest];
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (g != likeliest && ln_of[g] > ln_of[likeliest] - ln_20) step.indistinguishable_from.push_back(groups[g]);
  std::size_t unit = units.size();
  for (std::size_t u = 0; u < units.size(); ++u)
    if (units[u].group == step.what && (unit == units.size() || start.evidence[u] > start.evidence[unit])) unit = u;
  for (std::size_t u = 0; u < units.size(); ++u) step.each.push_back(measure_size(u, start));
  step.terms = step.each[unit].terms;
  step.sigma = step.each[unit].sigma;
  step.where = units[unit].where;
  step.text = change_text(units[unit], step.terms, step.sigma, *chain);
  if (!step.indistinguishable_from.empty() && step.ln_e_value > 0)
    step.text +=
        message("; or it is {}, which these poses do not tell apart.", fmt::join(step.indistinguishable_from, " or "));
  return step;
}

}  // namespace handsight
