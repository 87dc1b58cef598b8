// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/touch_unknown.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "estimation/solvers/inverse_parts.h"
#include "estimation/solvers/least_squares.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {
namespace {

constexpr double moves = 1e-3;  // of a unit direction: less is rounding

/// How many of these numbers the directions move independently.
int moved_numbers(const Eigen::MatrixXd& rows) {
  if (rows.cols() == 0) return 0;
  return static_cast<int>((Eigen::JacobiSVD<Eigen::MatrixXd>(rows).singularValues().array() > moves).count());
}

/// The numbers of a fixture's small motion that mean something.
std::vector<Eigen::Index> list_numbers(FixtureKind kind) {
  switch (kind) {
    case FixtureKind::plane:
    case FixtureKind::gauge:
      return {2, 3, 4};
    case FixtureKind::line:
      return {0, 1, 3, 4};
    case FixtureKind::point:
    case FixtureKind::length:
      return {0, 1, 2};
  }
  return {};
}

/// The columns that mean something: of each fixture's small motion only its numbers.
std::vector<Eigen::Index> list_meaningful(const Session& session, const Fit& fit) {
  std::vector<char> means(static_cast<std::size_t>(fit.solution.basis.rows()), 1);
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Eigen::Index column = fit.problem.column_of_mount(static_cast<int>(f));
    if (column < 0) continue;
    for (Eigen::Index n = 0; n < 6; ++n) means[static_cast<std::size_t>(column + n)] = 0;
    for (const Eigen::Index n : list_numbers(session.fixtures[f].kind)) means[static_cast<std::size_t>(column + n)] = 1;
  }
  std::vector<Eigen::Index> columns;
  for (std::size_t i = 0; i < means.size(); ++i)
    if (means[i]) columns.push_back(static_cast<Eigen::Index>(i));
  return columns;
}

/// Directions of the unknowns that no touch tells, orthonormal. What means nothing (a plane's turn about its normal) is
/// left out first: its rounding, scaled up, would hide the rest.
Eigen::MatrixXd undetermined_directions(const Session& session, const Fit& fit) {
  const Solution& s = fit.solution;
  const Eigen::Index rows = s.basis.rows();
  if (s.unobservable == 0) return Eigen::MatrixXd(rows, 0);
  const std::vector<Eigen::Index> felt = list_meaningful(session, fit);
  const Eigen::MatrixXd within = s.basis * s.basis.transpose();
  const Eigen::MatrixXd information = within * s.normal.information * within;
  const InverseParts parts = inverse_parts(information(felt, felt));
  std::vector<Eigen::Index> none;
  for (Eigen::Index i = 0; i < parts.inverse.size(); ++i)
    if (!(parts.inverse[i] > 0) && !parts.half.col(i).isZero(0)) none.push_back(i);
  if (none.empty()) return Eigen::MatrixXd(rows, 0);
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(none.size()));
  directions(felt, Eigen::all) = parts.half(Eigen::all, none);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(directions);
  return qr.householderQ() * Eigen::MatrixXd::Identity(rows, qr.rank());
}

std::vector<std::string> undetermined_fixtures(const Session& session, const Fit& fit, const Eigen::MatrixXd& untold) {
  std::vector<std::string> names;
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Eigen::Index column = fit.problem.column_of_mount(static_cast<int>(f));
    if (column < 0) continue;
    Eigen::MatrixXd rows(0, untold.cols());
    for (const Eigen::Index n : list_numbers(session.fixtures[f].kind)) {
      rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
      rows.bottomRows<1>() = untold.row(column + n);
    }
    if (moved_numbers(rows) > 0) names.push_back(session.fixtures[f].id);
  }
  return names;
}

/// Joints whose zero another place of tip and fixtures does as well.
std::vector<std::string> hidden_zeros(const Session& session, const Fit& fit) {
  constexpr double least_share = 1e-6;  // of what a zero does that is not also done by the others
  const Effect& zero = *find_effect("joint_offset");
  const Chain& chain = fit.problem.source->chain;
  std::vector<EffectTerm> zeros;
  for (const int joint : effect_places(zero, chain)) zeros.push_back(term_of(zero, joint));
  if (zeros.empty()) return {};
  Problem problem = make_problem(session, chain, list_terms(fit), zeros);
  problem.noise = fit.problem.noise;
  problem.robot_scale.reset();
  Unknowns u = estimate(fit);
  u.effects = Eigen::VectorXd::Zero(problem.effect_count());
  Eigen::MatrixXd information = normal_equations(problem, u).information;
  const Eigen::Index first = problem.effect_column(), count = problem.effect_count();
  for (Eigen::Index i = 0; i < count; ++i)
    information(first + i, first + i) -=
        std::pow(problem.noise / problem.columns_of_effects[static_cast<std::size_t>(i)].prior_sigma(), 2);
  const Eigen::MatrixXd across = information.block(0, first, first, count);
  const Eigen::MatrixXd by_others =
      across.transpose() * pseudo_inverse(information.topLeftCorner(first, first)) * across;
  std::vector<std::string> names;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double all = information(first + i, first + i);
    if (all - by_others(i, i) <= least_share * std::max(all, 1e-300))
      names.push_back(chain.robot.joints[static_cast<std::size_t>(zeros[static_cast<std::size_t>(i)].place)].name);
  }
  return names;
}

bool is_one_plane(const Session& session) {
  int touched = 0;
  for (std::size_t f = 0; f < session.fixtures.size(); ++f)
    touched += std::any_of(session.observations.begin(), session.observations.end(),
                           [&](const Observation& o) { return is_used(o) && o.part == static_cast<int>(f); });
  const bool all_planes = std::all_of(session.fixtures.begin(), session.fixtures.end(),
                                      [](const Fixture& f) { return f.kind == FixtureKind::plane; });
  return all_planes && touched == 1;
}

}  // namespace

std::array<bool, 3> undetermined_tip(const Session& session, const Fit& fit) {
  std::array<bool, 3> is_untold{};
  if (session.fixtures.empty() || fit.problem.marker_count != 1) return is_untold;
  const Eigen::MatrixXd untold = undetermined_directions(session, fit);
  for (Eigen::Index i = 0; i < 3; ++i)
    is_untold[static_cast<std::size_t>(i)] = untold.cols() > 0 && untold.row(i).norm() > moves;
  return is_untold;
}

std::vector<Message> touch_unknown_texts(const Session& session, const Fit& fit) {
  std::vector<Message> texts;
  const Eigen::MatrixXd untold = undetermined_directions(session, fit);
  const int tip = moved_numbers(untold.topRows(3 * fit.problem.marker_count));
  if (tip > 0)
    texts.push_back(
        message("Where the tip sits on the hand is not determined in {} of its {} numbers: turn the hand about more "
                "than one axis while it touches.",
                tip, 3 * fit.problem.marker_count));
  if (const auto names = undetermined_fixtures(session, fit, untold); !names.empty())
    texts.push_back(
        message("Where {} stands is not determined by these touches; touch it more often, farther apart and with "
                "the hand turned.",
                joined(verbatim(names), ", ", " and ")));
  if (const auto names = hidden_zeros(session, fit); !names.empty())
    texts.push_back(message(
        "The zero of {} cannot be known from these touches: another one does what another place of the tip or of the "
        "fixtures does.",
        joined(verbatim(names), ", ", " and ")));
  if (is_one_plane(session))
    texts.emplace_back(
        "One plane alone tells only what lifts the tip off it, and nothing along it; put the plate in two more places, "
        "tilted against the first, or add a socket.");
  return texts;
}

}  // namespace handsight
