// SPDX-License-Identifier: Apache-2.0
#include "compare/change_evidence.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "diagnosis/evidence/evidence.h"

namespace handsight {
namespace {

constexpr int draws = 400;
constexpr double chance = 0.005, tail_share = 0.1;
constexpr double least_odds = 6;  // ln: the sizes of what the model lacks are only known so well

/// Extrapolated from the tail, which falls off exponentially.
double rare_value(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto tail = static_cast<std::size_t>(static_cast<double>(values.size()) * (1 - tail_share));
  double excess = 0;
  for (std::size_t i = tail; i < values.size(); ++i)
    excess += (values[i] - values[tail]) / static_cast<double>(values.size() - tail);
  return values[tail] + excess * std::log(tail_share / chance);
}

double best_of_groups(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient,
                      const std::vector<ChangePlace>& places) {
  std::map<std::string, std::vector<double>> factors;
  for (const ChangePlace& p : places)
    factors[p.group].push_back(
        change_evidence(information.block(p.first, p.first, p.count, p.count), gradient.segment(p.first, p.count)));
  double best = 0;
  for (const auto& [group, all] : factors) best = std::max(best, ln_mean_exp(all));
  return best;
}

/// R with R R^T the matrix. Of a large one by Cholesky's, which takes a fraction of the time.
Eigen::MatrixXd require_root(Eigen::MatrixXd symmetric) {
  constexpr Eigen::Index large = 300;
  if (symmetric.rows() > large) {
    symmetric.diagonal() *= 1 + 1e-9;
    symmetric.diagonal().array() += 1e-9;
    const Eigen::LLT<Eigen::MatrixXd> llt(symmetric);
    if (llt.info() == Eigen::Success) return llt.matrixL();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

}  // namespace

double change_evidence(const Eigen::Ref<const Eigen::MatrixXd>& information,
                       const Eigen::Ref<const Eigen::VectorXd>& gradient) {
  std::array<double, prior_scales.size()> factors{};
  // Asked for very often, mostly of one number: memory is taken once, of one number not at all.
  if (gradient.size() == 1) {
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const double squared = prior_scales[i] * prior_scales[i], m = 1 + squared * information(0, 0);
      factors[i] = 0.5 * (squared * gradient[0] * gradient[0] / m - std::log(m));
    }
    return ln_over_scales(factors);
  }
  Eigen::LLT<Eigen::MatrixXd> llt(gradient.size());
  Eigen::MatrixXd m;
  Eigen::VectorXd answer;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const double squared = prior_scales[i] * prior_scales[i];
    m = squared * information;
    m.diagonal().array() += 1;
    llt.compute(m);
    answer = gradient;
    llt.matrixL().solveInPlace(answer);
    factors[i] = 0.5 * squared * answer.squaredNorm() - llt.matrixLLT().diagonal().array().log().sum();
  }
  return ln_over_scales(factors);
}

double change_evidence_at(const Eigen::MatrixXd& information, const Eigen::VectorXd& values, double gained) {
  std::vector<double> factors;
  for (const double s : prior_scales) {
    Eigen::MatrixXd m = s * s * information;
    m.diagonal().array() += 1;
    factors.push_back(0.5 * (gained - values.squaredNorm() / (s * s)) -
                      0.5 * m.ldlt().vectorD().cwiseMax(1e-300).array().log().sum());
  }
  return ln_over_scales(factors);
}

double change_threshold(const Eigen::MatrixXd& information, const std::vector<ChangePlace>& places) {
  const Eigen::MatrixXd root = require_root(0.5 * (information + information.transpose()));
  std::mt19937_64 random(20261122);
  std::normal_distribution<double> normal;
  std::vector<double> largest;
  for (int draw = 0; draw < draws; ++draw) {
    Eigen::VectorXd z(root.cols());
    for (double& x : z) x = normal(random);
    largest.push_back(best_of_groups(information, root * z, places));
  }
  return std::max(least_odds, rare_value(std::move(largest)));
}

}  // namespace handsight
