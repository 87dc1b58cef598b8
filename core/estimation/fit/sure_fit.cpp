// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/sure_fit.h"

#include <algorithm>
#include <cmath>

#include "estimation/fit/fit_noise.h"
#include "estimation/fit/flange_error_size.h"
#include "estimation/fit/objectives.h"
#include "estimation/fit/prior_widths.h"
#include "estimation/problem/problem_part.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/start/effect_starts.h"
#include "estimation/start/multi_start.h"

namespace handsight {
namespace {

constexpr double refuted = 5;      // prior sigmas
constexpr double most_wide = 1e4;  // times

/// Takes the priors of a widened term back to a tenth where what is then found does not refute them: which width stands
/// must not depend on where the fit came from.
void narrow(const Session& session, Problem& images, const FitOptions& options, double noise, Fit& fit) {
  for (std::size_t t = 0; t < images.terms.size(); ++t)
    while (widened_by(images, t) > 1.5) {
      Problem tighter = images;
      for (EffectColumn& c : tighter.columns_of_effects)
        if (c.term == t) c.sigma /= 10;
      Fit again = fit;
      again.problem.columns_of_effects = tighter.columns_of_effects;
      minimise(session, tighter, fit.solution.unknowns, options, noise, again);
      Problem refuted_then = tighter;
      if (!again.solution.converged || widen_refuted(refuted_then, again.solution.unknowns.effects)) break;
      images = std::move(tighter);
      fit = std::move(again);
    }
}

/// For the answers between which widths and noise are settled: within a hundredth of a sigma is enough.
FitOptions for_widths(const FitOptions& options, const Problem& problem, const Solution& solution) {
  constexpr double little = 1e-4;  // of a residual's square
  const double usual =
      std::max(problem.noise * problem.noise, solution.normal.data_cost() / std::max(solution.normal.rows, 1));
  FitOptions near = options;
  near.reuse_below = std::max(options.reuse_below, 1e-3);
  near.least_gain = std::max(options.least_gain, little * usual);
  return near;
}

/// Widths and noise follow from the solution, and it from them: a few times in turn.
void settle_priors(const Session& session, Problem& images, const FitOptions& options, double noise, Fit& fit) {
  constexpr int most_rounds = 6;
  const FitOptions near = for_widths(options, images, fit.solution);
  const bool is_quick = options.least_gain > 0;
  bool is_another = false, is_circle = false;
  std::vector<Widths> before{list_widths(images)};
  for (int round = 0; round < most_rounds && !is_circle && fit.solution.converged && !fit.solution.stopped; ++round) {
    const bool other_noise =
        options.loss == Loss::none && settle_guessed_noise(images, fit.solution, finest_noise(session));
    const bool other_widths =
        is_quick ? take_widths_of_values(images, fit.solution) : settle_prior_widths(images, fit.solution);
    is_circle = !other_noise && other_widths && end_circle(before, images);
    fit.problem.noise = images.noise;
    fit.problem.columns_of_effects = images.columns_of_effects;
    if (!other_noise && !other_widths) break;
    minimise(session, images, Unknowns(fit.solution.unknowns), near, noise, fit);
    is_another = true;
  }
  if (is_another && !is_quick && !fit.solution.stopped)
    minimise(session, images, Unknowns(fit.solution.unknowns), options, noise, fit);
}

/// The noise of one coordinate beside the robot's own error, and the degrees of freedom that it was estimated from: 0
/// where it is declared.
struct KnownNoise {
  double sigma = 0;
  int degrees = 0;
};

std::optional<KnownNoise> noise_beside_the_robot(const Session& session, const Problem& images, const Fit& fit) {
  if (const auto& declared = declared_noise(session)) return KnownNoise{*declared, 0};
  const auto seen = estimate_noise(images, fit.solution.unknowns);
  return seen && seen->sigma > 0 ? std::optional(KnownNoise{seen->sigma, seen->degrees}) : std::nullopt;
}

/// A few poses tell the noise badly: then it takes more to be more than it.
bool leaves_noise_alone(const Fit& fit, const KnownNoise& noise) {
  constexpr double surely = 1e-3;  // p
  const NormalEquations& n = fit.solution.normal;
  const auto test = noise_test(n.data_cost() / (noise.sigma * noise.sigma),
                               n.rows - static_cast<double>(fit.solution.basis.cols()), noise.degrees);
  return !test || test->p > surely;
}

bool is_about(const FlangeError& a, const FlangeError& b) {
  constexpr double little = 0.02;
  const auto near = [](double x, double y) { return std::abs(x - y) <= little * std::max(x, y); };
  return near(a.place, b.place) && near(a.turn, b.turn);
}

/// How joints move the hand: filled where no effect has asked for it.
void fill_motions(Problem& problem) {
  if (problem.source->chain.robot.is_of_poses || problem.with_motions || problem.effect_count() > 0) return;
  problem.with_motions = true;
  place_observations(problem);
}

/// Squares of what the observations leave of every fifth of them that the fit has not seen, pixels counted alike.
double held_out_squares(const Fit& fit, const FitOptions& options, double noise) {
  constexpr int folds = 5, together = 4;  // as FitReport::held_out
  const auto fold_of = [](int rank) { return rank / together % folds; };
  FitOptions quick = options;
  quick.most_iterations = std::min(options.most_iterations, 40);
  quick.reuse_below = std::max(options.reuse_below, 1e-3);
  double squares = 0;
  for (int fold = 0; fold < folds; ++fold) {
    int rank = 0, held_rank = 0;
    const Problem part = take_part(fit.problem, [&](const ProblemObservation&) { return fold_of(rank++) != fold; });
    Problem held = take_part(fit.problem, [&](const ProblemObservation&) { return fold_of(held_rank++) == fold; });
    if (part.observations.empty() || held.observations.empty()) continue;
    const Unknowns u = refit(fit, quick, part, noise);
    held.flange_error = {};
    if (held.effect_count() > 0) set_effects(held, u.effects);
    squares += normal_equations(held, u).data_cost();
  }
  return squares;
}

/// Few poses with exact images may be fitted best by a place far from where the robot's error leads: what is left there
/// is no robot's. Then the size is asked for where a usual error is allowed for; nothing where none is found there
/// either.
std::optional<Fit> fit_of_a_usual_robot(const Session& session, Problem images, const FitOptions& options, double noise,
                                        const Fit& fit) {
  constexpr FlangeError usual{1e-3, 3e-3};
  Fit again = fit;
  images.flange_error = again.problem.flange_error = usual;
  minimise(session, images, Unknowns(fit.solution.unknowns), options, noise, again);
  if (!again.solution.converged || !likely_flange_error(again.problem, again.solution).is_any()) return std::nullopt;
  return again;
}

/// Where the hand is reported by a controller, it is part of the measurements and may be what errs: its error's size
/// follows from the solution, and the solution from it. Where noise alone is left nothing changes, nor where a robot
/// with joints predicts images worse with it: then what is left is no scatter, but follows what the model lacks.
void settle_flange_error(const Session& session, Problem& images, const FitOptions& options, double noise, Fit& fit) {
  constexpr int most_rounds = 6;
  // A fit that is asked for less than its exact answer is one step of a diagnosis, which asks what is missing first and
  // has a scatter of its own: an error that a missing cause makes must not pass for the robot's.
  constexpr double exact = 1e-12;
  if (options.smallest_step > exact) return;
  if (!session.rig || options.loss != Loss::none || !fit.solution.converged) return;
  const auto known = noise_beside_the_robot(session, images, fit);
  if (!known || (!images.flange_error.is_any() && leaves_noise_alone(fit, *known))) return;
  const double before = images.noise;
  const bool has_joints = !session.robot.is_of_poses;
  std::optional<Fit> plain;
  if (has_joints) plain = fit;
  images.noise = fit.problem.noise = known->sigma;
  fill_motions(fit.problem);
  fill_motions(images);
  for (int round = 0; round < most_rounds && fit.solution.converged && !fit.solution.stopped; ++round) {
    FlangeError likely = likely_flange_error(fit.problem, fit.solution);
    if (round == 0 && !likely.is_any() && !has_joints)
      if (auto usual = fit_of_a_usual_robot(session, images, options, noise, fit)) {
        fit = std::move(*usual);
        likely = likely_flange_error(fit.problem, fit.solution);
      }
    if (round == 0 && !likely.is_any() && has_joints) images.noise = fit.problem.noise = before;
    if (is_about(likely, images.flange_error)) break;
    images.flange_error = fit.problem.flange_error = likely;
    minimise(session, images, Unknowns(fit.solution.unknowns), options, noise, fit);
  }
  if (!has_joints || !images.flange_error.is_any()) return;
  if (held_out_squares(fit, options, noise) <= held_out_squares(*plain, options, noise)) return;
  const bool is_one = &images == &fit.problem;
  fit = *plain;
  if (!is_one) images.flange_error = {};
  images.noise = fit.problem.noise = before;
}

void minimise_widening(const Session& session, Problem& images, const Unknowns& start, const FitOptions& options,
                       double noise, Fit& fit) {
  const auto widened = [&](const Eigen::VectorXd& values) {
    const bool is_wider = widen_refuted(images, values);
    if (is_wider) fit.problem.columns_of_effects = images.columns_of_effects;
    return is_wider;
  };
  widened(start.effects);
  if (options.objective == Objective::image && start.effects.size() == images.effect_count()) {
    start_prior_widths(images, start.effects);
    fit.problem.columns_of_effects = images.columns_of_effects;
  }
  minimise(session, images, start, options, noise, fit);
  while (!fit.solution.stopped && widened(fit.solution.unknowns.effects))
    minimise(session, images, Unknowns(fit.solution.unknowns), options, noise, fit);
  if (options.objective == Objective::image) {
    if (session.robot.is_of_poses) settle_flange_error(session, images, options, noise, fit);
    settle_priors(session, images, options, noise, fit);
  }
  const bool is_quick = options.least_gain > 0;
  if (!is_quick && !fit.solution.stopped) narrow(session, images, options, noise, fit);
}

}  // namespace

double widened_by(const Problem& problem, std::size_t term) {
  for (const EffectColumn& c : problem.columns_of_effects)
    if (c.term == term)
      return c.sigma / prior_sigma(term_effect(problem.terms[term]).parameters[c.parameter], problem.source->chain);
  return 1;
}

bool widen_refuted(Problem& problem, const Eigen::VectorXd& values) {
  if (problem.cameras_by_effect.cols() != values.size()) return false;
  bool any = false;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const EffectColumn& refuting = problem.columns_of_effects[static_cast<std::size_t>(i)];
    if (problem.cameras_by_effect.col(i).isZero(0)) continue;
    while (std::abs(values[i]) > refuted * refuting.sigma && widened_by(problem, refuting.term) < most_wide) {
      for (EffectColumn& c : problem.columns_of_effects)
        if (c.term == refuting.term) c.sigma *= 10;
      any = true;
    }
  }
  return any;
}

namespace {

/// Does the model, at its minimum, leave so many times the noise's squares?
bool leaves_more_than_noise(const Problem& images, const Solution& s, double times) {
  return s.normal.data_cost() > times * s.normal.rows * images.noise * images.noise;
}

/// `until`: enough is enough once a solution is so.
void compete(const Session& session, Problem& images, const Unknowns& start, const FitOptions& options, double noise,
             const std::function<bool(const Problem&, const Solution&)>& until, Fit& fit) {
  for (const Unknowns& other : competing_starts(images, start)) {
    Fit again = fit;
    Problem wide = images;
    minimise_widening(session, wide, other, options, noise, again);
    const NormalEquations &now = again.solution.normal, &before = fit.solution.normal;
    const bool is_better =
        now.in_front > before.in_front || (now.in_front == before.in_front && now.data_cost() < before.data_cost());
    if (is_better) {
      fit = std::move(again);
      images = std::move(wide);
    }
    if (until(images, fit.solution) || fit.solution.stopped) return;
  }
}

/// From other sizes of the effects, where the minimum that was found does not explain the measurements.
void try_other_sizes(const Session& session, Problem& images, const FitOptions& options, double noise, Fit& fit) {
  const SolveOptions search{.fixed_body = fit.fixed_markers, .most_iterations = 40};
  const auto start = better_effects(fit.problem, fit.solution, search);
  if (!start) return;
  Fit again = fit;
  Problem there = images;
  minimise_widening(session, there, *start, options, noise, again);
  if (!again.solution.converged || !(again.solution.normal.cost < fit.solution.normal.cost)) return;
  fit = std::move(again);
  images = std::move(there);
}

}  // namespace

void minimise_surely(const Session& session, Problem& images, const Unknowns& start, const FitOptions& options,
                     double noise, Fit& fit) {
  minimise_widening(session, images, start, options, noise, fit);
  if (options.least_gain > 0 || options.objective != Objective::image) return;
  // What leaves more than twice the noise may have stopped in a minimum beside the best one. From an answer of another
  // model all starts have been looked at before.
  constexpr double twice = 4;  // in squares
  const auto is_enough = [](const Problem& p, const Solution& one) {
    return !looks_lost(p, one) && (p.noise_is_guessed || !leaves_more_than_noise(p, one, twice));
  };
  if (!options.start && !is_enough(images, fit.solution))
    compete(session, images, start, options, noise, is_enough, fit);
  constexpr double clearly = 2;
  const bool is_whole = options.reuse_below == 0 && options.loss == Loss::none && !fit.solution.stopped;
  if (is_whole && fit.problem.effect_count() > 0 && leaves_more_than_noise(images, fit.solution, clearly))
    try_other_sizes(session, images, options, noise, fit);
  if (is_no_answer(images, fit.solution)) fit.solution.converged = false;
  // A minimum beside the best one must not pass for a robot that errs: that is asked of the best alone.
  if (session.robot.is_of_poses) return;
  settle_flange_error(session, images, options, noise, fit);
  if (images.flange_error.is_any()) settle_priors(session, images, options, noise, fit);
}

bool has_no_answer(const Fit& fit) {
  if (!fit.solution.normal.in_front) return true;
  return fit.objective == Objective::image && is_no_answer(fit.problem, fit.solution);
}

}  // namespace handsight
