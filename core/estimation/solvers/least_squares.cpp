// SPDX-License-Identifier: Apache-2.0
#include "estimation/solvers/least_squares.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "estimation/solvers/bent_valley.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/learned_step.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/solvers/unknown_steps.h"

namespace handsight {

namespace {

constexpr double roughness = 1e-11;       // of a cost: equilibria are exact to 1e-11 rad
constexpr double as_exact = 1e-10;        // m, rad: so small a step that is not judged is what equilibria are rough by
constexpr double still_quick = 0.3;       // of what the step before promised
constexpr double trusted_damping = 1e-5;  // up to it steps go nearly as far as those that are not damped

/// Directions that the information does not determine. Where its factors are far from singular there are none, which
/// takes a tenth of the time to see.
int unobservable_in(const Eigen::MatrixXd& h) {
  constexpr double far_from_singular = 1e-6;  // six powers of ten above what counts as singular
  const Eigen::VectorXd scale = inverse_scale(h);
  if (scale.size() > 0 && scale.minCoeff() > 0) {
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(scale.asDiagonal() * h * scale.asDiagonal());
    if (ldlt.info() == Eigen::Success && ldlt.vectorD().minCoeff() > far_from_singular) return 0;
  }
  int left_out = 0;
  pseudo_inverse(h, &left_out);
  return left_out;
}

/// The longest part of a step: m and rad as they are, an effect's number in thousandths of its prior sigma.
double measure_size(const Problem& problem, const Eigen::VectorXd& step) {
  const Eigen::Index rest = step.size() - problem.effect_count();
  double size = rest > 0 ? step.head(rest).cwiseAbs().maxCoeff() : 0.0;
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i)
    size =
        std::max(size, 1e-3 * std::abs(step[rest + i]) / problem.columns_of_effects[static_cast<std::size_t>(i)].sigma);
  return size;
}

/// What a step must promise to be worth it. An answer that is not asked for exactly is good enough within a thousandth
/// of its sigma; below, the cost is as rough as the equilibria of the springs are exact.
double least_gain(const Problem& problem, const NormalEquations& normal, const SolveOptions& options) {
  constexpr double next_to_nothing = 1e-6;  // of a residual's square
  if (options.reuse_below == 0 || normal.rows == 0) return options.least_gain;
  const double usual = std::max(problem.noise * problem.noise, normal.data_cost() / normal.rows);
  return std::max(options.least_gain, next_to_nothing * usual);
}

}  // namespace

Solution solve(const Problem& original, const Unknowns& start, const SolveOptions& options) {
  const bool has_effects = original.effect_count() > 0;
  Problem own;  // only a robust loss and moving effects need their own copy
  if (options.loss != Loss::none || has_effects) own = original;
  auto normal_at = [&](const Unknowns& u, bool derives) {
    if (has_effects && u.effects != effect_values(own))
      derives ? set_effects(own, u.effects) : follow_effects(own, u.effects);
    if (options.loss != Loss::none) return weighted_normal_equations(own, u, options.loss, options.noise);
    return normal_equations(has_effects ? own : original, u);
  };

  Solution solution;
  solution.unknowns = start;
  if (start.effects.size() != original.effect_count()) solution.unknowns.effects = effect_values(original);
  solution.normal = normal_at(solution.unknowns, true);
  solution.start_cost = solution.normal.cost;
  const bool can_start = std::isfinite(solution.start_cost);
  double damping = 1e-8;
  LearnedStep learned;
  bool was_refused = false;
  double last_slope = std::numeric_limits<double>::infinity();
  int patience = 0, wait = 0;  // steps that are taken before a longer one is tried
  while (can_start && solution.iterations < options.most_iterations && !solution.converged && !solution.stopped) {
    ++solution.iterations;
    solution.basis = step_basis(original, solution.unknowns, options.fixed_body);
    const Eigen::MatrixXd information = by_steps(solution.normal.information, solution.basis, options.fixed_body);
    const Eigen::VectorXd gradient = gradient_by_steps(solution.normal, solution.basis, options.fixed_body);
    const Eigen::VectorXd step = learned.next(damped_step(information, gradient, damping), information, gradient);
    const double slope = gradient.dot(step);
    Unknowns next = stepped(original, solution.unknowns, step, options.fixed_body);
    const double size = measure_size(original, step);
    // The derivatives that are at hand after a refused step are those of where it led; where steps hardly become
    // shorter, those of before are what holds them up.
    const bool derives = was_refused || slope > still_quick * last_slope || size >= options.reuse_below;
    NormalEquations normal = normal_at(next, derives);
    // A step that promises less than the cost is rough by cannot be judged by it.
    const double rough = roughness * solution.normal.cost;
    const bool is_judged = !(slope < rough);
    const bool led_on = derives && is_judged && normal.cost > solution.normal.cost &&
                        lead_to_floor(original, {step, slope, solution.normal.cost, damping, options.fixed_body},
                                      normal_at, next, normal);
    // Steps at the level of rounding can neither lower the cost nor matter: m and rad alike, against 1.
    const bool gains_nothing =
        slope < least_gain(original, solution.normal, options) * std::min(1.0, trusted_damping / damping);
    const bool shortens = slope < still_quick * last_slope;  // as long as they do, those that are not judged are taken
    const bool rounding =
        size < options.smallest_step || gains_nothing || !(is_judged || (shortens && size > as_exact));
    const bool better = std::isfinite(normal.cost) && normal.cost <= solution.normal.cost + (is_judged ? 0.0 : rough);
    const double kept_promise = (solution.normal.cost - normal.cost) / std::max(slope, 1e-300);
    const bool accepted = !was_refused;
    const double damping_before = damping;
    was_refused = !better;
    if (better || rounding) {
      if (better) {
        solution.unknowns = next;
        solution.normal = std::move(normal);
      }
      // What bends is not trusted farther at once, and ever later where that was refused: else every other step is.
      if (is_judged && kept_promise > 0.75 && --wait < 0) damping = std::max(damping * 0.1, 1e-15);
      if (is_judged && kept_promise < 0.1) damping *= 3;
      const bool is_another_step = damping != damping_before && std::max(damping, damping_before) > trusted_damping;
      learned.took(step, !is_judged || kept_promise > 0.75);
      if (led_on || is_another_step) learned.forget();
      last_slope = slope;
      solution.converged = rounding;
      if (options.on_iteration && !options.on_iteration(solution.iterations, solution.normal.cost, solution.unknowns))
        solution.stopped = true;
    } else if (learned.has_learned()) {
      learned.refused();
    } else {
      // Near the bottom the cost cannot be distinguished from rounding: a step that gains less than that is the end.
      if (size < 1e-9 && slope < 1e-13 * (solution.normal.cost + 1e-300)) solution.converged = true;
      damping = std::max(damping * 10, 1e-6);
      if (damping > 1e12) break;
      if (accepted) patience = std::max(1, 2 * patience);
      wait = patience;
    }
  }
  if (!solution.normal.in_front) solution.converged = false;
  solution.basis = step_basis(original, solution.unknowns, options.fixed_body);
  solution.unobservable = unobservable_in(by_steps(solution.normal.information, solution.basis, options.fixed_body));
  return solution;
}

Eigen::MatrixXd unit_covariance(const Solution& s) {
  return s.basis * pseudo_inverse(s.basis.transpose() * s.normal.information * s.basis) * s.basis.transpose();
}

}  // namespace handsight
