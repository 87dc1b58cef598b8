// SPDX-License-Identifier: Apache-2.0
#include "estimation/fit/flange_error_size.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "estimation/solvers/flange_error.h"
#include "estimation/solvers/normal_equations.h"

namespace handsight {
namespace {

constexpr double clearly_likelier = 3;                             // ln: than noise alone
constexpr double least = 1e-6, most_place = 0.1, most_turn = 0.3;  // m and rad

/// What is off by more is no scatter of a robot's: something is missing that weighing would only hide.
constexpr FlangeError most_of_a_robot{6e-3, 18e-3};

/// One observation by the unknowns of the fit and by the flange's error.
struct Part {
  Eigen::MatrixXd information;                      // unknowns x unknowns
  Eigen::VectorXd gradient;                         // unknowns
  Eigen::Matrix<double, Eigen::Dynamic, 6> shared;  // unknowns x 6
  Matrix6 own;
  Vector6 own_gradient;
  double cost = 0;
};

Part part_of(const Problem& problem, const ProblemObservation& o, const Solution& solution) {
  NormalEquations one(problem.columns());
  add_observation(problem, o, solution.unknowns, one);
  complete(one);
  const FlangeSums sums = flange_sums(problem, o, solution.unknowns, one);
  const Eigen::MatrixXd& basis = solution.basis;
  return {basis.transpose() * one.information * basis,
          basis.transpose() * one.gradient,
          basis.transpose() * sums.shared,
          sums.own,
          sums.gradient,
          one.cost};
}

class RestrictedLikelihood {
 public:
  RestrictedLikelihood(const Problem& problem, const Solution& solution) : noise_(problem.noise) {
    for (const ProblemObservation& o : problem.observations) parts_.push_back(part_of(problem, o, solution));
    Problem unseen = problem;
    unseen.observations.clear();
    unseen.flange_error = {};
    const NormalEquations priors = normal_equations(unseen, solution.unknowns);
    priors_ = {solution.basis.transpose() * priors.information * solution.basis,
               solution.basis.transpose() * priors.gradient,
               {},
               Matrix6::Zero(),
               Vector6::Zero(),
               priors.cost};
  }

  double ln(const FlangeError& error) const {
    Eigen::MatrixXd information = priors_.information;
    Eigen::VectorXd gradient = priors_.gradient;
    double cost = priors_.cost, ln_volume = 0;
    const Vector6 weights = flange_error_weights(error, noise_);
    for (const Part& p : parts_) {
      information += p.information;
      gradient += p.gradient;
      cost += p.cost;
      if (!error.is_any()) continue;
      Matrix6 own = p.own;
      own.diagonal() += weights;
      const Eigen::LLT<Matrix6> llt(own);
      information -= p.shared * llt.solve(p.shared.transpose());
      const Vector6 best = llt.solve(p.own_gradient);
      gradient -= p.shared * best;
      cost -= p.own_gradient.dot(best);
      ln_volume += 2 * llt.matrixLLT().diagonal().array().log().sum() - weights.array().log().sum();
    }
    // What is not observable in these poses is so under every size of the error.
    for (Eigen::Index i = 0; i < information.cols(); ++i) information(i, i) += 1e-10 * information(i, i) + 1e-300;
    const Eigen::LLT<Eigen::MatrixXd> llt(information);
    const double squares = cost - gradient.dot(llt.solve(gradient));
    return -0.5 * ln_volume - llt.matrixLLT().diagonal().array().abs().log().sum() - 0.5 * squares / (noise_ * noise_);
  }

 private:
  double noise_;
  std::vector<Part> parts_;
  Part priors_;
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
  constexpr std::array<double, 8> places{0, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};
  constexpr std::array<double, 8> turns{0, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};
  Found best;
  for (const double place : places)
    for (const double turn : turns) take_better(likelihood, {place, turn}, best);
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

}  // namespace

FlangeError likely_flange_error(const Problem& problem, const Solution& solution) {
  constexpr std::size_t fewest = 4;
  if (problem.observations.size() < fewest) return {};
  const RestrictedLikelihood likelihood(problem, solution);
  Found best = best_of_grid(likelihood);
  refine(likelihood, best);
  const bool is_a_robots = best.error.place <= most_of_a_robot.place && best.error.turn <= most_of_a_robot.turn;
  return is_a_robots && best.ln > likelihood.ln({}) + clearly_likelier ? best.error : FlangeError{};
}

}  // namespace handsight
