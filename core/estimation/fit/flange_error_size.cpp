// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/flange_error_size.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/shown_number.h"
#include "estimation/problem/column_products.h"
#include "estimation/problem/problem_part.h"
#include "estimation/solvers/flange_error.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {
namespace {

constexpr double clearly_likelier = 3;                             // ln: than noise alone
constexpr double least = 1e-6, most_place = 0.1, most_turn = 0.3;  // m and rad

/// What is off by more is no scatter of a robot's: something is missing that weighing would only hide.
constexpr FlangeError most_of_a_robot{6e-3, 18e-3};

/// Sizes are known to a few hundredths from that many observations, and a weight need not be known better.
constexpr std::size_t enough = 150;

/// One observation by the unknowns of the fit and by the motion of the TCP.
struct Part {
  FlangeSums sums;  // shared: unknowns x 6
  FlangeErrorShares shares;
};

class RestrictedLikelihood {
 public:
  RestrictedLikelihood(const Problem& problem, const Solution& solution) : noise_(problem.noise) {
    const Eigen::MatrixXd& basis = solution.basis;
    const NormalEquations priors = normal_equations(without_observations(problem), solution.unknowns);
    information_ = basis.transpose() * priors.information * basis;
    gradient_ = basis.transpose() * priors.gradient;
    cost_ = priors.cost;
    for (const ProblemObservation& o : problem.observations) {
      NormalEquations one(problem.columns());
      add_observation(problem, o, solution.unknowns, one);
      complete(one);
      FlangeSums sums = flange_sums(problem, o, solution.unknowns, one);
      sums.shared = basis.transpose() * sums.shared;
      parts_.push_back({std::move(sums), flange_error_shares(problem, o)});
      information_ += basis.transpose() * one.information * basis;
      gradient_ += basis.transpose() * one.gradient;
      cost_ += one.cost;
    }
  }

  double ln(const FlangeError& error) const {
    Eigen::VectorXd gradient = gradient_;
    double cost = cost_, ln_volume = 0;
    Eigen::MatrixXd taken = Eigen::MatrixXd::Zero(information_.rows(), information_.cols());
    GatheredRows rows(taken);
    for (const Part& p : parts_) {
      if (!error.is_any()) break;
      FlangeSums sums = along(p.sums, root_of_covariance(make_covariance(p.shares, error)) / noise_);
      sums.own.diagonal().array() += 1;
      const Eigen::LLT<Matrix6> llt(sums.own);
      const Vector6 best = llt.solve(sums.gradient);
      rows.add(llt.matrixL().solve(sums.shared.transpose()));
      gradient -= sums.shared * best;
      cost -= sums.gradient.dot(best);
      ln_volume += 2 * llt.matrixLLT().diagonal().array().log().sum();
    }
    rows.settle();
    // What is not observable in these poses is so under every size of the error.
    Eigen::MatrixXd information = information_ - taken;
    for (Eigen::Index i = 0; i < information.cols(); ++i) information(i, i) += 1e-10 * information_(i, i) + 1e-300;
    const Eigen::LLT<Eigen::MatrixXd> llt(information);
    const double squares = cost - gradient.dot(llt.solve(gradient));
    return -0.5 * ln_volume - llt.matrixLLT().diagonal().array().abs().log().sum() - 0.5 * squares / (noise_ * noise_);
  }

 private:
  double noise_;
  std::vector<Part> parts_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
  double cost_ = 0;
};

struct Found {
  FlangeError error;
  double ln = -1e300;
};

void take_better(const RestrictedLikelihood& likelihood, const FlangeError& error, Found& best) {
  const double ln = likelihood.ln(error);
  if (ln > best.ln) best = {error, ln};
}

Found best_of_grid(const RestrictedLikelihood& likelihood) {
  constexpr std::array<double, 8> sizes{0, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};
  Found best;
  for (const double place : sizes)
    for (const double turn : sizes) take_better(likelihood, {place, turn}, best);
  return best;
}

/// Steps of a factor along either size, ever smaller ones.
void refine(const RestrictedLikelihood& likelihood, Found& best) {
  constexpr double fine = 1.02;
  for (double factor = 1.8; factor > fine;) {
    const Found before = best;
    const auto [place, turn] = before.error;
    for (const double f : {factor, 1 / factor}) {
      take_better(likelihood, {std::clamp(place * f, least, most_place), turn}, best);
      take_better(likelihood, {place, std::clamp(turn * f, least, most_turn)}, best);
      take_better(likelihood, {std::clamp(place * f, least, most_place), std::clamp(turn * f, least, most_turn)}, best);
    }
    if (best.ln == before.ln) factor = std::sqrt(factor);
  }
}

/// Without what brings nothing, of a robot with joints.
void simplify(const RestrictedLikelihood& likelihood, Found& best) {
  constexpr double nothing = 1;  // ln
  for (const FlangeError& simpler : {FlangeError{0, best.error.turn}, FlangeError{best.error.place, 0}})
    if (likelihood.ln(simpler) > best.ln - nothing) {
      best.error = simpler;
      return;
    }
}

Problem thinned(const Problem& problem) {
  if (problem.observations.size() <= enough) return problem;
  Problem few = without_observations(problem);
  for (std::size_t i = 0; i < enough; ++i)
    few.observations.push_back(problem.observations[i * problem.observations.size() / enough]);
  return few;
}

}  // namespace

FlangeError likely_flange_error(const Problem& problem, const Solution& solution) {
  constexpr std::size_t fewest = 4;
  if (problem.observations.size() < fewest) return {};
  Problem few = thinned(problem);
  few.flange_error = {};
  const RestrictedLikelihood likelihood(few, solution);
  Found best = best_of_grid(likelihood);
  refine(likelihood, best);
  if (!problem.source->chain.robot.is_of_poses) simplify(likelihood, best);
  const bool is_a_robots = best.error.place <= most_of_a_robot.place && best.error.turn <= most_of_a_robot.turn;
  return is_a_robots && best.ln > likelihood.ln({}) + clearly_likelier ? best.error : FlangeError{};
}

Message flange_error_text(const FlangeError& e, bool has_joints) {
  const std::string place = shown_number(1e3 * e.place), turn = shown_number(1e3 * e.turn);
  const Message sizes = !has_joints    ? message("its flange by {} mm and {} mrad", place, turn)
                        : e.place == 0 ? message("its joints by {} mrad", turn)
                        : e.turn == 0  ? message("its flange by {} mm", place)
                                       : message("its joints by {} mrad and its flange by {} mm", turn, place);
  return message(
      "From pose to pose the robot is off by more than the noise of the images: {} (one standard deviation of each "
      "number). Images and robot are weighed by that.",
      sizes);
}

}  // namespace handsight
