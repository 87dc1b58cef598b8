// SPDX-License-Identifier: Apache-2.0
#include "estimation/report/fit_report.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "base/median.h"
#include "base/threads.h"
#include "estimation/fit/noise.h"
#include "estimation/fit/objectives.h"
#include "estimation/fit/touch_counts.h"
#include "estimation/problem/body_pose.h"
#include "estimation/problem/pose_residuals.h"
#include "estimation/problem/problem_part.h"
#include "estimation/report/regions.h"
#include "estimation/report/residuals.h"
#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/normal_equations.h"
#include "estimation/start/shape_start.h"

namespace handsight {
namespace {

/// `in_part` has one entry an observation of the session.
Problem take_part(const Problem& whole, const std::vector<char>& in_part) {
  return take_part(whole, [&](const ProblemObservation& o) { return in_part[static_cast<std::size_t>(o.index)] != 0; });
}

/// How long a step of the unknowns is: m and rad as they are, an effect's number in thousandths of its prior sigma.
double measure_size(const Problem& problem, const Eigen::VectorXd& step) {
  double size = step.head(problem.effect_column()).cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < problem.effect_count(); ++i)
    size = std::max(size, 1e-3 * std::abs(step[problem.effect_column() + i]) /
                              problem.columns_of_effects[static_cast<std::size_t>(i)].sigma);
  return size;
}

/// The answer on a part of a fit's observations by steps of Gauss and Newton from the whole fit's; nothing where they
/// do not lead there.
std::optional<Unknowns> nearby_estimate(const Fit& fit, const std::vector<char>& trains) {
  constexpr double near = 5e-4;  // a first step that short needs no second one
  constexpr double settled = 1e-6;
  constexpr int most_steps = 16;
  const double little = 1e-3 * fit.residual_rms * fit.residual_rms;  // of the squares: no residual shows it
  Problem part = take_part(fit.problem, trains);
  Unknowns unknowns = estimate(fit);
  NormalEquations normal = normal_equations(part, unknowns);
  const double first_cost = normal.cost;
  double last = 0;
  for (int i = 0; i < most_steps; ++i) {
    const Eigen::VectorXd step = pseudo_inverse(normal.information) * normal.gradient;
    const double size = measure_size(part, step), gain = normal.gradient.dot(step);
    // The first step may go too far, where little is seen; those after it lead back.
    if (i > 1 && (gain > 0.9 * last || normal.cost > first_cost)) return std::nullopt;
    unknowns = moved(part, unknowns, step);
    if (size < settled || gain < little || (i == 0 && size < near)) return unknowns;
    last = gain;
    follow_effects(part, unknowns.effects);
    normal = normal_equations(part, unknowns);
  }
  return std::nullopt;
}

/// The fit's own answer on a part of its observations.
Unknowns part_estimate(const Fit& fit, const FitOptions& options, const std::vector<char>& trains) {
  const bool is_plain = fit.objective == Objective::image && !fit.fixed_markers && options.loss == Loss::none;
  if (is_plain && fit.problem.effect_count() > 0)
    if (const auto nearby = nearby_estimate(fit, trains)) return *nearby;
  FitOptions fold_options = options;
  // Effects are followed to a ten-thousandth of their prior sigma: far below what a fold shows of them.
  if (fit.problem.effect_count() > 0) {
    fold_options.smallest_step = std::max(options.smallest_step, 1e-7);
    fold_options.reuse_below = std::max(options.reuse_below, 1e-4);
  }
  return refit(fit, fold_options, take_part(fit.problem, trains), fit.noise.value_or(1));
}

/// Whoever is asked whether a fit may go on is asked by one thread at a time.
FitOptions asked_one_by_one(FitOptions options) {
  if (options.on_iteration)
    options.on_iteration = [ask = options.on_iteration, one = std::make_shared<std::mutex>()](
                               int iteration, double cost, const Unknowns& unknowns) {
      const std::scoped_lock lock(*one);
      return ask(iteration, cost, unknowns);
    };
  return options;
}

/// What every used observation leaves when its fold is left out of the fit, fold by fold; `folds` has one number an
/// observation, in the order of the problem. Nothing where its fold is all of them.
std::vector<std::optional<Residuals>> held_out_residuals(const Problem& images, const Fit& fit, const FitOptions& asked,
                                                         std::size_t session_size, const std::vector<int>& folds) {
  std::vector<std::optional<Residuals>> all(images.observations.size());
  const int last = folds.empty() ? -1 : *std::max_element(folds.begin(), folds.end());
  const FitOptions options = asked_one_by_one(asked);
  constexpr std::size_t most_at_once = 10'000;  // observations: of longer sessions every copy counts
  const bool at_once = fit.problem.effect_count() > 0 && images.observations.size() <= most_at_once;
  each_part(last + 1, at_once, [&](int fold) {
    std::vector<char> trains(session_size, 0);
    std::vector<std::size_t> held_ranks;
    for (std::size_t rank = 0; rank < images.observations.size(); ++rank) {
      const bool held = folds[rank] == fold;
      trains[static_cast<std::size_t>(images.observations[rank].index)] = held ? 0 : 1;
      if (held) held_ranks.push_back(rank);
    }
    if (held_ranks.empty() || held_ranks.size() == images.observations.size()) return;
    const Unknowns unknowns = part_estimate(fit, options, trains);
    for (char& train : trains) train = !train;
    Problem held = take_part(images, trains);
    if (held.effect_count() > 0) {
      set_effect_values(held, unknowns.effects);
      hold_effects(held);  // residuals need no derivatives
      place_observations(held);
    }
    std::size_t i = 0;
    for (const ProblemObservation& o : held.observations) {
      if (!trains[static_cast<std::size_t>(o.index)]) continue;
      all[held_ranks[i++]] = compute_residuals(held, o, unknowns);
    }
  });
  return all;
}

std::vector<Residuals> assess_knowledge(const std::vector<std::optional<Residuals>>& all) {
  std::vector<Residuals> known;
  for (const std::optional<Residuals>& one : all)
    if (one) known.push_back(*one);
  return known;
}

ErrorSummary read_summary(const std::vector<std::optional<Residuals>>& all, bool pixels) {
  const std::vector<Residuals> known = assess_knowledge(all);
  return known.empty() ? ErrorSummary{} : summary(known, pixels);
}

/// Of touches: takes out what the others could not have told, because too few of them are left for the fixture's place
/// or the tip's. The fit leaves both where they were then, and it would look as though they had been predicted.
void take_out_untold(const Session& session, const Problem& images, const std::vector<int>& folds,
                     std::vector<std::optional<Residuals>>& all) {
  if (!session.is_touch() || folds.empty()) return;
  std::vector<int> fold_at(session.observations.size(), -1);
  for (std::size_t rank = 0; rank < images.observations.size(); ++rank)
    fold_at[static_cast<std::size_t>(images.observations[rank].index)] = folds[rank];
  for (int fold = 0; fold <= *std::max_element(folds.begin(), folds.end()); ++fold) {
    std::vector<char> trains(fold_at.size());
    for (std::size_t i = 0; i < trains.size(); ++i) trains[i] = fold_at[i] >= 0 && fold_at[i] != fold;
    const LackingTouches lacking = count_lacking(session, trains);
    for (std::size_t rank = 0; rank < images.observations.size(); ++rank) {
      const Observation& o = session.observations[static_cast<std::size_t>(images.observations[rank].index)];
      const bool is_untold = lacking.numbers_of_tip > 0 || lacking.of_fixture[static_cast<std::size_t>(o.part)] > 0;
      if (folds[rank] == fold && is_untold) all[rank].reset();
    }
  }
}

std::vector<std::optional<Residuals>> held_out(const Session& session, const Problem& images, const Fit& fit,
                                               const FitOptions& options) {
  std::vector<int> folds;
  for (const int first : first_of_same_pose(images)) folds.push_back(fold_of(first));
  auto all = held_out_residuals(images, fit, options, session.observations.size(), folds);
  take_out_untold(session, images, folds, all);
  return all;
}

/// Where the points of the images were fitted: the images, moved by the same effects. Else they are the fit's problem.
std::optional<Problem> images_of_points(const Session& session, const Fit& fit) {
  if (fit.objective != Objective::camera || !session.rig) return std::nullopt;
  Problem images = make_problem(session, make_chain(session), fit.problem.terms);
  images.copy_slip_frames(fit.problem);
  images.columns_of_effects = fit.problem.columns_of_effects;
  if (!images.terms.empty()) place_observations(images);
  return images;
}

std::optional<double> rms_of_noise(const std::vector<Residuals>& all, std::optional<double> noise) {
  double squares = 0, count = 0;
  for (const Residuals& r : all) {
    squares += r.length_squares_of_noise;
    count += static_cast<double>(r.lengths.size());
  }
  if (count == 0 || !noise) return std::nullopt;
  return *noise * std::sqrt(squares / count);
}

std::optional<double> noise_of_hand(const std::vector<Residuals>& all, std::optional<double> noise) {
  double squares = 0, count = 0;
  for (const Residuals& r : all) {
    if (!r.hand) continue;
    squares += r.hand->unit_covariance.trace();
    ++count;
  }
  if (count == 0 || !noise) return std::nullopt;
  return *noise * std::sqrt(squares / count);
}

/// An observation stands out when it is beyond what noise allows, and beyond the spread of the others too: where an
/// effect is missing all of them are large, each by another amount, and none of them is to blame. The spread is that of
/// the logarithm of the mean square (median and median deviation), which for noise alone is about chi-squared's own.
std::vector<char> outliers(const std::vector<Residuals>& all, std::optional<double> noise) {
  constexpr double spreads = 4;
  std::vector<double> logs;
  for (const Residuals& r : all)
    if (r.rows > 0 && r.squares > 0) logs.push_back(std::log(r.squares / r.rows));
  std::vector<char> out(all.size(), 0);
  if (logs.size() < 5) return out;
  const double middle = median(logs);
  std::vector<double> deviations;
  for (const double l : logs) deviations.push_back(std::abs(l - middle));
  const double spread = std::max(1.4826 * median(deviations), 0.2);
  const double variance = std::max(std::exp(middle), noise.value_or(0) * noise.value_or(0));
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].rows == 0 || !(all[i].squares > 0)) continue;
    const bool beyond_others = std::log(all[i].squares / all[i].rows) > middle + spreads * spread;
    out[i] = beyond_others && chi_squared_tail(all[i].squares / variance, all[i].rows) < 1e-4;
  }
  return out;
}

double mean_square(const Residuals& r) { return r.rows > 0 ? r.squares / r.rows : 0.0; }

std::vector<double> mean_squares_of(const std::vector<Residuals>& all) {
  std::vector<double> squares;
  for (const Residuals& r : all) squares.push_back(mean_square(r));
  return squares;
}

/// Of each used observation of another session.
std::vector<Residuals> residuals_on(const Session& others, const Fit& fit) {
  Problem images = make_problem(others, make_chain(others), fit.problem.terms);
  images.copy_slip_frames(fit.problem);
  if (!images.terms.empty()) place_observations(images);
  std::vector<Residuals> all;
  for (const ProblemObservation& o : images.observations) all.push_back(compute_residuals(images, o, estimate(fit)));
  return all;
}

std::vector<Unused> unused(const Session& session) {
  std::vector<Unused> list;
  const char* const shows_nothing = session.target || session.pose_sensor ? "its target was not found"
                                    : session.is_tracker()                ? "no marker was measured"
                                                                          : "no marker is labelled";
  for (const Observation& o : session.observations) {
    if (is_used(o)) continue;
    const Message why = o.reason.empty() ? "no reason given" : o.reason;
    Message reason = shows_nothing;
    if (o.decision == Decision::rejected) reason = message("rejected: {}", why);
    if (o.decision == Decision::excluded) reason = message("excluded: {}", why);
    list.push_back({o.id, reason});
  }
  return list;
}

/// 0 for the points of tags that are found to lie elsewhere than described, 1 for all others.
Eigen::VectorXd not_displaced(const Target& target, const std::vector<EffectTerm>& terms) {
  Eigen::VectorXd firm = Eigen::VectorXd::Ones(point_count(target));
  for (const EffectTerm& term : terms)
    for (std::size_t k = 0; term.id == "tag_placement" && k < target.ids.size(); ++k)
      if (target.ids[k] == term.place) firm.segment<4>(4 * static_cast<Eigen::Index>(k)).setZero();
  return firm;
}

}  // namespace

std::optional<Rigid> tcp_from_target(const Session& session, const Fit& fit) {
  if (!session.target || !session.shape || session.shape->piece_count() != 1) return std::nullopt;
  std::vector<Vector3> own = session.shape->markers;
  if (fit.problem.observations.empty()) return std::nullopt;
  // A target of another size or shape than described has it in every observation; its frame grows with it.
  const std::vector<Vector3> in_tcp = markers_at(fit.problem.observations.front(), estimate(fit));
  double scale = 1;
  for (const EffectTerm& term : fit.problem.terms)
    if (term.id == "target_scale") scale += term.values.front();
  for (Vector3& x : own) x *= scale;
  const auto count = static_cast<Eigen::Index>(own.size());
  if (count < 3 || in_tcp.size() != own.size()) return std::nullopt;
  Eigen::VectorXd weights(count);
  for (Eigen::Index m = 0; m < count; ++m) weights[m] = fit.problem.marker_is_seen[static_cast<std::size_t>(m)] ? 1 : 0;
  const Eigen::VectorXd firm = weights.cwiseProduct(not_displaced(*session.target, fit.problem.terms));
  if (firm.sum() >= 3) weights = firm;
  if (weights.sum() < 3) return std::nullopt;
  return align_points(Eigen::Map<const Eigen::Matrix3Xd>(in_tcp[0].data(), 3, count),
                      Eigen::Map<const Eigen::Matrix3Xd>(own[0].data(), 3, count), weights);
}

std::optional<TcpDeviation> tcp_deviation(const Problem& images, const ProblemObservation& o,
                                          const Unknowns& unknowns) {
  // With the markers in the TCP frame standing for the body, sensor_from_body is sensor_from_tcp_est.
  const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
  const auto pose = estimate_body_pose(images.rig_or_null(), o.sightings, markers_at(o, unknowns), sensor_from_tcp);
  if (!pose) return std::nullopt;
  // exp(xi) sensor_from_tcp_est, brought to the TCP frame: the motion about the sensor's origin there, then at the
  // TCP's.
  const Matrix6 to_tcp = adjoint(inverse(sensor_from_tcp));
  return TcpDeviation{inverse(sensor_from_tcp) * pose->sensor_from_body,
                      to_tcp * pose->unit_covariance * to_tcp.transpose()};
}

ErrorSummary error_on(const Session& others, const Fit& fit) {
  const std::vector<Residuals> all = residuals_on(others, fit);
  return all.empty() ? ErrorSummary{} : summary(all, others.rig.has_value());
}

std::vector<double> mean_squares_on(const Session& others, const Fit& fit) {
  return mean_squares_of(residuals_on(others, fit));
}

std::vector<double> mean_squares(const Fit& fit) {
  std::vector<double> squares;
  for (const ProblemObservation& o : fit.problem.observations)
    squares.push_back(mean_square(compute_residuals(fit.problem, o, estimate(fit))));
  return squares;
}

std::vector<double> held_out_in_blocks(const Session& session, const Fit& fit, const FitOptions& options, int blocks) {
  const Problem& images = fit.problem;
  std::vector<int> folds;
  for (std::size_t rank = 0; rank < images.observations.size(); ++rank)
    folds.push_back(static_cast<int>(rank * static_cast<std::size_t>(blocks) / images.observations.size()));
  return mean_squares_of(
      assess_knowledge(held_out_residuals(images, fit, options, session.observations.size(), folds)));
}

ErrorSummary held_out_by_region(const Session& session, const Fit& fit, const FitOptions& options) {
  const std::optional<Problem> of_session = images_of_points(session, fit);
  const Problem& images = of_session ? *of_session : fit.problem;
  const std::vector<int> regions = list_regions(images);
  FitOptions quick = options;  // to a hundredth of what a residual shows
  quick.least_gain = std::max(options.least_gain, 1e-2 * fit.residual_rms * fit.residual_rms);
  quick.reuse_below = std::max(options.reuse_below, 1e-3);
  quick.most_iterations = std::min(options.most_iterations, 40);
  auto held = held_out_residuals(images, fit, quick, session.observations.size(), regions);
  take_out_untold(session, images, regions, held);
  return read_summary(held, images.rig.has_value());
}

std::optional<HandResidual> hand_residual(const Problem& images, const ProblemObservation& o, const Unknowns& u) {
  return compute_residuals(images, o, u).hand;
}

FitReport report(const Session& session, const Fit& fit, const FitOptions& options) {
  const std::optional<Problem> of_session = images_of_points(session, fit);
  const Problem& images = of_session ? *of_session : fit.problem;
  FitReport r;
  r.observations = static_cast<int>(session.observations.size());
  r.used = static_cast<int>(images.observations.size());
  r.rejected = unused(session);
  std::vector<Residuals> all;
  for (const ProblemObservation& o : images.observations) all.push_back(compute_residuals(images, o, estimate(fit)));
  r.fitted = summary(all, images.rig.has_value());
  r.rms_of_noise_m = rms_of_noise(all, fit.noise);
  r.noise_of_hand_m = noise_of_hand(all, fit.noise);
  auto held = held_out(session, images, fit, options);
  r.held_out = read_summary(held, images.rig.has_value());
  if (!session.parts.empty()) r.held_out_residuals = std::move(held);
  const std::vector<char> out = outliers(all, fit.noise);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ProblemObservation& o = images.observations[i];
    ObservationReport one;
    one.id = session.observations[static_cast<std::size_t>(o.index)].id;
    one.index = o.index;
    if (images.rig && all[i].rows > 0) one.rms_pixel = std::sqrt(all[i].squares / all[i].rows);
    if (!all[i].lengths.empty()) one.rms_m = rms(all[i].lengths);
    one.deviation = tcp_deviation(images, o, estimate(fit));
    one.outlier = out[i] != 0;
    r.per_observation.push_back(one);
  }
  return r;
}

}  // namespace handsight
