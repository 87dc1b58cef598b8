// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/touch_unknown.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "base/error.h"
#include "chain/unknown_angle.h"
#include "estimation/fit/fit_covariance.h"
#include "estimation/fit/touch_counts.h"
#include "estimation/fit/undetermined.h"
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

/// -1: its place is held.
Eigen::Index column_of_fixture(const Session& session, const Fit& fit, std::size_t f) {
  return fit.problem.column_of_mount(part_of_fixture(session, static_cast<int>(f)).mount);
}

/// The columns that mean something: of each fixture's small motion only its numbers.
std::vector<Eigen::Index> list_meaningful(const Session& session, const Fit& fit) {
  std::vector<char> means(static_cast<std::size_t>(fit.solution.basis.rows()), 1);
  for (std::size_t f = 0; f < session.fixtures.size(); ++f) {
    const Eigen::Index column = column_of_fixture(session, fit, f);
    if (column < 0) continue;
    for (Eigen::Index n = 0; n < 6; ++n) means[static_cast<std::size_t>(column + n)] = 0;
    for (const Eigen::Index n : list_numbers(*session.fixtures[f].kind))
      means[static_cast<std::size_t>(column + n)] = 1;
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

/// Does one of these directions move what means something of the fixture's place?
bool moves_fixture(const Session& session, const Fit& fit, std::size_t f, const Eigen::MatrixXd& untold) {
  const Eigen::Index column = column_of_fixture(session, fit, f);
  if (column < 0) return false;
  Eigen::MatrixXd rows(0, untold.cols());
  for (const Eigen::Index n : list_numbers(*session.fixtures[f].kind)) {
    rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
    rows.bottomRows<1>() = untold.row(column + n);
  }
  return moved_numbers(rows) > 0;
}

std::vector<std::string> names_of_undetermined(const Session& session, const Fit& fit, const Eigen::MatrixXd& untold) {
  std::vector<std::string> names;
  for (std::size_t f = 0; f < session.fixtures.size(); ++f)
    if (moves_fixture(session, fit, f, untold)) names.push_back(session.fixtures[f].id);
  return names;
}

int moved_tip_numbers(const Fit& fit, const Eigen::MatrixXd& untold) {
  return moved_numbers(untold.topRows(3 * fit.problem.marker_count));
}

/// Joints whose zero another place of tip and fixtures does as well: beyond them it moves no more than turned errors.
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
  const NormalEquations equations = normal_equations(problem, u);
  Eigen::MatrixXd information = equations.information;
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
    // Turned by 1 rad, an error moves by its own length.
    if (all - by_others(i, i) <= std::max(least_share * all, equations.data_cost()))
      names.push_back(chain.robot.joints[static_cast<std::size_t>(zeros[static_cast<std::size_t>(i)].place)].name);
  }
  return names;
}

/// What one fixture alone does not tell, where it is the only one of its kind that is touched and there is no other
/// kind.
std::optional<Message> told_by_one_alone(const Session& session) {
  const FixtureKind& kind = *session.fixtures.front().kind;
  int touched = 0;
  for (std::size_t f = 0; f < session.fixtures.size(); ++f)
    touched += std::any_of(session.observations.begin(), session.observations.end(),
                           [&](const Observation& o) { return is_used(o) && o.part == static_cast<int>(f); });
  const bool are_alike =
      std::all_of(session.fixtures.begin(), session.fixtures.end(), [&](const Fixture& f) { return f.kind == &kind; });
  return are_alike && touched == 1 && kind.alone ? std::optional(kind.alone()) : std::nullopt;
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

std::vector<char> undetermined_fixtures(const Session& session, const Fit& fit) {
  std::vector<char> are(session.fixtures.size(), 0);
  if (are.empty()) return are;
  const Eigen::MatrixXd untold = undetermined_directions(session, fit);
  for (std::size_t f = 0; f < are.size(); ++f) are[f] = moves_fixture(session, fit, f, untold);
  return are;
}

void add_undetermined_columns_of_touches(const Session& session, const Fit& fit, Eigen::MatrixXd& factor) {
  const Eigen::MatrixXd untold = undetermined_directions(session, fit);
  factor.conservativeResize(Eigen::NoChange, factor.cols() + untold.cols());
  factor.rightCols(untold.cols()) = unknown_length * untold;
}

bool is_left_at_prior(const Session& session, const Fit& fit, std::size_t term, std::size_t parameter) {
  constexpr double untold = 0.9;  // of the prior's sigma
  if (!session.is_touch()) return false;
  for (const EffectColumn& c : fit.problem.columns_of_effects)
    if (c.term == term && c.parameter == parameter)
      return fit.effects[term].sigmas[parameter] > untold * c.prior_sigma();
  return false;
}

std::vector<Message> unknown_texts(const Session& session, const Fit& fit) {
  return session.is_touch() ? touch_unknown_texts(session, fit) : undetermined_texts(fit);
}

void require_determined(const Session& session, const Fit& fit) {
  if (fit.converged() && !session.is_touch()) return;
  const Eigen::MatrixXd untold = undetermined_directions(session, fit);
  const int tip = moved_tip_numbers(fit, untold);
  // Where one number of a tip is open, it is known to lie on a line: that is worth an answer.
  const int most_open = fit.converged() ? fit.problem.marker_count : 0;
  if (tip <= most_open) return;
  const auto lacking = touches_lacking_text(session);
  throw InputError(
      message("{}: {} touches do not determine where the tip sits on the hand ({} of its {} numbers), and so no place "
              "of a fixture. {}",
              session.file.filename().string(), fit.problem.observations.size(), tip, 3 * fit.problem.marker_count,
              lacking ? *lacking
                      : Message("Touch the same fixtures more often, with the hand turned about more than one axis.")));
}

std::vector<Message> touch_unknown_texts(const Session& session, const Fit& fit) {
  std::vector<Message> texts;
  const Eigen::MatrixXd untold = undetermined_directions(session, fit);
  const int tip = moved_tip_numbers(fit, untold);
  if (tip > 0)
    texts.push_back(
        message("Where the tip sits on the hand is not determined in {} of its {} numbers: turn the hand about more "
                "than one axis while it touches.",
                tip, 3 * fit.problem.marker_count));
  if (const auto names = names_of_undetermined(session, fit, untold); !names.empty())
    texts.push_back(
        message("Where {} stands is not determined by these touches; touch it more often, farther apart and with "
                "the hand turned.",
                joined(verbatim(names), ", ", " and ")));
  const auto lacking = texts.empty() ? std::optional<Message>() : touches_lacking_text(session);
  if (lacking) texts.push_back(*lacking);
  if (const auto names = hidden_zeros(session, fit); !names.empty())
    texts.push_back(message(
        "The zero of {} cannot be known from these touches: another one does what another place of the tip or of the "
        "fixtures does.",
        joined(verbatim(names), ", ", " and ")));
  if (is_accuracy_unknown(fit))
    texts.emplace_back(
        "As many numbers were read as are asked for: how exact they are cannot be known. Touch more, or say how "
        "exactly "
        "a touch tells (sigma).");
  if (auto alone = told_by_one_alone(session)) texts.push_back(std::move(*alone));
  return texts;
}

}  // namespace handsight
