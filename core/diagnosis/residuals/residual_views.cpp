// SPDX-License-Identifier: Apache-2.0
#include "diagnosis/residuals/residual_views.h"

#include <algorithm>
#include <random>

#include "base/error.h"
#include "diagnosis/evidence/candidates.h"
#include "diagnosis/evidence/observation_rows.h"
#include "diagnosis/outliers/snooping.h"
#include "estimation/report/fit_report.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {
namespace {

/// Calls `see(sighting, x in the sensor's frame, residual)` for everything that an observation shows.
template <class See>
void each_sighting(const Problem& problem, const ProblemObservation& o, const Unknowns& u, const Rigid& sensor_from_tcp,
                   const See& see) {
  for (const Sighting& s : o.sightings) {
    const Vector3 x = sensor_from_tcp * marker_at(o, u, s.marker);
    see(s, x, sighting_residual(problem.rig_or_null(), s, x));
  }
}

void add_corners(const Sighting& s, int place, const SightingColumn& error, std::vector<CornerResidual>& corners) {
  if (s.along || s.reading) return;  // of a pose or a reading: no point that is seen
  if (s.point) corners.push_back({place, s.marker, by_tracker, error.head<2>()});
  Eigen::Index row = 0;
  for (const CameraPoint& seen : s.in_cameras) {
    corners.push_back({place, s.marker, seen.camera, error.segment<2>(row)});
    row += 2;
  }
}

/// Changes of all corners by steps of the problem's columns (columns x steps): (2 corners) x steps.
Eigen::MatrixXd corner_changes(const Problem& p, const Unknowns& u, const Eigen::MatrixXd& steps, std::size_t corners) {
  Eigen::MatrixXd changes(static_cast<Eigen::Index>(2 * corners), steps.cols());
  Eigen::Index next = 0;
  for (const ProblemObservation& o : p.observations) {
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, u);
    const Eigen::Matrix<double, 6, Eigen::Dynamic> motion = motion_by_columns(p, o, u);
    each_sighting(p, o, u, sensor_from_tcp, [&](const Sighting& s, const Vector3& x, const SightingResidual& r) {
      const Eigen::MatrixXd change = by_columns(p, o, s, x, r, sensor_from_tcp.rotation, motion) * steps;
      const Eigen::Index rows = s.along || s.reading ? 0 : s.point ? 2 : r.rows;
      changes.middleRows(next, rows) = change.topRows(rows);
      next += rows;
    });
  }
  return changes.topRows(next);
}

int row_count(const Problem& problem, const Unknowns& unknowns) {
  int rows = 0;
  for (const ProblemObservation& o : problem.observations)
    each_sighting(problem, o, unknowns, sensor_from_tcp_at(o, unknowns),
                  [&](const Sighting&, const Vector3&, const SightingResidual& r) { rows += r.rows; });
  return rows;
}

/// Of a problem that stands where the model does.
ResidualViews views_of(Problem problem, const Fit& model, int rows) {
  ResidualViews v;
  v.problem = std::move(problem);
  v.unknowns = estimate(model);
  v.noise_model = noise_model(model);
  v.model = linear_model(v.problem, v.unknowns, v.problem.effect_count(), v.noise_model.noise);
  v.variables = list_variables(v.problem, v.unknowns);
  v.axes = residual_axes(v.problem, v.model);
  v.series = residual_series(v.problem, v.model);
  v.corners = corner_residuals(v.problem, v.unknowns);
  v.degrees = std::max(rows - model.unknowns, 1);
  v.fitted = static_cast<int>(model.problem.observations.size());
  return v;
}

}  // namespace

std::vector<ProblemObservation> evenly(std::vector<ProblemObservation> all, std::size_t most) {
  check(most >= 2, "a part of a session is two observations at least, not {}", most);
  if (all.size() <= most) return all;
  std::vector<ProblemObservation> part;
  part.reserve(most);
  for (std::size_t k = 0; k < most; ++k) part.push_back(std::move(all[k * (all.size() - 1) / (most - 1)]));
  return part;
}

std::vector<CornerResidual> corner_residuals(const Problem& problem, const Unknowns& unknowns) {
  std::vector<CornerResidual> corners;
  const Eigen::VectorXd change =
      problem.effect_count() > 0 ? Eigen::VectorXd(unknowns.effects - effect_values(problem)) : Eigen::VectorXd();
  for (std::size_t i = 0; i < problem.observations.size(); ++i) {
    const ProblemObservation& o = problem.observations[i];
    const Rigid sensor_from_tcp = sensor_from_tcp_at(o, unknowns);
    Eigen::Matrix<double, 6, Eigen::Dynamic> motion;
    if (change.size() > 0 && !change.isZero(0)) motion = motion_by_columns(problem, o, unknowns);
    each_sighting(
        problem, o, unknowns, sensor_from_tcp, [&](const Sighting& s, const Vector3& x, const SightingResidual& r) {
          SightingColumn error = r.error;
          if (motion.cols() > 0)
            error -=
                by_columns(problem, o, s, x, r, sensor_from_tcp.rotation, motion).rightCols(change.size()) * change;
          add_corners(s, static_cast<int>(i), error, corners);
        });
  }
  return corners;
}

ResidualViews residual_views(const Fit& model) { return views_of(with_motions(model.problem), model, model.rows); }

ResidualViews residual_views(const Fit& model, std::size_t most, std::size_t fitted) {
  const std::size_t held = model.problem.observations.size();
  if (held <= most && fitted <= held) return residual_views(model);
  Problem part = model.problem;
  part.observations = evenly(std::move(part.observations), most);
  const int rows = row_count(part, estimate(model));
  ResidualViews views = views_of(with_motions(part), model, rows);
  views.fitted = static_cast<int>(std::max(fitted, held));
  return views;
}

std::vector<Eigen::VectorXd> noise_alone(const ResidualViews& views, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd rows(views.model.external.rows());
  for (double& x : rows) x = normal(random);
  // What the model's own parameters would take up of it does not show.
  const WhitenedModel w = whiten(views.model, {}, views.noise_model.knowledge);
  const auto by_base = w.external.leftCols(views.model.base);
  rows -= by_base * w.base.solve(by_base.transpose() * rows);
  std::vector<Eigen::VectorXd> list;
  for (const ResidualAxis& axis : views.axes) list.push_back(seen_along(axis, views.model, rows));
  return list;
}

EffectView effect_view(const ResidualViews& views, const std::vector<EffectTerm>& terms) {
  const Candidates candidates = list_candidates(views.problem, terms);
  const Problem& problem = candidates.problem;
  const LinearModel model = linear_model(problem, views.unknowns, candidates.base_effects, views.noise_model.noise);
  const WhitenedModel w = whiten(model, {}, views.noise_model.knowledge);
  const Eigen::Index count = model.candidates();

  EffectView view;
  view.terms = terms;
  Eigen::VectorXd plausible(count);
  for (Eigen::Index c = 0; c < count; ++c) {
    const EffectColumn& column = problem.columns_of_effects[static_cast<std::size_t>(candidates.base_effects + c)];
    plausible[c] = column.sigma;
    view.numbers.push_back({column.term - (problem.terms.size() - terms.size()), column.parameter, column.sigma});
  }
  const Eigen::VectorXd per_unit = plausible.cwiseInverse();
  const Eigen::MatrixXd taken_up = w.base.matrixU().solve(w.shared);  // base x candidates
  const Eigen::MatrixXd rows =
      (w.external.rightCols(count) - w.external.leftCols(model.base) * taken_up) * per_unit.asDiagonal();
  for (const ResidualAxis& axis : views.axes) {
    Eigen::MatrixXd series(static_cast<Eigen::Index>(model.observations.size()), count);
    for (Eigen::Index c = 0; c < count; ++c) series.col(c) = seen_along(axis, model, rows.col(c));
    view.series.push_back(std::move(series));
  }

  Eigen::MatrixXd steps(problem.columns(), count);
  steps.topRows(model.base) = -taken_up * per_unit.asDiagonal();
  for (Eigen::Index c = 0; c < candidates.base_effects; ++c)
    steps.row(problem.effect_column() + c) *= problem.columns_of_effects[static_cast<std::size_t>(c)].sigma;
  steps.bottomRows(count).setIdentity();
  view.corners = corner_changes(problem, views.unknowns, steps, views.corners.size());

  const Score s = score(w, 0, count);
  const LinearEstimate e = linear_estimate(s, w, views.noise_model.knowledge);
  view.best = e.value.cwiseProduct(plausible);
  view.best_sigma = e.covariance.diagonal().cwiseMax(0).cwiseSqrt().cwiseProduct(plausible);
  view.information = per_unit.asDiagonal() * s.information * per_unit.asDiagonal();
  view.gradient = per_unit.cwiseProduct(s.gradient);
  view.squares = w.residual_squares;
  return view;
}

Eigen::VectorXd list_numbers(const EffectView& view, const std::vector<EffectTerm>& terms) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(view.numbers.size()));
  for (std::size_t i = 0; i < view.numbers.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = terms[view.numbers[i].term].values[view.numbers[i].parameter];
  return values;
}

double rms_left(const ResidualViews& views, const EffectView& view, const Eigen::VectorXd& numbers) {
  const double squares = view.squares - 2 * view.gradient.dot(numbers) + numbers.dot(view.information * numbers);
  return as_reported(views.noise_model.noise * std::sqrt(std::max(squares, 0.0) / views.degrees),
                     views.problem.rig.has_value());
}

}  // namespace handsight
