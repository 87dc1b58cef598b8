// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/prior_widths.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "estimation/problem/robot_scale.h"

namespace handsight {
namespace {

struct Width {
  double times, share;  // of the prior sigma; of the prior
};
constexpr std::array<Width, 3> widths{{{1, 0.7}, {5, 0.2}, {25, 0.1}}};
constexpr double shows = 0.05;        // sigmas
constexpr double unremarkable = 0.5;  // prior sigmas: no width but the first is likelier

/// What the measurements say of a number without its own prior.
struct Told {
  double value = 0, variance = 0;
};

double ln_evidence(const Told& reported, double plausible, const Width& width) {
  const double variance = std::pow(width.times * plausible, 2) + reported.variance;
  return std::log(width.share) - 0.5 * std::log(variance) - 0.5 * reported.value * reported.value / variance;
}

double likeliest_width(const Told& reported, double plausible, double most) {
  const auto worth = [&](const Width& w) { return w.times > most ? -1e300 : ln_evidence(reported, plausible, w); };
  return std::ranges::max_element(widths, {}, worth)->times;
}

/// Where the robot alone tells a length, one of its lengths may not make up for all others: nothing would contradict
/// it.
double most_width(const Problem& problem, Eigen::Index effect) {
  constexpr double most_of_a_length = 5;
  return holds_robot_scale(problem) && problem.robot_scale->by_effect[effect] != 0 ? most_of_a_length : 1e300;
}

/// By how much more than noise the fit leaves, in squares; 1 at least. A model that lacks something is no sharper than
/// what it leaves: else numbers that only together determine something would wander apart after it.
double misfit(const Problem& problem, const Solution& solution) {
  const auto degrees = static_cast<double>(solution.normal.rows) - static_cast<double>(solution.basis.cols());
  return degrees < 1 ? 1 : std::max(1.0, solution.normal.data_cost() / (problem.noise * problem.noise * degrees));
}

/// The posterior without the prior: precisions add up. Nothing where the measurements tell nothing.
std::optional<Told> told_by_measurements(double value, double variance, double prior_sigma, double misfit) {
  constexpr double all_but_all = 1 - 1e-6;
  const double prior = 1 / (prior_sigma * prior_sigma);
  if (!(variance > 0) || prior * variance > all_but_all) return std::nullopt;
  const double precision = 1 / variance - prior;
  return Told{value / variance / precision, misfit / precision};
}

bool is_of_cameras(const Problem& problem, Eigen::Index effect) {
  return problem.cameras_by_effect.cols() == problem.effect_count() && !problem.cameras_by_effect.col(effect).isZero(0);
}

bool is_remarkable(const Problem& problem, const Eigen::VectorXd& values, Eigen::Index i) {
  const EffectColumn& c = problem.columns_of_effects[static_cast<std::size_t>(i)];
  return c.width != 1 || std::abs(values[i]) > unremarkable * c.sigma;
}

}  // namespace

void start_prior_widths(Problem& problem, const Eigen::VectorXd& values) {
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i) {
    EffectColumn& c = problem.columns_of_effects[static_cast<std::size_t>(i)];
    if (!is_of_cameras(problem, i)) c.width = likeliest_width({values[i], 0}, c.sigma, most_width(problem, i));
  }
}

bool settle_prior_widths(Problem& problem, const Solution& solution) {
  const Eigen::VectorXd& values = solution.unknowns.effects;
  bool any = false;
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i)
    any = any || (!is_of_cameras(problem, i) && is_remarkable(problem, values, i));
  if (!any) return false;
  const Eigen::MatrixXd covariance = problem.noise * problem.noise * unit_covariance(solution);
  const double more = misfit(problem, solution);
  bool is_new = false;
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i) {
    if (is_of_cameras(problem, i)) continue;
    EffectColumn& c = problem.columns_of_effects[static_cast<std::size_t>(i)];
    const Eigen::Index at = problem.effect_column() + i;
    const auto reported = told_by_measurements(values[i], covariance(at, at), c.prior_sigma(), more);
    const double width = reported ? likeliest_width(*reported, c.sigma, most_width(problem, i)) : 1;
    const double before = std::pow(c.prior_sigma(), -2);
    c.width = width;
    // By how much the prior's pull changes where the number is, in its sigmas.
    const double moved = std::sqrt(std::max(covariance(at, at), 0.0)) * std::abs(values[i]) *
                         std::abs(std::pow(c.prior_sigma(), -2) - before);
    is_new = is_new || moved > shows;
  }
  return is_new;
}

bool take_widths_of_values(Problem& problem, const Solution& solution) {
  const Widths before = list_widths(problem);
  start_prior_widths(problem, solution.unknowns.effects);
  return list_widths(problem) != before;
}

Widths list_widths(const Problem& problem) {
  Widths all;
  for (const EffectColumn& c : problem.columns_of_effects) all.push_back(c.width);
  return all;
}

bool end_circle(std::vector<Widths>& before, Problem& problem) {
  const Widths now = list_widths(problem);
  const auto same = std::find(before.begin(), before.end(), now);
  if (same == before.end()) {
    before.push_back(now);
    return false;
  }
  for (auto seen = same; seen != before.end(); ++seen)
    for (std::size_t c = 0; c < now.size(); ++c)
      problem.columns_of_effects[c].width = std::max(problem.columns_of_effects[c].width, (*seen)[c]);
  return true;
}

bool settle_guessed_noise(Problem& problem, const Solution& solution, double finest) {
  constexpr double few_per_cent = 0.05;
  const auto degrees = static_cast<double>(solution.normal.rows) - static_cast<double>(solution.basis.cols());
  if (!problem.noise_is_guessed || degrees < 1) return false;
  const double left = std::max(std::sqrt(solution.normal.data_cost() / degrees), finest);
  const bool is_new = std::abs(left - problem.noise) > few_per_cent * problem.noise;
  if (is_new) problem.noise = left;
  return is_new;
}

}  // namespace handsight
